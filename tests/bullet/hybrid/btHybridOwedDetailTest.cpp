#include <gtest/gtest.h>

#include <algorithm>

#include "PairTestWorld.h"

// What has fallen asleep without its detail wakes for it when a budget has room for it again.

namespace scatter::test {
namespace {

/// Two stacks of blocks that have come to rest with a budget that leaves them next to no detail.
class Stacks : public PairTestWorld {
 public:
  Stacks() {
    world.setGravity(btVector3(0, -10, 0));
    addFloor();
    for (int i = 0; i < 8; ++i) {
      const btVector3 at(3.0F * static_cast<float>(i % 2), 0.8F + 1.5F * static_cast<float>(i / 2), 0);
      addBody(block, btTransform(btQuaternion::getIdentity(), at))->forceActivationState(ACTIVE_TAG);
    }
    world.setBudgetUnits(30);
  }

  /// So many steps at most, until all are asleep. Whether they are, and how many were woken for a budget.
  bool sleeps(int steps) {
    woken = 0;
    for (int i = 0; i < steps && countAwake() > 0; ++i) {
      step();
      woken += pairInfo().wokenBodies;
    }
    return countAwake() == 0;
  }

  /// Bodies that are woken within two seconds.
  int wakes() {
    woken = 0;
    for (int i = 0; i < 120 && woken == 0; ++i) {
      step();
      woken += pairInfo().wokenBodies;
    }
    return woken;
  }

  [[nodiscard]] int countCoarse() const {
    btAlignedObjectArray<btHybridCoarserObject> objects;
    world.viewCoarserObjects(objects);
    return objects.size();
  }

  int woken = 0;

 private:
  [[nodiscard]] int countAwake() const {
    return static_cast<int>(std::ranges::count_if(
        bodies, [](const auto& body) { return body->isActive() && !body->isStaticOrKinematicObject(); }));
  }
};

TEST(OwedDetail, IsGivenBackToWhatSleeps) {
  Stacks w;
  ASSERT_TRUE(w.sleeps(3000));
  ASSERT_GT(w.countCoarse(), 0);
  EXPECT_EQ(w.woken, 0) << "there is no room";
  w.world.setBudgetUnits(1e6);
  EXPECT_GT(w.wakes(), 0);
  ASSERT_TRUE(w.sleeps(3000));
  EXPECT_EQ(w.countCoarse(), 0);
  EXPECT_EQ(w.wakes(), 0);
}

// Islands are made of what is near each other: what wakes beside a stack is part of what that takes.
TEST(OwedDetail, IsForIslandsThatMayWakeAsAWhole) {
  Stacks w;
  ASSERT_EQ(w.world.addPolicy("held"), nullptr);
  btHybridRigidBody* const neighbour = w.addBlock(btVector3(-1.3F, 0.5F, 0));
  neighbour->forceActivationState(ACTIVE_TAG);
  neighbour->setHeld(true);
  ASSERT_TRUE(w.sleeps(3000));
  EXPECT_EQ(w.world.getPairLevel(neighbour, w.bodies[1].get()), 3) << "it is owed nothing";
  w.world.setBudgetUnits(1e6);
  EXPECT_EQ(w.wakes(), 9);
}

TEST(OwedDetail, IsGivenBackWithoutABudget) {
  Stacks w;
  ASSERT_TRUE(w.sleeps(3000));
  w.world.removeBudget();
  EXPECT_GT(w.wakes(), 0);
  ASSERT_TRUE(w.sleeps(3000));
  EXPECT_EQ(w.countCoarse(), 0);
}

TEST(OwedDetail, WakesNobodyWhereTheProgramDoesNotWantIt) {
  Stacks w;
  w.world.getPairSwitchingInfo().m_wakesForDetail = false;
  ASSERT_TRUE(w.sleeps(3000));
  const int coarse = w.countCoarse();
  w.world.setBudgetUnits(1e6);
  EXPECT_EQ(w.wakes(), 0);
  EXPECT_TRUE(w.sleeps(1));
  EXPECT_EQ(w.countCoarse(), coarse);
}

}  // namespace
}  // namespace scatter::test
