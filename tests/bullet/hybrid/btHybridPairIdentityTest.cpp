#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "PairTestWorld.h"

// Where no level changes, pairs and bodies that switch are the same thing.

namespace scatter::test {
namespace {

/// Ships that are drawn together, with plain bodies among them.
class PulledCrowd : public PairTestWorld {
 public:
  PulledCrowd(btHybridSwitchingMode mode, int level) : PairTestWorld(mode, 3) {
    // Body switching takes the threshold from the level's shape, pair switching from the finest.
    dispatcher.setDispatcherFlags(dispatcher.getDispatcherFlags() &
                                  ~btCollisionDispatcher::CD_USE_RELATIVE_CONTACT_BREAKING_THRESHOLD);
    Random random(4);
    for (int i = 0; i < 24; ++i) {
      const btVector3 cell(static_cast<float>(i % 3), static_cast<float>(i / 3 % 3),
                           static_cast<float>(i / 9));
      const btTransform pose(random.rotation(), 3.8F * cell);
      addBody(i % 4 == 3 ? block : ship, pose, 1, level);
    }
    for (int i = 0; i < 4; ++i) {
      add(1, shape<btSphereShape>(btScalar(0.5)), btVector3(static_cast<float>(i) * 2, -3, 1));
    }
    for (auto& body : bodies) body->setAngularVelocity(random.inCube(2));
  }

  [[nodiscard]] int contacts() const {
    int count = 0;
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) count += manifoldAt(i).getNumContacts();
    return count;
  }

  void pull() {
    for (auto& body : bodies) {
      body->applyCentralForce((btVector3(4, 4, 4) - body->getWorldTransform().getOrigin()) * 3);
    }
    step();
  }
};

class LevelIdentity : public testing::TestWithParam<int> {};

TEST_P(LevelIdentity, PairsHeldToALevelAreBodiesAtThatLevel) {
  PulledCrowd byPairs(BT_HYBRID_PAIR_SWITCHING, GetParam());
  PulledCrowd byBodies(BT_HYBRID_BODY_SWITCHING, GetParam());
  int touched = 0;
  for (int step = 0; step < 400; ++step) {
    byPairs.pull();
    byBodies.pull();
    ASSERT_EQ(byPairs.bits(), byBodies.bits()) << "first diverged at step " << step;
    ASSERT_EQ(byPairs.contacts(), byBodies.contacts()) << "step " << step;
    touched = btMax(touched, byPairs.contacts());
  }
  EXPECT_GT(touched, 20);
  EXPECT_GT(byPairs.pairInfo().pairs, 24);
  EXPECT_EQ(byPairs.pairInfo().creditedPairs, 0);
}

// Level 1 is a lone box, which Bullet's own algorithms collide in body switching.
INSTANTIATE_TEST_SUITE_P(Levels, LevelIdentity, testing::Values(2, 3));

TEST(Quiet, NothingIsPlannedWithoutAReason) {
  PulledCrowd w(BT_HYBRID_PAIR_SWITCHING, 3);
  for (int step = 0; step < 200; ++step) {
    w.pull();
    const btHybridPairStepInfo info = w.pairInfo();
    ASSERT_EQ(info.plannedUnits, 0);
    ASSERT_EQ(info.budgetUnits, btHybridBudgetUnits());
    ASSERT_EQ(info.separationQueries, 0);
    ASSERT_EQ(info.audits, 0);
    ASSERT_EQ(info.switchesCoarser + info.switchesFiner, 0);
    ASSERT_EQ(info.finestPairs, info.pairs);
    ASSERT_EQ(info.touchingFinest, info.touchingPairs);
  }
  EXPECT_GT(w.pairInfo().touchingPairs, 10);
}

TEST(Quiet, ComesBackWhenTheReasonsAreGone) {
  PulledCrowd w(BT_HYBRID_PAIR_SWITCHING, 3);
  for (int step = 0; step < 100; ++step) w.pull();
  w.world.setBudgetUnits(10);
  for (int step = 0; step < 60; ++step) w.pull();
  EXPECT_LT(w.pairInfo().finestPairs, w.pairInfo().pairs);
  EXPECT_GT(w.pairInfo().plannedUnits, 0);
  w.world.removeBudget();
  for (auto& body : w.bodies) {
    body->setDamping(0.5F, 0.5F);
  }
  // Apart, every pair goes back.
  for (int step = 0; step < 300; ++step) {
    for (auto& body : w.bodies) {
      body->applyCentralForce((body->getWorldTransform().getOrigin() - btVector3(4, 4, 4)) * 3);
    }
    w.step();
  }
  EXPECT_EQ(w.pairInfo().finestPairs, w.pairInfo().pairs);
  EXPECT_EQ(w.pairInfo().plannedUnits, 0);
}

}  // namespace
}  // namespace scatter::test
