#include <scatter/lab/memory_study.h>
#include <scatter/lab/touched_memory.h>

#include "lab/fake_physics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace scatter {
namespace {

constexpr std::size_t kMegabyte = 1'000'000;

TEST(TouchedMemory, IsWhatWasReadOrWrittenSinceItsBeginning) {
  constexpr std::size_t kSize = 64 * kMegabyte;
  const std::unique_ptr<char[]> block(new char[kSize]());
  ASSERT_TRUE(TouchedMemory::begin());
  const auto before = TouchedMemory::bytes();
  ASSERT_TRUE(before) << before.error().message;
  EXPECT_LT(*before, kSize / 2);
  volatile char sum = 0;
  for (std::size_t i = 0; i < kSize / 2; i += 1024) sum = static_cast<char>(sum + block[i]);
  for (std::size_t i = kSize / 2; i < kSize * 3 / 4; i += 1024) block[i] = sum;
  const auto after = TouchedMemory::bytes();
  ASSERT_TRUE(after);
  EXPECT_GE(*after, kSize * 3 / 4);
  EXPECT_LT(*after, kSize);
}

TEST(CountMemory, EveryFewFrames) {
  RunOptions options = test::fakeRun(WorldKind::kStandard, 6);
  options.memoryEvery = 3;
  const auto run = runScene(options);
  ASSERT_TRUE(run) << run.error().message;
  const auto& touched = run->table.values("touched_memory_mb");
  ASSERT_EQ(touched.size(), 6U);
  for (std::size_t i = 0; i < touched.size(); ++i) {
    EXPECT_EQ(std::isnan(touched[i]), (i + 1) % 3 != 0) << i;
    if (!std::isnan(touched[i])) {
      EXPECT_GT(touched[i], 0.0);
    }
  }
}

TEST(CountMemory, RefusesANegativeNumberOfFrames) {
  RunOptions options = test::fakeRun(WorldKind::kStandard, 2);
  options.memoryEvery = -1;
  const auto run = runScene(options);
  ASSERT_FALSE(run);
  EXPECT_THAT(run.error().message, testing::HasSubstr("give a number from 0"));
}

TEST(FormatMemory, HasALineForEveryWorld) {
  RunOptions first = test::fakeRun(WorldKind::kStandard, 4);
  first.memoryEvery = 2;
  RunOptions second = first;
  first.label = "one";
  second.label = "other";
  const auto comparison = compareWorlds({.runs = {first, second}, .repeat = 1, .commandLine = {}});
  ASSERT_TRUE(comparison) << comparison.error().message;
  EXPECT_THAT(formatMemory(*comparison),
              testing::ContainsRegex("\none +[0-9.]+ +[0-9.]+ +[0-9.]+ +0.00\nother "));
  EXPECT_THAT(formatMemory(*comparison), testing::HasSubstr("every 2 frames"));
  EXPECT_THAT(
      memoryCsv(*comparison),
      testing::ContainsRegex("^world,touched_median_mb,touched_p99_mb,touched_peak_mb,held_mb\none,"));
}

}  // namespace
}  // namespace scatter
