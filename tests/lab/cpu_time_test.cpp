#include <scatter/lab/cpu_time.h>

#include <gtest/gtest.h>

#include <thread>

namespace scatter {
namespace {

// Uses processor time, however slow or busy the machine.
void burn(double seconds) {
  const double start = threadCpuSeconds();
  while (threadCpuSeconds() - start < seconds) {
  }
}

TEST(CpuTime, AnotherThreadsTimeIsTheProcessesButNotOurs) {
  const double thread = threadCpuSeconds();
  const double process = processCpuSeconds();
  std::thread([] { burn(0.02); }).join();
  EXPECT_GE(processCpuSeconds() - process, 0.02);
  EXPECT_LT(threadCpuSeconds() - thread, 0.02);
}

TEST(CpuLoad, IsProcessorTimeOverWallTime) {
  CpuLoad load;
  const double cpuBefore = processCpuSeconds();
  const double wallBefore = wallSeconds();
  burn(0.02);
  const double sampled = load.sample();
  const double most = (processCpuSeconds() - cpuBefore) / (wallSeconds() - wallBefore);
  EXPECT_GT(sampled, 0.0);
  // Sampled between the two, on at most every core at once.
  EXPECT_NEAR(sampled, most, 0.5);
}

}  // namespace
}  // namespace scatter
