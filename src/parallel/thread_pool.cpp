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

ThreadPool::ThreadPool(int threads) {
  for (int i = 1; i < threads; ++i) workers_.emplace_back([this] { serve(); });
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
    count_ = count;
    next_ = 0;
    busy_ = static_cast<int>(workers_.size());
    ++run_;
  }
  wakeUp_.notify_all();
  takePart();
  while (busy_.load(std::memory_order_acquire) > 0) std::this_thread::yield();
}

void ThreadPool::takePart() {
  for (int i = next_++; i < count_; i = next_++) (*work_)(i);
}

// False at the end of all.
bool ThreadPool::awaitRun(std::uint64_t seen) {
  const auto patient = std::chrono::steady_clock::now() + kPatience;
  while (run_ == seen && !ends_ && std::chrono::steady_clock::now() < patient) std::this_thread::yield();
  if (run_ == seen && !ends_) {
    std::unique_lock lock(mutex_);
    wakeUp_.wait(lock, [&] { return run_ != seen || ends_; });
  }
  return !ends_;
}

void ThreadPool::serve() {
  for (std::uint64_t seen = 0; awaitRun(seen); ++seen) {
    takePart();
    busy_.fetch_sub(1, std::memory_order_release);
  }
}

}  // namespace scatter::parallel
