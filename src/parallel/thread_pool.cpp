#include "parallel/thread_pool.h"

#include <algorithm>
#include <chrono>

#ifdef __linux__
#include <sched.h>
#endif

namespace scatter::parallel {

namespace {

/// To wake a thread takes some 50 microseconds; steps that are worth threads come more often than this apart
/// from each other inside a frame, and are far between from frame to frame.
constexpr std::chrono::microseconds kPatience{100};

}  // namespace

int countCores() {
#ifdef __linux__
  // A process may have been given fewer than there are.
  cpu_set_t cores;
  if (sched_getaffinity(0, sizeof cores, &cores) == 0) return std::max(CPU_COUNT(&cores), 1);
#endif
  return std::max(static_cast<int>(std::thread::hardware_concurrency()), 1);
}

ThreadPool::ThreadPool(int threads) : parts_(static_cast<std::size_t>(threads)) {
  for (std::size_t i = 1; i < parts_.size(); ++i) workers_.emplace_back([this, i] { serve(i); });
}

ThreadPool::~ThreadPool() {
  {
    const std::scoped_lock lock(mutex_);
    ends_ = true;
  }
  wakeUp_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void ThreadPool::run(int count, const std::function<void(int)>& work) {
  if (workers_.empty() || count < 2) {
    for (int i = 0; i < count; ++i) work(i);
    return;
  }
  {
    const std::scoped_lock lock(mutex_);
    work_ = &work;
    const auto parts = static_cast<int>(parts_.size());
    for (int i = 0; i < parts; ++i) {
      Part& part = parts_[static_cast<std::size_t>(i)];
      part.next = static_cast<int>(std::int64_t{count} * i / parts);
      part.end = static_cast<int>(std::int64_t{count} * (i + 1) / parts);
    }
    isOpen_ = true;
    ++run_;
  }
  wakeUp_.notify_all();
  takePart(0);
  {
    const std::scoped_lock lock(mutex_);
    isOpen_ = false;
  }
  while (joined_.load(std::memory_order_acquire) > 0) std::this_thread::yield();
}

bool ThreadPool::join() {
  const std::scoped_lock lock(mutex_);
  if (isOpen_) ++joined_;
  return isOpen_;
}

void ThreadPool::takePart(std::size_t self) {
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    Part& part = parts_[(self + k) % parts_.size()];
    for (int i = part.next++; i < part.end; i = part.next++) (*work_)(i);
  }
}

void ThreadPool::expectWork() {
  if (workers_.empty()) return;
  {
    const std::scoped_lock lock(mutex_);
    ++calls_;
  }
  wakeUp_.notify_all();
}

// False at the end of all.
bool ThreadPool::awaitRun(std::uint64_t seen) {
  while (run_ == seen && !ends_) {
    const std::uint64_t heard = calls_;
    const auto patient = std::chrono::steady_clock::now() + kPatience;
    while (run_ == seen && !ends_ && std::chrono::steady_clock::now() < patient) std::this_thread::yield();
    if (run_ != seen || ends_ || calls_ != heard) continue;
    std::unique_lock lock(mutex_);
    wakeUp_.wait(lock, [&] { return run_ != seen || ends_ || calls_ != heard; });
  }
  return !ends_;
}

// Runs that it has slept through are of no interest.
void ThreadPool::serve(std::size_t self) {
  std::uint64_t seen = 0;
  while (awaitRun(seen)) {
    seen = run_;
    if (!join()) continue;
    takePart(self);
    joined_.fetch_sub(1, std::memory_order_release);
  }
}

}  // namespace scatter::parallel
