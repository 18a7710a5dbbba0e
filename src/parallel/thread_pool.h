#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace scatter::parallel {

/// How many threads can run at once, as far as the system tells: at least 1.
[[nodiscard]] int countCores();

/// Threads that wait for work. For work that comes every few milliseconds: they look for it for a moment
/// before they go to sleep.
class ThreadPool {
 public:
  /// `threads`, the caller's among them: at least 1.
  explicit ThreadPool(int threads);
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;
  ~ThreadPool();

  [[nodiscard]] int threads() const { return static_cast<int>(workers_.size()) + 1; }

  /// Calls `work(i)` once for every i from 0 to `count` - 1, on any thread and in any order, and returns when
  /// all have returned. From one thread at a time, and not from inside `work`, which must not throw.
  void run(int count, const std::function<void(int)>& work);

 private:
  void serve();
  [[nodiscard]] bool awaitRun(std::uint64_t seen);
  void takePart();

  std::vector<std::thread> workers_;
  std::mutex mutex_;
  std::condition_variable wakeUp_;
  std::atomic<std::uint64_t> run_ = 0;  ///< Counts the runs.
  std::atomic<bool> ends_ = false;
  std::atomic<int> next_ = 0;
  std::atomic<int> busy_ = 0;  ///< Workers that have not finished the run.
  int count_ = 0;
  const std::function<void(int)>* work_ = nullptr;
};

}  // namespace scatter::parallel
