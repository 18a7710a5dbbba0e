#include <scatter/lab/summary.h>

#include "lab/fake_physics.h"
#include "lab/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <numeric>
#include <random>

namespace scatter {
namespace {

TEST(NearestRank, MatchesValuesWorkedOutByHand) {
  // Ranks ceil(0.5 * 4) = 2, ceil(0.99 * 4) = 4, ceil(0.25 * 4) = 1.
  EXPECT_EQ(nearestRank({3, 1, 4, 2}, 0.5), 2.0);
  EXPECT_EQ(nearestRank({3, 1, 4, 2}, 0.99), 4.0);
  EXPECT_EQ(nearestRank({3, 1, 4, 2}, 0.25), 1.0);
  EXPECT_EQ(nearestRank({3, 1, 4, 2}, 0.0), 1.0);
  EXPECT_EQ(nearestRank({5}, 0.999), 5.0);
  EXPECT_EQ(nearestRank({}, 0.5), 0.0);
  std::vector<double> hundred(100);
  std::iota(hundred.begin(), hundred.end(), 1.0);
  EXPECT_EQ(nearestRank(hundred, 0.99), 99.0);
  EXPECT_EQ(nearestRank(hundred, 0.07), 7.0);
  EXPECT_EQ(nearestRank(hundred, 0.999), 100.0);
  EXPECT_EQ(nearestRank(hundred, 1.0), 100.0);
}

TEST(NearestRank, AtLeastTheShareIsNotGreaterAndFewerForAnySmallerValue) {
  std::mt19937_64 random(3);
  for (int round = 0; round < 300; ++round) {
    std::vector<double> values(1 + random() % 50);
    for (double& value : values) {
      value = static_cast<double>(random() % 20);
    }
    const double share = static_cast<double>(random() % 1001) / 1000.0;
    const double result = nearestRank(values, share);
    const auto count = static_cast<double>(values.size());
    const auto notGreater =
        std::count_if(values.begin(), values.end(), [&](double v) { return v <= result; });
    const auto smaller = std::count_if(values.begin(), values.end(), [&](double v) { return v < result; });
    ASSERT_GE(static_cast<double>(notGreater), share * count - 1e-6);
    ASSERT_TRUE(smaller == 0 || static_cast<double>(smaller) < share * count);
  }
}

TEST(MedianOf, IsTheMiddleOrTheMeanOfTheMiddleTwo) {
  EXPECT_EQ(medianOf({3, 1, 2}), 2.0);
  EXPECT_EQ(medianOf({4, 1, 2, 10}), 3.0);
  EXPECT_EQ(medianOf({}), 0.0);
}

TEST(TimeStatistics, CountsFramesOverBudgetStrictly) {
  const TimeStatistics times = timeStatistics({1, 2, 3, 10}, 3.0);
  EXPECT_EQ(times.framesOverBudget, 1U);
  EXPECT_EQ(times.peak, 10.0);
  EXPECT_EQ(times.p999, 10.0);
  EXPECT_EQ(times.median, 2.0);
  EXPECT_EQ(times.total, 16.0);
}

TEST(TimeStatistics, LastHundredIsTheMeanOfTheLastFramesOnly) {
  // 50 slow frames, then 100 that take 1 and 2 ms in turn.
  std::vector<double> milliseconds(50, 900.0);
  for (int i = 0; i < 100; ++i) {
    milliseconds.push_back(i % 2 == 0 ? 1.0 : 2.0);
  }
  EXPECT_DOUBLE_EQ(timeStatistics(milliseconds, 1.0).lastHundred, 1.5);
  EXPECT_DOUBLE_EQ(timeStatistics({4.0, 8.0}, 1.0).lastHundred, 6.0);
  EXPECT_EQ(timeStatistics({}, 1.0).lastHundred, 0.0);
}

TEST(Environment, IsKnown) {
  EXPECT_GE(machineInfo().cores, 1);
  EXPECT_GT(machineInfo().memoryBytes, 0U);
  EXPECT_NE(machineInfo().cpu, "");
  EXPECT_NE(buildInfo().version, "");
  EXPECT_NE(buildInfo().commit, "");
  EXPECT_THAT(buildInfo().flags, testing::HasSubstr("-ffp-contract=off"));
}

TEST(WriteSummary, HoldsEverythingAReaderNeeds) {
  const auto run = runScene(test::fakeRun(WorldKind::kHybrid, 4));
  ASSERT_TRUE(run);
  test::TemporaryFolder folder;
  ASSERT_TRUE(writeSummary(folder.path() / "summary.json", run->summary));
  const auto json = nlohmann::json::parse(test::contentOf(folder.path() / "summary.json"));
  EXPECT_EQ(json["scene"], "fake");
  EXPECT_EQ(json["engine"], "fake 1.0");
  EXPECT_EQ(json["options"]["world"], "hybrid");
  EXPECT_EQ(json["options"]["frames"], 4);
  EXPECT_EQ(json["options"]["switching"]["mode"], "pair");
  EXPECT_EQ(json["options"]["switching"]["policy"], "none");
  EXPECT_EQ(json["options"]["switching"]["credit_level"], 2);
  EXPECT_EQ(json["options"]["switching"]["budget"]["milliseconds"], 0.0);
  EXPECT_EQ(json["options"]["profiling"], true);
  for (const char* channel : {"physics_ms", "physics_cpu_ms"}) {
    for (const char* figure :
         {"peak", "p999", "p99", "median", "total", "last_100_mean", "frames_over_budget"}) {
      EXPECT_TRUE(json[channel][figure].is_number()) << channel << ' ' << figure;
    }
  }
  // 1 + 2 + 3 + 4 manifolds in a fake hybrid world.
  EXPECT_EQ(json["totals"]["manifolds"], 10);
  EXPECT_EQ(json["peaks"]["manifolds"], 4);
  EXPECT_EQ(json["level_events"]["switched"], 1);
  EXPECT_EQ(json["level_events_by_policy"]["governor"]["switched"], 1);
  EXPECT_EQ(json["level_events_by_policy"]["speed"]["switched"], 0);
  EXPECT_FALSE(json.contains("fidelity"));
  EXPECT_EQ(json["state_hash"], "78dde6e5fd29f054");
  EXPECT_TRUE(json["machine"]["cores"].is_number());
  EXPECT_TRUE(json["build"]["compiler"].is_string());
  EXPECT_FALSE(json.contains("stopped"));
  EXPECT_EQ(json["options"]["collision"]["narrowphase"], "scatter");
  EXPECT_EQ(json["options"]["collision"]["pair_algorithm"]["midphase"], "neighbour_list");
  EXPECT_FALSE(json.contains("contact_check"));
}

TEST(WriteSummary, HoldsTheContactCheckAndTheMemoryOfTheFrameWithTheMostChildPairs) {
  RunOptions options = test::fakeRun(WorldKind::kHybrid, 9, {.missedStep = 6});
  options.physics.collision.verifyEvery = 3;
  const auto run = runScene(options);
  ASSERT_TRUE(run);
  test::TemporaryFolder folder;
  ASSERT_TRUE(writeSummary(folder.path() / "summary.json", run->summary));
  const auto json = nlohmann::json::parse(test::contentOf(folder.path() / "summary.json"));
  // Frames 3, 6 and 9 are verified; the fake expects 10 contacts in each and misses 3 in frame 6.
  EXPECT_EQ(json["contact_check"]["frames_verified"], 3);
  EXPECT_EQ(json["contact_check"]["expected"], 30);
  EXPECT_EQ(json["contact_check"]["missed"], 3);
  ASSERT_EQ(json["contact_check"]["first_missed"].size(), 3U);
  EXPECT_EQ(json["contact_check"]["first_missed"][0]["frame"], 6);
  EXPECT_EQ(json["contact_check"]["first_missed"][0]["body_b"], "right");
  // The fake has the most child pairs, 25 in 5 pairs, in step 5.
  EXPECT_EQ(json["collision_memory"]["child_pairs"], 25);
  EXPECT_EQ(json["collision_memory"]["pair_bytes"], 4500);
}

TEST(WriteSummary, HoldsBudgetsAndPoliciesOfPairSwitching) {
  RunOptions options = test::fakeRun(WorldKind::kHybrid, 2);
  options.physics.switching.policies = {"speed:from=5", "held"};
  options.physics.switching.budget.recorded.resize(3, {.given = 1.0});
  options.physics.switching.credit = false;
  const auto run = runScene(options);
  ASSERT_TRUE(run);
  test::TemporaryFolder folder;
  ASSERT_TRUE(writeSummary(folder.path() / "summary.json", run->summary));
  const auto json = nlohmann::json::parse(test::contentOf(folder.path() / "summary.json"));
  const auto& switching = json["options"]["switching"];
  EXPECT_EQ(switching["policies"], (std::vector<std::string>{"speed:from=5", "held"}));
  EXPECT_EQ(switching["budget"]["replayed_steps"], 3);
  EXPECT_EQ(switching["budget"]["machine_steps"], 0);
  EXPECT_EQ(switching["credit"], false);
}

TEST(WriteSummary, BodySwitchingHasNoBudget) {
  RunOptions options = test::fakeRun(WorldKind::kHybrid, 2);
  options.physics.switching.switching = Switching::kBody;
  const auto run = runScene(options);
  ASSERT_TRUE(run);
  test::TemporaryFolder folder;
  ASSERT_TRUE(writeSummary(folder.path() / "summary.json", run->summary));
  const auto json = nlohmann::json::parse(test::contentOf(folder.path() / "summary.json"));
  EXPECT_EQ(json["options"]["switching"]["mode"], "body");
  EXPECT_FALSE(json["options"]["switching"].contains("budget"));
}

TEST(WriteSummary, TheEnginesOwnCollisionHasNoSteps) {
  RunOptions options = test::fakeRun(WorldKind::kHybrid, 2);
  options.physics.collision.narrowphase = Narrowphase::kEngine;
  const auto run = runScene(options);
  ASSERT_TRUE(run);
  test::TemporaryFolder folder;
  ASSERT_TRUE(writeSummary(folder.path() / "summary.json", run->summary));
  const auto json = nlohmann::json::parse(test::contentOf(folder.path() / "summary.json"));
  EXPECT_EQ(json["options"]["collision"]["narrowphase"], "engine");
  EXPECT_FALSE(json["options"]["collision"].contains("pair_algorithm"));
  EXPECT_FALSE(json.contains("collision_memory"));
}

}  // namespace
}  // namespace scatter
