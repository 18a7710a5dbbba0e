#include <scatter/lab/collision_steps.h>

#include "lab/fake_physics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace scatter {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

Result<Comparison> compareSteps(int repeat) {
  return compareWorlds({.runs = collisionStepRuns(test::fakeRun(WorldKind::kStandard, 12)),
                        .repeat = repeat,
                        .commandLine = {}});
}

const PairSteps& algorithmOf(const std::string& label) {
  const auto& steps = collisionSteps();
  const auto found = std::find_if(steps.begin(), steps.end(),
                                  [&](const CollisionStep& step) { return step.label == label; });
  EXPECT_NE(found, steps.end()) << label;
  return found->physics.collision.pairAlgorithm;
}

int switchesOn(const PairSteps& steps) {
  return int{steps.motionBound} + int{steps.cachedAxis} + int{steps.lazyManifolds} + int{steps.ownGjk} +
         int{steps.warmSimplex};
}

TEST(CollisionSteps, BeginWithTheStandardWorldAndEndWithLevelOne) {
  const auto& steps = collisionSteps();
  EXPECT_EQ(steps.front().physics.world, WorldKind::kStandard);
  EXPECT_EQ(steps.back().physics.switching.policy, Policy::kCoarsest);
  std::set<std::string> labels;
  for (const CollisionStep& step : steps) {
    EXPECT_TRUE(labels.insert(step.label).second) << step.label;
    if (&step == &steps.front()) continue;
    EXPECT_EQ(step.physics.world, WorldKind::kHybrid) << step.label;
    EXPECT_EQ(step.physics.collision.narrowphase, Narrowphase::kScatter) << step.label;
    if (&step != &steps.back()) {
      EXPECT_EQ(step.physics.switching.policy, Policy::kFinest) << step.label;
    }
  }
}

TEST(CollisionSteps, AddOneStepAtATimeUpToTheDefault) {
  EXPECT_EQ(switchesOn(algorithmOf("world_boxes")), 0);
  EXPECT_EQ(algorithmOf("world_boxes").midphase, PairMidphase::kWorldBoxes);
  EXPECT_EQ(switchesOn(algorithmOf("part_boxes")), 0);
  for (const char* alone : {"motion_bound", "cached_axis", "lazy_manifolds"}) {
    EXPECT_EQ(switchesOn(algorithmOf(alone)), 1) << alone;
    EXPECT_EQ(algorithmOf(alone).midphase, PairMidphase::kPartBoxes) << alone;
  }
  EXPECT_TRUE(algorithmOf("motion_bound").motionBound);
  EXPECT_TRUE(algorithmOf("cached_axis").cachedAxis);
  EXPECT_TRUE(algorithmOf("lazy_manifolds").lazyManifolds);
  EXPECT_EQ(switchesOn(algorithmOf("neighbour_list")), 3);
  EXPECT_FALSE(algorithmOf("neighbour_list").ownGjk);
  EXPECT_EQ(switchesOn(algorithmOf("own_gjk")), 4);
  EXPECT_FALSE(algorithmOf("own_gjk").warmSimplex);
  EXPECT_EQ(switchesOn(algorithmOf("warm_simplex")), switchesOn(PairSteps{}));
  EXPECT_EQ(algorithmOf("warm_simplex").midphase, PairSteps{}.midphase);
}

TEST(CollisionSteps, RunsKeepTheSceneAndItsOptions) {
  RunOptions base = test::fakeRun(WorldKind::kStandard, 7);
  base.seed = 5;
  base.physics.profiling = false;
  for (const RunOptions& run : collisionStepRuns(base)) {
    EXPECT_EQ(run.scene, "fake");
    EXPECT_EQ(run.frames, 7);
    EXPECT_EQ(run.seed, 5U);
    EXPECT_FALSE(run.physics.profiling);
  }
}

TEST(FormatCollisionSteps, ShowsRatiosCountsAndMemory) {
  auto comparison = compareSteps(3);
  ASSERT_TRUE(comparison);
  // Steps of a microsecond that the machine interrupts have ratios so long that the table breaks elsewhere.
  constexpr Spread kSame{.median = 1.0, .min = 1.0, .max = 1.0};
  for (ComparedWorld& world : comparison->worlds) world.physicsCpuMs = {kSame, kSame, kSame, kSame, kSame};
  const std::string table = formatCollisionSteps(*comparison);
  // The fake has 4 manifolds a step in a standard world and 1 in a hybrid one, at most 25 child pairs, 2 GJK
  // runs a step, and 900 bytes a pair and 56 a child pair.
  EXPECT_THAT(table, ContainsRegex("manifolds  child pairs  GJK runs\n-+\nplain engine +48 +0 +0\n"));
  EXPECT_THAT(table, ContainsRegex("warm simplex: the default +12 +25 +24\n"));
  EXPECT_THAT(table, ContainsRegex("detectors  B/pair  B/child pair\n-+\nplain engine +0 +- +-\n"));
  EXPECT_THAT(table, ContainsRegex("warm simplex: the default +0 +900 +56.0\n"));
  EXPECT_THAT(table, HasSubstr("3 interleaved repeats"));
  EXPECT_THAT(table, HasSubstr("1.00 (1.00-1.00)"));
  for (const CollisionStep& step : collisionSteps()) {
    EXPECT_THAT(table, HasSubstr(step.what));
  }
}

TEST(CollisionStepsCsv, HasALineForEachStepWithAsManyCells) {
  const auto comparison = compareSteps(1);
  ASSERT_TRUE(comparison);
  const std::string csv = collisionStepsCsv(*comparison);
  std::istringstream lines(csv);
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), 15) << line;
  }
  EXPECT_EQ(count, collisionSteps().size() + 1);
  EXPECT_THAT(csv, testing::StartsWith("step,peak_ratio,peak_ratio_min,peak_ratio_max,total_ratio,"));
  EXPECT_THAT(csv, ContainsRegex("\nstandard,1,1,1,1,1,1,1,1,1,48,0,0,0,-,-\n"));
}

}  // namespace
}  // namespace scatter
