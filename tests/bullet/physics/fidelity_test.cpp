#include <gtest/gtest.h>
#include <scatter/bullet/bullet_physics.h>

#include <memory>

#include "world/conformance/physics_conformance.h"

namespace scatter::test {
namespace {

PhysicsDef worldOf(WorldKind kind, Switching switching = Switching::kPair, Policy policy = Policy::kNone) {
  PhysicsDef def;
  def.world = kind;
  def.gravity = kEarth;
  def.switching.switching = switching;
  def.switching.policy = policy;
  return def;
}

/// Hybrids that fall on each other and on the ground.
std::unique_ptr<Physics> makeHeap(const PhysicsDef& def) {
  auto physics = makeBulletPhysics(def);
  BodyDef ground = bodyAt({}, Plane{});
  ground.motion = Motion::kStatic;
  EXPECT_TRUE(physics->createBody(ground));
  for (int i = 0; i < 6; ++i) {
    const auto along = static_cast<float>(i);
    BodyDef body = bodyAt({0.2F * along, 1.0F + 1.6F * along, 0.1F * along}, cubeLevels());
    body.angularVelocity = {along, 1.0F, 0.0F};
    EXPECT_TRUE(physics->createBody(body));
  }
  return physics;
}

std::uint32_t touchingAfter(Physics& physics, int steps) {
  for (int i = 0; i < steps; ++i) physics.step(kStep);
  return physics.diagnostics().measureFidelity().touchingPairs;
}

TEST(BulletFidelity, MeasuresAStandardWorldAtItsFinestLevel) {
  const auto physics = makeHeap(worldOf(WorldKind::kStandard));
  EXPECT_GT(touchingAfter(*physics, 240), 3U);
  const FidelitySample sample = physics->diagnostics().measureFidelity();
  ASSERT_EQ(sample.touchingByLevel.size(), 1U);
  EXPECT_EQ(sample.touchingByLevel[0], sample.touchingPairs);
  EXPECT_TRUE(sample.contactGaps.empty());
}

TEST(BulletFidelity, EveryBodyAtLevelOneTouchesCoarselyWithAGap) {
  const auto physics = makeHeap(worldOf(WorldKind::kHybrid, Switching::kBody, Policy::kCoarsest));
  EXPECT_GT(touchingAfter(*physics, 240), 3U);
  const FidelitySample sample = physics->diagnostics().measureFidelity();
  EXPECT_EQ(sample.touchingByLevel.at(0), 0U);
  EXPECT_EQ(sample.contactGaps.size(), sample.touchingPairs);
  for (const float gap : sample.contactGaps) EXPECT_GE(gap, 0.0F);
}

TEST(BulletFidelity, MeasuringChangesNoWorld) {
  for (const PhysicsDef& def : {worldOf(WorldKind::kStandard), worldOf(WorldKind::kHybrid),
                                worldOf(WorldKind::kHybrid, Switching::kPair, Policy::kProximity),
                                worldOf(WorldKind::kHybrid, Switching::kBody, Policy::kProximity),
                                worldOf(WorldKind::kHybrid, Switching::kBody, Policy::kCoarsest)}) {
    const auto measured = makeHeap(def);
    const auto left = makeHeap(def);
    for (int i = 0; i < 200; ++i) {
      measured->step(kStep);
      left->step(kStep);
      if (i % 3 == 0) static_cast<void>(measured->diagnostics().measureFidelity());
      ASSERT_EQ(measured->stateHash(), left->stateHash()) << i;
    }
  }
}

TEST(BulletFidelity, IsTheSameWhenMeasuredTwice) {
  const auto physics = makeHeap(worldOf(WorldKind::kHybrid, Switching::kBody, Policy::kCoarsest));
  EXPECT_GT(touchingAfter(*physics, 100), 0U);
  const FidelitySample first = physics->diagnostics().measureFidelity();
  const FidelitySample second = physics->diagnostics().measureFidelity();
  EXPECT_EQ(first.touchingByLevel, second.touchingByLevel);
  EXPECT_EQ(first.visibleOverlapPairs, second.visibleOverlapPairs);
  EXPECT_EQ(first.contactGaps, second.contactGaps);
}

}  // namespace
}  // namespace scatter::test
