#include "parallel/thread_pool.h"

#include <gtest/gtest.h>

#include <chrono>
#include <numeric>
#include <set>

namespace scatter::parallel {
namespace {

TEST(ThreadPool, DoesEveryPieceOfWorkOnce) {
  for (const int threads : {1, 2, 3, 8}) {
    ThreadPool pool(threads);
    EXPECT_EQ(pool.threads(), threads);
    for (const int count : {0, 1, 2, 7, 1000}) {
      std::vector<int> done(static_cast<std::size_t>(count), 0);
      pool.run(count, [&](int i) { ++done[static_cast<std::size_t>(i)]; });
      EXPECT_EQ(std::count(done.begin(), done.end(), 1), count) << threads << " threads";
    }
  }
}

TEST(ThreadPool, KnowsHowManyCoresThereAre) {
  EXPECT_GE(countCores(), 1);
  EXPECT_LE(countCores(), static_cast<int>(std::thread::hardware_concurrency()));
}

TEST(ThreadPool, HasItsWorkDoneWhenItReturns) {
  ThreadPool pool(4);
  std::vector<long> values(64);
  long expected = 0;
  for (int round = 0; round < 2000; ++round) {
    pool.run(64, [&](int i) { values[static_cast<std::size_t>(i)] += i; });
    expected += 64 * 63 / 2;
    ASSERT_EQ(std::accumulate(values.begin(), values.end(), 0L), expected) << "round " << round;
  }
}

TEST(ThreadPool, WakesUpAfterAPause) {
  ThreadPool pool(3);
  for (int round = 0; round < 5; ++round) {
    std::atomic<int> sum = 0;
    pool.run(100, [&](int i) { sum += i; });
    EXPECT_EQ(sum, 4950);
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
  }
}

TEST(ThreadPool, MayBeToldOfWorkThatComesOrDoesNot) {
  ThreadPool pool(3);
  ThreadPool alone(1);
  alone.expectWork();
  for (int round = 0; round < 200; ++round) {
    pool.expectWork();
    if (round % 3 == 0) std::this_thread::sleep_for(std::chrono::microseconds(300));
    if (round % 5 == 0) continue;
    std::atomic<int> sum = 0;
    pool.run(50, [&](int i) { sum += i; });
    ASSERT_EQ(sum, 1225) << "round " << round;
  }
}

TEST(ThreadPool, SharesWorkThatTakesTime) {
  ThreadPool pool(3);
  std::mutex mutex;
  std::set<std::thread::id> threads;
  for (int round = 0; round < 100 && threads.size() < 2; ++round) {
    pool.run(30, [&](int) {
      std::this_thread::sleep_for(std::chrono::microseconds(100));
      const std::scoped_lock lock(mutex);
      threads.insert(std::this_thread::get_id());
    });
  }
  EXPECT_GT(threads.size(), 1U);
}

}  // namespace
}  // namespace scatter::parallel
