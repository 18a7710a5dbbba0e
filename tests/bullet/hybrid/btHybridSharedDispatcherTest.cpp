#include <BulletCollision/CollisionDispatch/btCollisionDispatcherMt.h>
#include <LinearMath/btThreads.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "MisuseTest.h"

namespace scatter::test {
namespace {

using testing::HasSubstr;

/// Two worlds with one dispatcher.
struct SharedDispatcher {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphases[3];
  btSequentialImpulseConstraintSolver solver;

  std::unique_ptr<btHybridDynamicsWorld> makeWorld(int index,
                                                   btHybridSwitchingMode mode = BT_HYBRID_PAIR_SWITCHING) {
    auto world = std::make_unique<btHybridDynamicsWorld>(&dispatcher, &broadphases[index], &solver,
                                                         &configuration, mode);
    world->setGravity(btVector3(0, 0, 0));
    return world;
  }
};

class SharingTest : public MisuseTest {
 protected:
  /// How many pairs of the world have the pair algorithm, after two bodies have met in it.
  int pairsOf(btHybridDynamicsWorld& world) {
    auto a = body();
    auto b = body(0.9F);
    world.addRigidBody(a.get());
    world.addRigidBody(b.get());
    for (int i = 0; i < 3; ++i) world.stepSimulation(1.0F / 60, 0);
    EXPECT_GT(world.getDispatcher()->getNumManifolds(), 0);
    const int pairs = world.getCollisionMemory().m_pairs;
    world.removeRigidBody(a.get());
    world.removeRigidBody(b.get());
    return pairs;
  }
};

TEST_F(SharingTest, ASecondWorldHasBulletsAlgorithmsAndSaysSo) {
  SharedDispatcher shared;
  auto first = shared.makeWorld(0);
  auto second = shared.makeWorld(1);
  EXPECT_EQ(first->getNarrowphaseMistake(), nullptr);
  EXPECT_THAT(second->getNarrowphaseMistake(), HasSubstr("another btHybridDynamicsWorld"));
  EXPECT_EQ(pairsOf(*first), 1);
  EXPECT_EQ(pairsOf(*second), 0);
  EXPECT_EQ(first->getCollisionMemory().m_pairs, 0) << "the second one's pairs are not the first one's";
  for (const PairCall& call : soundPairCalls()) {
    EXPECT_EQ(call(*first), nullptr);
    EXPECT_THAT(call(*second), HasSubstr("another btHybridDynamicsWorld"));
  }
  auto one = body();
  second->addRigidBody(one.get());
  EXPECT_FALSE(second->requestLevel(one.get(), 1)) << "pairs can not switch there";
  second->removeRigidBody(one.get());
}

TEST_F(SharingTest, TheFirstOnesPairsStayItsOwnWhileTheSecondLives) {
  SharedDispatcher shared;
  auto first = shared.makeWorld(0);
  auto second = shared.makeWorld(1);
  auto a = body();
  auto b = body(0.9F);
  second->addRigidBody(a.get());
  second->addRigidBody(b.get());
  second->stepSimulation(1.0F / 60, 0);
  EXPECT_EQ(first->getCollisionMemory().m_pairs, 0);
  EXPECT_EQ(first->getCollisionMemory().m_bodyBytes, 0U);
  EXPECT_EQ(pairsOf(*first), 1);
  second->removeRigidBody(a.get());
  second->removeRigidBody(b.get());
}

TEST_F(SharingTest, ANewWorldIsSoundAfterTheFirstInEitherOrder) {
  for (const bool firstGoesFirst : {true, false}) {
    SharedDispatcher shared;
    auto first = shared.makeWorld(0);
    auto second = shared.makeWorld(1);
    if (firstGoesFirst) {
      first.reset();
      EXPECT_NE(second->getNarrowphaseMistake(), nullptr) << "it never changes";
      EXPECT_EQ(pairsOf(*second), 0);
    } else {
      second.reset();
      EXPECT_EQ(pairsOf(*first), 1);
      first.reset();
    }
    auto third = shared.makeWorld(2);
    EXPECT_EQ(third->getNarrowphaseMistake(), nullptr);
    EXPECT_EQ(pairsOf(*third), 1);
    second.reset();
    EXPECT_EQ(pairsOf(*third), 1);
    EXPECT_EQ(third->setBudgetUnits(100), nullptr);
  }
}

TEST_F(SharingTest, BodiesStillSwitchInASecondWorld) {
  SharedDispatcher shared;
  auto first = shared.makeWorld(0);
  auto second = shared.makeWorld(1, BT_HYBRID_BODY_SWITCHING);
  auto one = body();
  second->addRigidBody(one.get());
  EXPECT_TRUE(second->requestLevel(one.get(), 1));
  second->stepSimulation(1.0F / 60, 0);
  EXPECT_EQ(one->getLevel(), 1);
  second->removeRigidBody(one.get());
}

TEST_F(SharingTest, ParallelDispatchersAreTold) {
  if (btGetTaskScheduler() == nullptr) btSetTaskScheduler(btGetSequentialTaskScheduler());
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcherMt dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btHybridDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  EXPECT_THAT(world.getNarrowphaseMistake(), HasSubstr("btCollisionDispatcherMt"));
  EXPECT_THAT(world.setBudgetUnits(10), HasSubstr("btCollisionDispatcherMt"));
}

/// The sum of how many steps long each contact of a layer of boxes has been refreshed.
int lifetimesUnderAParallelDispatcher(int threads) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcherMt dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btHybridDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  EXPECT_STREQ(world.setNumThreads(threads), nullptr);
  btBoxShape floor(btVector3(60, 1, 60));
  btBoxShape box(btVector3(0.5F, 0.5F, 0.5F));
  std::vector<std::unique_ptr<btRigidBody>> bodies;
  const auto add = [&](float mass, btBoxShape& shape, const btVector3& place) {
    bodies.push_back(std::make_unique<btRigidBody>(mass, nullptr, &shape, btVector3(1, 1, 1)));
    bodies.back()->setWorldTransform(btTransform(btQuaternion::getIdentity(), place));
    world.addRigidBody(bodies.back().get());
  };
  add(0, floor, btVector3(0, -1, 0));
  for (int i = 0; i < 100; ++i)
    add(1, box, btVector3(static_cast<float>(i % 10) * 2, 0.49F, static_cast<float>(i) / 5));
  for (int step = 0; step < 60; ++step) world.stepSimulation(1.0F / 60, 0);
  int lifetimes = 0;
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
    for (int k = 0; k < manifold.getNumContacts(); ++k)
      lifetimes += manifold.getContactPoint(k).getLifeTime();
  }
  for (auto& body : bodies) world.removeRigidBody(body.get());
  return lifetimes;
}

// It takes every pair from Bullet's array, whatever has been done with it.
TEST_F(SharingTest, ParallelDispatchersHavePairsOfBoxesToThemselves) {
  if (btGetTaskScheduler() == nullptr) btSetTaskScheduler(btGetSequentialTaskScheduler());
  const int alone = lifetimesUnderAParallelDispatcher(1);
  EXPECT_GT(alone, 1000);
  EXPECT_EQ(lifetimesUnderAParallelDispatcher(3), alone);
}

}  // namespace
}  // namespace scatter::test
