#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
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
  /// all have returned. Each thread begins with the same part of them in every run, so that it finds in its
  /// cache what it has left there, and helps others when it is done. It does not wait for threads that are
  /// still asleep then. From one thread at a time, and not from inside `work`, which must not throw.
  void run(int count, const std::function<void(int)>& work);

  /// Work comes soon: threads that are asleep look for it again for a moment. From the same thread as run().
  void expectWork();

 private:
  /// Of a run, the numbers that a thread begins with. Apart in memory, as each thread counts in its own.
  struct alignas(64) Part {
    std::atomic<int> next = 0;
    int end = 0;
  };

  void serve(std::size_t self);
  [[nodiscard]] bool awaitRun(std::uint64_t seen);
  void takePart(std::size_t self);
  [[nodiscard]] bool join();

  std::vector<std::thread> workers_;
  std::mutex mutex_;
  std::condition_variable wakeUp_;
  std::atomic<std::uint64_t> run_ = 0;    ///< Counts the runs.
  std::atomic<std::uint64_t> calls_ = 0;  ///< Counts those of expectWork().
  std::atomic<bool> ends_ = false;
  std::vector<Part> parts_;      ///< The caller's, then the workers'.
  std::atomic<int> joined_ = 0;  ///< Workers that take part in the run.
  bool isOpen_ = false;          ///< The run may be joined.
  const std::function<void(int)>* work_ = nullptr;
};

}  // namespace scatter::parallel
