#include "lod/policies_local.h"

#include <gtest/gtest.h>

#include <limits>

#include "lod/policy_world.h"

namespace scatter::lod {
namespace {

using testing::kNothingAsked;
using testing::PolicyWorld;

class ProximityPolicyTest : public ::testing::Test {
 protected:
  PolicyWorld world_ = PolicyWorld::twoBodies();
  ProximityPolicy policy_{{.level = 2, .approach = 0.5F, .steps = 10}};
};

TEST_F(ProximityPolicyTest, AsksWhereBodiesThatDoNotTouchApproach) {
  for (const std::uint8_t level : {0, 3}) {
    world_.pairs[0].level = level;
    world_.bodies[0].velocity = Vec3(1.0F, 0.0F, 0.0F);
    EXPECT_EQ(world_.ask(policy_).atMost, 2);
    world_.bodies[0].velocity = Vec3(-1.0F, 0.0F, 0.0F);
    EXPECT_EQ(world_.ask(policy_).atMost, kNothingAsked);
    world_.bodies[0].velocity = Vec3(0.0F, 9.0F, 0.0F);
    EXPECT_EQ(world_.ask(policy_).atMost, kNothingAsked) << "they pass each other";
  }
}

TEST_F(ProximityPolicyTest, DoesNotAskOnceTheyTouchFinely) {
  world_.bodies[0].velocity = Vec3(1.0F, 0.0F, 0.0F);
  world_.pairs[0].touching = true;
  EXPECT_EQ(world_.ask(policy_).atMost, kNothingAsked);
}

TEST_F(ProximityPolicyTest, StandsByItThroughTheFirstStepsOfAContact) {
  world_.pairs[0].touching = true;
  world_.pairs[0].level = 2;
  world_.pairs[0].contactSteps = 9;
  EXPECT_EQ(world_.ask(policy_).atMost, 2);
  world_.pairs[0].contactSteps = 10;
  EXPECT_EQ(world_.ask(policy_).atMost, kNothingAsked);
}

TEST_F(ProximityPolicyTest, TakesItBackOnlyWhenTheyPart) {
  world_.pairs[0].level = 1;
  world_.bodies[0].velocity = Vec3(-0.4F, 0.0F, 0.0F);
  EXPECT_EQ(world_.ask(policy_).atMost, 2);
  world_.bodies[0].velocity = Vec3(-0.6F, 0.0F, 0.0F);
  EXPECT_EQ(world_.ask(policy_).atMost, kNothingAsked);
}

TEST_F(ProximityPolicyTest, BesideWhatNothingMovesAnyMotionIsAnApproach) {
  world_.bodies[1].mass = 0.0F;
  world_.bodies[0].velocity = Vec3(0.0F, -1.0F, 0.0F);
  EXPECT_EQ(world_.ask(policy_).atMost, 2);
  world_.bodies[0].velocity = Vec3(0.0F);
  EXPECT_EQ(world_.ask(policy_).atMost, kNothingAsked);
}

TEST(SpeedPolicy, ImportanceFallsInAStraightLine) {
  PolicyWorld world = PolicyWorld::twoBodies();
  SpeedPolicy policy({.from = 2.0F, .to = 6.0F, .least = 0.2F});
  const auto at = [&](float speed) {
    // Only the difference counts.
    world.bodies[0].velocity = Vec3(0.0F, 100.0F + speed, 0.0F);
    world.bodies[1].velocity = Vec3(0.0F, 100.0F, 0.0F);
    return world.ask(policy).importance;
  };
  EXPECT_EQ(at(0.0F), 1.0F);
  EXPECT_EQ(at(2.0F), 1.0F);
  EXPECT_FLOAT_EQ(at(3.0F), 0.8F);
  EXPECT_FLOAT_EQ(at(4.0F), 0.6F);
  EXPECT_EQ(at(6.0F), 0.2F);
  EXPECT_EQ(at(60.0F), 0.2F);
  EXPECT_EQ(at(std::numeric_limits<float>::quiet_NaN()), 1.0F);
}

TEST(SpeedPolicy, AsksOnlyIfToldToAndWithHysteresis) {
  PolicyWorld world = PolicyWorld::twoBodies();
  world.bodies[0].velocity = Vec3(9.0F, 0.0F, 0.0F);
  SpeedPolicy silent({});
  EXPECT_EQ(world.ask(silent).atMost, kNothingAsked);

  SpeedPolicy policy({.coarse = 10.0F, .level = 1});
  EXPECT_EQ(world.ask(policy).atMost, kNothingAsked);
  world.pairs[0].level = 1;
  EXPECT_EQ(world.ask(policy).atMost, 1) << "coarse already, and above 80 %";
  world.bodies[0].velocity = Vec3(7.9F, 0.0F, 0.0F);
  EXPECT_EQ(world.ask(policy).atMost, kNothingAsked);
  world.pairs[0].level = 3;
  world.bodies[0].velocity = Vec3(10.1F, 0.0F, 0.0F);
  EXPECT_EQ(world.ask(policy).atMost, 1);
}

TEST(ContactTimePolicy, ImportanceGrowsWithTimeInContact) {
  PolicyWorld world = PolicyWorld::twoBodies();
  ContactTimePolicy policy({.steps = 40, .most = 5.0F});
  const auto after = [&](std::uint16_t steps) {
    world.pairs[0].contactSteps = steps;
    return world.ask(policy).importance;
  };
  EXPECT_EQ(after(20), 1.0F) << "does not touch";
  world.pairs[0].touching = true;
  EXPECT_EQ(after(0), 1.0F);
  EXPECT_FLOAT_EQ(after(10), 2.0F);
  EXPECT_FLOAT_EQ(after(40), 5.0F);
  EXPECT_FLOAT_EQ(after(65535), 5.0F);
}

class FocusPolicyTest : public ::testing::Test {
 protected:
  /// Both bodies at the same place, so that it does not matter which is looked at.
  float at(const Vec3& place) {
    world_.bodies[0].center = place;
    world_.bodies[1].center = place;
    return world_.ask(policy_).importance;
  }

  PolicyWorld world_ = PolicyWorld::twoBodies();
  FocusPolicy policy_{{.size = 0.1F, .angle = 10.0F, .least = 0.05F, .most = 4.0F}};
};

TEST_F(FocusPolicyTest, SaysNothingWithoutAFocus) {
  EXPECT_EQ(at(Vec3(0.0F, 0.0F, -5.0F)), 1.0F);
  world_.focus = Focus{Vec3(1.0F), Vec3(1.0F), 1.0F};
  EXPECT_EQ(at(Vec3(0.0F, 0.0F, -5.0F)), 1.0F) << "a focus without a direction";
}

TEST_F(FocusPolicyTest, GrowsWithTheSizeOnScreen) {
  // Half the picture is as high as its distance: tan(45 degrees) = 1.
  world_.focus = Focus{Vec3(0.0F), Vec3(0.0F, 0.0F, -3.0F), 1.5707963F};
  EXPECT_NEAR(at(Vec3(0.0F, 0.0F, -10.0F)), 1.0F, 1e-5F);
  EXPECT_NEAR(at(Vec3(0.0F, 0.0F, -5.0F)), 2.0F, 1e-5F);
  EXPECT_NEAR(at(Vec3(0.0F, 0.0F, -40.0F)), 0.25F, 1e-5F);
  EXPECT_EQ(at(Vec3(0.0F, 0.0F, -0.1F)), 4.0F) << "no more than most";
  EXPECT_EQ(at(Vec3(0.0F, 0.0F, -9000.0F)), 0.05F) << "no less than least";
}

TEST_F(FocusPolicyTest, FallsOffTheLineOfSight) {
  world_.focus = Focus{Vec3(0.0F), Vec3(0.0F, 0.0F, -3.0F), 1.5707963F};
  EXPECT_NEAR(at(Vec3(1.7F, 0.0F, -10.0F)), 1.0F, 1e-5F) << "within 10 degrees";
  // tan(10 degrees) over 10 m / 10 m.
  EXPECT_NEAR(at(Vec3(10.0F, 0.0F, -10.0F)), 0.176327F, 1e-5F);
  EXPECT_NEAR(at(Vec3(0.0F, -5.0F, -10.0F)), 0.352654F, 1e-5F);
}

TEST_F(FocusPolicyTest, WhatIsNotSeenCountsLeast) {
  world_.focus = Focus{Vec3(0.0F), Vec3(0.0F, 0.0F, -3.0F), 0.2F};
  EXPECT_EQ(at(Vec3(0.0F, 0.0F, 5.0F)), 0.05F) << "behind";
  EXPECT_EQ(at(Vec3(8.0F, 0.0F, -5.0F)), 0.05F) << "aside";
}

TEST_F(FocusPolicyTest, LooksAtTheSmallerBody) {
  world_.focus = Focus{Vec3(0.0F), Vec3(0.0F, 0.0F, -3.0F), 1.5707963F};
  world_.bodies[0].radius = 500.0F;
  EXPECT_NEAR(at(Vec3(0.0F, 0.0F, -10.0F)), 1.0F, 1e-5F);
  std::swap(world_.bodies[0].radius, world_.bodies[1].radius);
  EXPECT_NEAR(at(Vec3(0.0F, 0.0F, -10.0F)), 1.0F, 1e-5F);
}

TEST(HeldPolicy, PromisesTheFinestLevelOfWhatIsHeld) {
  PolicyWorld world = PolicyWorld::twoBodies();
  HeldPolicy policy{HeldPolicy::Def{}};
  EXPECT_EQ(world.ask(policy).atLeast, 1);
  for (const std::size_t body : {0U, 1U}) {
    world.bodies[body].held = true;
    EXPECT_EQ(world.ask(policy).atLeast, 3);
    world.bodies[body].held = false;
  }
}

TEST(MassPolicy, GrowsWithTheRootOfTheLighterMass) {
  PolicyWorld world = PolicyWorld::twoBodies();
  MassPolicy policy({.reference = 10.0F, .heavier = 0, .most = 3.0F});
  const auto of = [&](float a, float b) {
    world.bodies[0].mass = a;
    world.bodies[1].mass = b;
    return world.ask(policy).importance;
  };
  EXPECT_FLOAT_EQ(of(10.0F, 100.0F), 1.0F);
  EXPECT_FLOAT_EQ(of(90.0F, 40.0F), 2.0F);
  EXPECT_FLOAT_EQ(of(2.5F, 40.0F), 0.5F);
  EXPECT_FLOAT_EQ(of(0.0F, 40.0F), 2.0F) << "what nothing moves is not the lighter one";
  EXPECT_FLOAT_EQ(of(1e6F, 1e7F), 3.0F);
  EXPECT_FLOAT_EQ(of(1e-6F, 1e7F), 1.0F / 3.0F);
}

TEST(MassPolicy, LooksAtTheHeavierBodyIfTold) {
  PolicyWorld world = PolicyWorld::twoBodies();
  MassPolicy policy({.reference = 10.0F, .heavier = 1, .most = 3.0F});
  world.bodies[1].mass = 40.0F;
  EXPECT_FLOAT_EQ(world.ask(policy).importance, 2.0F);
  world.bodies[1].mass = 0.0F;
  EXPECT_FLOAT_EQ(world.ask(policy).importance, 3.0F);
}

TEST(MassPolicy, ComparesWithTheMedianOfTheBodiesThatMove) {
  PolicyWorld world = PolicyWorld::twoBodies();
  for (const float x : {20.0F, 30.0F, 40.0F}) world.addBody(Vec3(x, 0.0F, 0.0F));
  world.bodies[0].mass = 4.0F;
  world.bodies[1].mass = 4.0F;
  world.bodies[2].mass = 16.0F;
  world.bodies[3].mass = 20.0F;
  world.bodies[4].mass = 1e9F;
  MassPolicy policy({.most = 10.0F});
  // sqrt(4 / 16)
  EXPECT_FLOAT_EQ(world.ask(policy).importance, 0.5F);
  world.bodies[2].present = false;
  world.bodies[3].present = false;
  EXPECT_FLOAT_EQ(world.ask(policy).importance, 1.0F);
  world.bodies[0].mass = 0.0F;
  world.bodies[1].mass = 0.0F;
  world.bodies[4].mass = 0.0F;
  EXPECT_FLOAT_EQ(world.ask(policy).importance, 1.0F) << "nothing to compare with";
}

}  // namespace
}  // namespace scatter::lod
