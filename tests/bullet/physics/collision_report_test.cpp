#include "bullet/physics/collision_report.h"

#include <gtest/gtest.h>
#include <scatter/bullet/bullet_physics.h>

#include "bullet/physics/body.h"
#include "world/conformance/physics_conformance.h"

namespace scatter::test {
namespace {

/// Two hybrids that come to rest on each other on the ground.
std::unique_ptr<Physics> makeStack(WorldKind kind, const CollisionDef& collision) {
  PhysicsDef def;
  def.world = kind;
  def.gravity = kEarth;
  def.switching.policy = Policy::kFinest;
  def.collision = collision;
  auto physics = makeBulletPhysics(def);
  BodyDef ground = bodyAt({}, Plane{});
  ground.motion = Motion::kStatic;
  for (const BodyDef& body :
       {ground, bodyAt({0.0F, 0.6F, 0.0F}, cubeLevels()), bodyAt({0.0F, 1.8F, 0.0F}, cubeLevels())}) {
    const auto created = physics->createBody(body);
    EXPECT_TRUE(created) << created.error().message;
  }
  return physics;
}

void run(Physics& physics, int steps) {
  for (int i = 0; i < steps; ++i) physics.step(kStep);
}

TEST(CollisionReport, ThePairAlgorithmCountsItsWorkAndMemory) {
  const auto physics = makeStack(WorldKind::kHybrid, {});
  std::int64_t childPairs = 0;
  std::uint64_t mostPairs = 0;
  for (int i = 0; i < 120; ++i) {
    physics->step(kStep);
    childPairs += physics->counters().pairWork.childPairs;
    mostPairs = std::max(mostPairs, physics->diagnostics().collisionMemory().pairs);
  }
  EXPECT_GT(childPairs, 0);
  EXPECT_GT(mostPairs, 0U);
  EXPECT_GT(physics->diagnostics().collisionMemory().partBytes, 0U);
}

TEST(CollisionReport, TheEnginesOwnCollisionAndTheStandardWorldCountNothing) {
  const auto engine = makeStack(WorldKind::kHybrid, {.narrowphase = Narrowphase::kEngine});
  const auto standard = makeStack(WorldKind::kStandard, {});
  for (Physics* physics : {engine.get(), standard.get()}) {
    run(*physics, 60);
    EXPECT_EQ(physics->counters().pairWork.childPairs, 0);
    EXPECT_EQ(physics->counters().pairWork.gjkRuns, 0);
    EXPECT_EQ(physics->diagnostics().collisionMemory().childPairs, 0U);
  }
}

TEST(CollisionReport, VerifiesEveryNthStepAndMissesNothing) {
  const auto physics = makeStack(WorldKind::kHybrid, {.verifyEvery = 10});
  EXPECT_EQ(physics->diagnostics().contactReport().steps, 0U);
  run(*physics, 100);
  const ContactReport report = physics->diagnostics().contactReport();
  EXPECT_EQ(report.steps, 10U);
  EXPECT_GT(report.expected, 0U);
  EXPECT_EQ(report.missed, 0U);
  EXPECT_TRUE(report.lastMissed.empty());
}

TEST(CollisionReport, NothingIsVerifiedUnlessAskedFor) {
  const auto never = makeStack(WorldKind::kHybrid, {});
  const auto standard = makeStack(WorldKind::kStandard, {.verifyEvery = 1});
  for (Physics* physics : {never.get(), standard.get()}) {
    run(*physics, 30);
    EXPECT_EQ(physics->diagnostics().contactReport().steps, 0U);
  }
}

TEST(CollisionReport, MissedContactsCarryTheNamesOfTheirBodies) {
  const PhysicsDef def;
  BulletShapeBuilder shapes;
  BodyDef left = bodyAt({}, Box{});
  left.name = "left";
  BodyDef right = left;
  right.name = "right";
  const BulletBody a(BodyId{1}, left, *shapes.build(left.shape), {});
  const BulletBody b(BodyId{2}, right, *shapes.build(right.shape), {});
  btHybridContactReport report;
  report.m_steps = 2;
  report.m_childPairs = 30;
  report.m_expected = 7;
  report.m_missed = 1;
  report.m_extra = 3;
  report.m_lastMissed.push_back({&a.rigid(), &b.rigid(), 4, -1, -0.25F});
  const ContactReport converted = fromBullet(report);
  EXPECT_EQ(converted.steps, 2U);
  EXPECT_EQ(converted.childPairs, 30U);
  EXPECT_EQ(converted.expected, 7U);
  EXPECT_EQ(converted.extra, 3U);
  ASSERT_EQ(converted.lastMissed.size(), 1U);
  EXPECT_EQ(converted.lastMissed[0].bodyA, "left");
  EXPECT_EQ(converted.lastMissed[0].bodyB, "right");
  EXPECT_EQ(converted.lastMissed[0].childA, 4);
  EXPECT_EQ(converted.lastMissed[0].childB, -1);
  EXPECT_EQ(converted.lastMissed[0].distance, -0.25F);
}

}  // namespace
}  // namespace scatter::test
