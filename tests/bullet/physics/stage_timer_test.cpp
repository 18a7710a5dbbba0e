#include "bullet/physics/stage_timer.h"

#include <gtest/gtest.h>

#include <numeric>
#include <string>

namespace scatter {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kSpin = 0.2;  // Milliseconds.

void spin() {
  const auto end = Clock::now() + std::chrono::duration<double, std::milli>(kSpin);
  while (Clock::now() < end) {
  }
}

void zone(const char* name) {
  BT_PROFILE(name);
  spin();
}

double timeOf(const BulletStageTimer& timer, Stage stage) {
  return timer.times()[static_cast<std::size_t>(stage)];
}

}  // namespace

TEST(BulletStageTimer, TimeCountsForTheInnermostStageOnly) {
  BulletStageTimer timer;
  const auto start = Clock::now();
  {
    const BulletStageTimer::Running running(timer);
    spin();  // Of no stage.
    BT_PROFILE("performDiscreteCollisionDetection");
    spin();
    zone("updateAabbs");
    zone("unknown");
    zone("planSwitching");
    spin();
  }
  const std::chrono::duration<double, std::milli> wall = Clock::now() - start;
  EXPECT_GE(timeOf(timer, Stage::kUpdateAabbs), kSpin);
  EXPECT_GE(timeOf(timer, Stage::kPlan), kSpin);
  EXPECT_GE(timeOf(timer, Stage::kCollisionDetection), 3 * kSpin);
  const StageTimes times = timer.times();
  EXPECT_LE(std::accumulate(times.begin(), times.end(), 0.0), wall.count() - kSpin);
}

TEST(BulletStageTimer, ZonesInsideTheNarrowphaseBeginNoStage) {
  BulletStageTimer timer;
  {
    const BulletStageTimer::Running running(timer);
    {
      BT_PROFILE("dispatchAllCollisionPairs");
      zone("updateAabbs");
    }
    zone("updateActions");
  }
  EXPECT_EQ(timeOf(timer, Stage::kUpdateAabbs), 0.0);
  EXPECT_GE(timeOf(timer, Stage::kCollisionDetection), kSpin);
  EXPECT_GE(timeOf(timer, Stage::kVehicles), kSpin);
}

TEST(BulletStageTimer, ScopesCountForTheirStage) {
  BulletStageTimer timer;
  {
    const BulletStageTimer::Scope idle(timer, Stage::kIslands);
    spin();
  }
  {
    const BulletStageTimer::Running running(timer);
    BT_PROFILE("solveConstraints");
    {
      const BulletStageTimer::Scope joints(timer, Stage::kNoncontactConstraints);
      zone("solveSingleIteration");
    }
    spin();
  }
  EXPECT_EQ(timeOf(timer, Stage::kIslands), 0.0);
  EXPECT_GE(timeOf(timer, Stage::kNoncontactConstraints), kSpin);
  EXPECT_GE(timeOf(timer, Stage::kContactConstraints), kSpin);
}

TEST(BulletStageTimer, EachRunBeginsAtZero) {
  BulletStageTimer timer;
  {
    const BulletStageTimer::Running running(timer);
    zone("integrateTransforms");
  }
  { const BulletStageTimer::Running running(timer); }
  EXPECT_EQ(timer.times(), StageTimes{});
}

TEST(BulletStageTimer, ManyNamesAndDeepNestingDoNoHarm) {
  std::vector<std::string> names;
  for (int i = 0; i < 2000; ++i) names.push_back("zone " + std::to_string(i));
  BulletStageTimer timer;
  {
    const BulletStageTimer::Running running(timer);
    for (const std::string& name : names) BT_PROFILE(name.c_str());
    {
      BT_PROFILE("updateActions");
      for (int depth = 0; depth < 50; ++depth)
        btGetCurrentEnterProfileZoneFunc()("calculateSimulationIslands");
      for (int depth = 0; depth < 50; ++depth) btGetCurrentLeaveProfileZoneFunc()();
      spin();
    }
    zone("updateActivationState");
  }
  EXPECT_GE(timeOf(timer, Stage::kVehicles), kSpin);
  EXPECT_GE(timeOf(timer, Stage::kActivation), kSpin);
}

}  // namespace scatter
