#include <BulletHybrid/btHybridFidelity.h>
#include <gtest/gtest.h>

#include "BulletTestWorld.h"
#include "HybridTestWorld.h"

namespace scatter::test {
namespace {

/// A plain Bullet world with hybrids that stay at the level that they start with: boxes of 2 m in boxes of 3
/// m.
class PlainWorld : public BulletTestWorld<btDiscreteDynamicsWorld> {
 public:
  PlainWorld() {
    world.setGravity(btVector3(0, 0, 0));
    levels.addLevel(shape<btBoxShape>(btVector3(1.5F, 1.5F, 1.5F)));
    levels.addLevel(shape<btBoxShape>(btVector3(1, 1, 1)));
  }

  btRigidBody* addBoxes(float x, int level, btScalar mass = 1) {
    const auto definition = info(mass, levels.getLevelShape(1), btVector3(x, 0, 0));
    bodies.push_back(std::make_unique<btHybridRigidBody>(definition, &levels, level));
    world.addRigidBody(bodies.back().get());
    return bodies.back().get();
  }

  /// The contacts of where the bodies are, without moving them.
  btHybridFidelitySample measure() {
    world.performDiscreteCollisionDetection();
    return btHybridFidelity(&world).measure();
  }

  btHybridLevelSet levels;
};

TEST(Fidelity, CoarseBoxesThatTouchHaveTheGapOfTheirFineOnes) {
  PlainWorld world;
  world.addBoxes(0, 1);
  world.addBoxes(2.999F, 1);
  const btHybridFidelitySample sample = world.measure();
  EXPECT_EQ(sample.m_touchingPairs, 1);
  ASSERT_EQ(sample.m_touchingByLevel.size(), 2);
  EXPECT_EQ(sample.m_touchingByLevel[0], 0);
  EXPECT_EQ(sample.m_touchingByLevel[1], 1);
  ASSERT_EQ(sample.m_contactGaps.size(), 1);
  EXPECT_NEAR(sample.m_contactGaps[0], 0.999F, 1e-3F);
  EXPECT_EQ(sample.m_visibleOverlapPairs, 0);
}

TEST(Fidelity, TheCoarserOfTwoBodiesIsThePairsLevel) {
  PlainWorld world;
  world.addBoxes(0, 1);
  world.addBoxes(2.499F, 2);
  const btHybridFidelitySample sample = world.measure();
  ASSERT_EQ(sample.m_touchingByLevel.size(), 2);
  EXPECT_EQ(sample.m_touchingByLevel[1], 1);
  EXPECT_NEAR(sample.m_contactGaps[0], 0.499F, 1e-3F);
}

TEST(Fidelity, FineContactsHaveNoGap) {
  PlainWorld world;
  world.addBoxes(0, 2);
  world.addBoxes(1.999F, 2);
  const btHybridFidelitySample sample = world.measure();
  ASSERT_EQ(sample.m_touchingByLevel.size(), 1);
  EXPECT_EQ(sample.m_touchingByLevel[0], 1);
  EXPECT_EQ(sample.m_contactGaps.size(), 0);
}

TEST(Fidelity, TouchingIsADistanceAndNoContact) {
  PlainWorld world;
  auto* cube = world.shape<btConvexHullShape>();
  for (int corner = 0; corner < 8; ++corner) {
    cube->addPoint(btVector3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1));
  }
  cube->setMargin(0);
  world.levels.addLevel(cube);
  world.addBoxes(0, 3);
  world.addBoxes(2.015F, 3);
  EXPECT_EQ(world.measure().m_touchingPairs, 0);
  EXPECT_EQ(world.dispatcher.getNumManifolds(), 1);
  btHybridFidelity wider(&world.world);
  wider.m_touchingDistance = 0.02F;
  EXPECT_EQ(wider.measure().m_touchingPairs, 1);
}

TEST(Fidelity, OnlyDeepOverlapsOfTheFinestShapesAreVisible) {
  for (const int level : {1, 2}) {
    for (const float depth : {-0.5F, 0.04F, 0.06F, 0.5F}) {
      PlainWorld world;
      world.addBoxes(0, level);
      world.addBoxes(2.0F - depth, level);
      const int expected = depth > 0.05F ? 1 : 0;
      EXPECT_EQ(world.measure().m_visibleOverlapPairs, expected) << level << ' ' << depth;
    }
  }
}

TEST(Fidelity, OverlapsCountWithoutContacts) {
  PlainWorld world;
  world.addBoxes(0, 2);
  world.addBoxes(1, 2);
  world.world.updateAabbs();
  world.world.computeOverlappingPairs();
  const btHybridFidelitySample sample = btHybridFidelity(&world.world).measure();
  EXPECT_EQ(sample.m_touchingPairs, 0);
  EXPECT_EQ(sample.m_visibleOverlapPairs, 1);
}

TEST(Fidelity, PairsWithoutLevelsDoNotCount) {
  PlainWorld world;
  btCollisionShape* box = world.shape<btBoxShape>(btVector3(1, 1, 1));
  world.add(1, box, {0, 0, 0});
  world.add(1, box, {1.5F, 0, 0});
  EXPECT_EQ(world.measure().m_touchingPairs, 0);
  EXPECT_EQ(world.measure().m_visibleOverlapPairs, 0);
  world.addBoxes(3, 2);
  EXPECT_EQ(world.measure().m_touchingPairs, 1);
  EXPECT_EQ(world.measure().m_visibleOverlapPairs, 1);
}

TEST(Fidelity, OtherObjectsMayHaveLevelsToo) {
  class All final : public btHybridFidelity {
   public:
    using btHybridFidelity::btHybridFidelity;
    int getNumLevels(const btCollisionObject*) const override { return 3; }
  };
  PlainWorld world;
  btCollisionShape* box = world.shape<btBoxShape>(btVector3(1, 1, 1));
  world.add(1, box, {0, 0, 0});
  world.add(1, box, {1.5F, 0, 0});
  world.world.performDiscreteCollisionDetection();
  const btHybridFidelitySample sample = All(&world.world).measure();
  EXPECT_EQ(sample.m_visibleOverlapPairs, 1);
  ASSERT_EQ(sample.m_touchingByLevel.size(), 1);
  EXPECT_EQ(sample.m_touchingByLevel[0], 1);
}

TEST(Fidelity, WhatDoesNotPushIsNotMeasured) {
  PlainWorld world;
  btRigidBody* a = world.addBoxes(0, 2);
  btRigidBody* b = world.addBoxes(1.5F, 2);
  EXPECT_EQ(world.measure().m_visibleOverlapPairs, 1);
  a->setCollisionFlags(a->getCollisionFlags() | btCollisionObject::CF_NO_CONTACT_RESPONSE);
  EXPECT_EQ(world.measure().m_visibleOverlapPairs, 0);
  EXPECT_EQ(world.measure().m_touchingPairs, 0);
  a->setCollisionFlags(a->getCollisionFlags() & ~btCollisionObject::CF_NO_CONTACT_RESPONSE);
  EXPECT_EQ(world.measure().m_visibleOverlapPairs, 1);
  world.join<btPoint2PointConstraint>(*a, *b, btVector3(1, 0, 0), btVector3(-0.5F, 0, 0));
  EXPECT_EQ(world.measure().m_visibleOverlapPairs, 0);
}

TEST(Fidelity, BodiesAtRestCountToo) {
  PlainWorld world;
  btRigidBody* a = world.addBoxes(0, 2);
  btRigidBody* b = world.addBoxes(1.5F, 2);
  EXPECT_EQ(world.measure().m_visibleOverlapPairs, 1);
  a->forceActivationState(ISLAND_SLEEPING);
  b->forceActivationState(ISLAND_SLEEPING);
  EXPECT_EQ(btHybridFidelity(&world.world).measure().m_visibleOverlapPairs, 1);
  EXPECT_EQ(btHybridFidelity(&world.world).measure().m_touchingPairs, 1);
}

TEST(Fidelity, MeasuringLeavesNoTraceInAWorld) {
  std::vector<std::uint32_t> bits[2];
  for (int measured = 0; measured < 2; ++measured) {
    HybridTestWorld world;
    for (int i = 0; i < 5; ++i) {
      btHybridRigidBody* body = world.addCross(btVector3(0.4F * i, 1.9F * i, 0.3F * i));
      body->setLinearVelocity(btVector3(0.1F, -2.0F * i, 0));
      body->setAngularVelocity(btVector3(i, 1, 0));
    }
    for (int step = 0; step < 200; ++step) {
      world.step();
      if (measured == 1) btHybridFidelity(&world.world).measure();
    }
    bits[measured] = world.bits();
  }
  EXPECT_EQ(bits[0], bits[1]);
}

}  // namespace
}  // namespace scatter::test
