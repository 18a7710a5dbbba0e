#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "PairTestWorld.h"

// Bodies that lie still fall asleep sooner while a budget gives something up.

namespace scatter::test {
namespace {

/// A plain box on the floor, and a hybrid out of its reach, with which the world plans.
class Resting : public PairTestWorld {
 public:
  Resting() {
    world.setGravity(btVector3(0, -10, 0));
    addFloor()->setFriction(0);
    addBlock({20, 30, 0})->setGravity(btVector3(0, 0, 0));
    box_ = add(1, shape<btBoxShape>(btVector3(0.5F, 0.5F, 0.5F)), {0, 0.5F, 0});
    box_->setFriction(0);
    for (int i = 0; i < 60; ++i) step();
  }

  /// Steps until the box is asleep, from its being awake on, if it slides so fast.
  int stepsUntilAsleep(float speed = 0.0F) {
    box_->forceActivationState(ACTIVE_TAG);
    box_->setDeactivationTime(0);
    box_->setLinearVelocity({speed, 0, 0});
    int steps = 0;
    resting = 0;
    for (; box_->isActive() && steps < 300; ++steps) {
      step();
      resting += pairInfo().restingBodies;
      if (pairInfo().restingBodies > 0) said = scatter::describe(world.getBudgetState());
    }
    return steps;
  }

  int resting = 0;     ///< Over these steps, bodies that were counted,
  std::string said{};  ///< and what was said of the last one.

 private:
  btRigidBody* box_;
};

constexpr int kTwoSeconds = 120;

TEST(EarlyRest, ComesAfterHalfASecondWhileABudgetIsShort) {
  Resting w;
  EXPECT_NEAR(w.stepsUntilAsleep(), kTwoSeconds, 3);
  EXPECT_EQ(w.resting, 0);
  w.world.setBudgetUnits(1);
  EXPECT_NEAR(w.stepsUntilAsleep(), kTwoSeconds / 4, 3);
  EXPECT_GE(w.resting, kTwoSeconds / 4 - 3);
  EXPECT_THAT(w.said, ::testing::HasSubstr("1 bodies fall asleep sooner"));
}

TEST(EarlyRest, DoesNotComeWhileThereIsRoom) {
  Resting w;
  w.world.setBudgetUnits(1e6);
  EXPECT_NEAR(w.stepsUntilAsleep(), kTwoSeconds, 3);
  EXPECT_EQ(w.resting, 0);
}

TEST(EarlyRest, DoesNotComeWhereTheProgramDoesNotWantIt) {
  Resting w;
  w.world.getPairSwitchingInfo().m_earlyRest = false;
  w.world.setBudgetUnits(1);
  EXPECT_NEAR(w.stepsUntilAsleep(), kTwoSeconds, 3);
  EXPECT_EQ(w.resting, 0);
}

TEST(EarlyRest, DoesNotComeToWhatCanBeSeenToMove) {
  Resting w;
  w.world.setBudgetUnits(1);
  EXPECT_NEAR(w.stepsUntilAsleep(0.1F), kTwoSeconds, 3);
  EXPECT_LT(w.stepsUntilAsleep(0.04F), kTwoSeconds / 2);
}

TEST(EarlyRest, EndsWithTheBodiesThatSwitch) {
  Resting w;
  w.world.setBudgetUnits(1);
  w.stepsUntilAsleep();
  w.world.removeRigidBody(w.world.getHybrid(0));
  EXPECT_NEAR(w.stepsUntilAsleep(), kTwoSeconds, 3);
}

TEST(EarlyRest, LetsThoseAloneThatNeverSleep) {
  Resting w;
  w.world.setBudgetUnits(1);
  btRigidBody* box = w.add(1, w.shape<btBoxShape>(btVector3(0.5F, 0.5F, 0.5F)), {5, 0.5F, 0});
  box->setActivationState(DISABLE_DEACTIVATION);
  for (int i = 0; i < 300; ++i) w.step();
  EXPECT_TRUE(box->isActive());
  EXPECT_EQ(box->getDeactivationTime(), 0.0F);
}

}  // namespace
}  // namespace scatter::test
