#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <climits>
#include <functional>

#include "HybridTestWorld.h"
#include "MisuseTest.h"
#include "NotFinite.h"
#include "PairTestWorld.h"

namespace scatter::test {
namespace {

using testing::HasSubstr;

TEST_F(MisuseTest, PairCallsSayThatBodiesSwitch) {
  LooseWorld w(BT_HYBRID_BODY_SWITCHING);
  for (const PairCall& call : soundPairCalls()) {
    const char* mistake = call(*w);
    ASSERT_NE(mistake, nullptr);
    EXPECT_THAT(mistake, HasSubstr("bodies switch"));
  }
  EXPECT_EQ(w->setSwitchingMode(BT_HYBRID_PAIR_SWITCHING), 0);
  for (const PairCall& call : soundPairCalls()) EXPECT_EQ(call(*w), nullptr);
}

TEST_F(MisuseTest, BudgetsThatMakeNoSenseAreRefused) {
  LooseWorld w;
  auto one = body();
  w->addRigidBody(one.get());
  ASSERT_EQ(w->setBudgetUnits(1234), nullptr);
  constexpr double kNo = std::numeric_limits<double>::quiet_NaN();
  constexpr double kAll = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, kNo, kAll, -kAll}) {
    EXPECT_THAT(w->setBudgetMilliseconds(bad), HasSubstr("finite number of milliseconds")) << bad;
    EXPECT_THAT(w->setBudgetUnits(bad), HasSubstr("finite number of units")) << bad;
    const double units[] = {1, bad};
    EXPECT_THAT(w->setBudgetMilliseconds(bad, units, 1), HasSubstr("finite number of milliseconds")) << bad;
    EXPECT_THAT(w->setBudgetMilliseconds(4, units, 2), HasSubstr("above 0 for a unit of every step")) << bad;
    for (const btHybridBudgetUnits& step : {btHybridBudgetUnits{bad, 1, 1}, {1, bad, 1}, {1, 1, bad}}) {
      if (bad == 0.0) continue;
      const btHybridBudgetUnits steps[] = {{1, 1, 1}, step};
      EXPECT_THAT(w->replayBudget(steps, 2), HasSubstr("finite units")) << bad;
    }
  }
  const double sound[] = {1, 2};
  const btHybridBudgetUnits step{1, 1, 1};
  EXPECT_NE(w->replayBudget(nullptr, 2), nullptr);
  EXPECT_NE(w->replayBudget(&step, 0), nullptr);
  EXPECT_NE(w->replayBudget(&step, -1), nullptr);
  EXPECT_THAT(w->setBudgetMilliseconds(4, nullptr, 2), HasSubstr("at least one step"));
  EXPECT_THAT(w->setBudgetMilliseconds(4, sound, 0), HasSubstr("at least one step"));
  w.step();
  EXPECT_EQ(w->getPairStepInfo().budgetUnits.given, 1234) << "nothing has changed";
}

TEST_F(MisuseTest, ReplayedStepsWithoutBudgetAreReportedAsSuch) {
  LooseWorld w;
  auto one = body();
  w->addRigidBody(one.get());
  const btHybridBudgetUnits steps[] = {{}, {.given = 70}};
  ASSERT_EQ(w->replayBudget(steps, 2), nullptr);
  w.step();
  EXPECT_EQ(w->getPairStepInfo().budgetUnits, btHybridBudgetUnits());
  w.step();
  EXPECT_EQ(w->getPairStepInfo().budgetUnits, (btHybridBudgetUnits{70, 70, 70}));
}

TEST_F(MisuseTest, PoliciesAndFocusThatMakeNoSenseAreRefused) {
  LooseWorld w;
  EXPECT_THAT(w->addPolicy(nullptr), HasSubstr("needs a name"));
  EXPECT_THAT(w->checkPolicy(nullptr), HasSubstr("needs a name"));
  EXPECT_NE(w->addPolicy(""), nullptr);
  EXPECT_NE(w->addPolicy("speed:from=nan"), nullptr);
  const btVector3 eye(0, 0, 0);
  const btVector3 target(1, 0, 0);
  for (const float bad : {kNaN, kInfinity, -kInfinity}) {
    EXPECT_THAT(w->setFocus({bad, 0, 0}, target, 1), HasSubstr("finite"));
    EXPECT_THAT(w->setFocus(eye, {0, bad, 0}, 1), HasSubstr("finite"));
    EXPECT_THAT(w->setFocus(eye, target, bad), HasSubstr("field of view"));
  }
  EXPECT_THAT(w->setFocus(eye, target, 0), HasSubstr("field of view"));
  EXPECT_THAT(w->setFocus(eye, target, 3.2F), HasSubstr("field of view"));
}

TEST_F(MisuseTest, PairSettingsAreKeptWhileBodiesSwitch) {
  LooseWorld w(BT_HYBRID_BODY_SWITCHING);
  w->getPairSwitchingInfo().m_creditLevel = 7;
  w.step();
  EXPECT_EQ(w->setSwitchingMode(BT_HYBRID_PAIR_SWITCHING), 0);
  EXPECT_EQ(w->getPairSwitchingInfo().m_creditLevel, 7);
  EXPECT_EQ(w->setSwitchingMode(BT_HYBRID_BODY_SWITCHING), 0);
  EXPECT_EQ(w->getPairSwitchingInfo().m_creditLevel, 2) << "they start anew";
}

/// Blocks at rest on each other under a budget that only credit can keep; the coarsest level seen.
int coarsestUnderPressure(int creditLevel, bool isSetAfterwards) {
  PairTestWorld w;
  w.addFloor();
  for (int i = 0; i < 4; ++i) w.addBlock({0, 0.5F + static_cast<float>(i), 0});
  for (int i = 0; i < 60; ++i) w.step();
  if (!isSetAfterwards) w.world.getPairSwitchingInfo().m_creditLevel = creditLevel;
  w.world.setBudgetUnits(10);
  if (isSetAfterwards) w.world.getPairSwitchingInfo().m_creditLevel = creditLevel;
  int coarsest = 3;
  for (int i = 0; i < 60; ++i) {
    w.step();
    for (int k = 0; k + 1 < w.world.getNumHybrids(); ++k) {
      const int level = w.levelOf(w.world.getHybrid(k), w.world.getHybrid(k + 1));
      if (level > 0) coarsest = std::min(coarsest, level);
    }
  }
  return coarsest;
}

TEST_F(MisuseTest, TheCreditLevelIsHeardAfterTheBudget) {
  ASSERT_EQ(coarsestUnderPressure(1, false), 1);
  ASSERT_EQ(coarsestUnderPressure(2, false), 2);
  EXPECT_EQ(coarsestUnderPressure(1, true), 1);
}

TEST_F(MisuseTest, CreditLevelsOutOfRangeActAsTheNearest) {
  EXPECT_EQ(coarsestUnderPressure(INT_MIN, false), 1);
  EXPECT_EQ(coarsestUnderPressure(INT_MAX, false), 2);
}

/// How many tries of a finer level are blocked in 40 steps of two blocks that overlap deeply and are coarse.
int blockedTries(const std::function<void(btHybridPairSwitchingInfo&)>& change) {
  PairTestWorld w;
  w.world.setGravity(btVector3(0, 0, 0));
  btHybridRigidBody* a = w.addBlock({0, 0, 0}, 0);
  btHybridRigidBody* b = w.addBlock({1.45F, 0, 0});
  w.requestAll(1);
  w.step();
  EXPECT_EQ(w.levelOf(a, b), 1);
  b->setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0.5F, 0, 0)));
  b->setLinearFactor(btVector3(0, 0, 0));
  b->setAngularFactor(0);
  w.world.getPairSwitchingInfo().m_safetyConditions = true;
  change(w.world.getPairSwitchingInfo());
  w.requestAll(3);
  int tries = 0;
  for (int i = 0; i < 40; ++i) {
    w.step();
    tries += w.pairInfo().blockedTries;
  }
  return tries;
}

TEST_F(MisuseTest, RetryIntervalsOfPairsOutOfRangeActAsTheNearest) {
  const int often = blockedTries([](btHybridPairSwitchingInfo& info) { info.m_retryInterval = 1; });
  const int seldom = blockedTries([](btHybridPairSwitchingInfo& info) { info.m_retryInterval = 255; });
  EXPECT_GT(often, seldom);
  for (const int interval : {0, -1, INT_MIN}) {
    EXPECT_EQ(blockedTries([=](btHybridPairSwitchingInfo& info) { info.m_retryInterval = interval; }), often);
  }
  for (const int interval : {256, 1000000, INT_MAX}) {
    EXPECT_EQ(blockedTries([=](btHybridPairSwitchingInfo& info) { info.m_retryInterval = interval; }),
              seldom);
  }
}

/// Audits of a block that is drawn over another one while their pair is on credit.
int auditsOf(float distance) {
  PairTestWorld w;
  w.addFloor();
  btHybridRigidBody* lower = w.addBlock({0, 0.5F, 0}, 0);
  btHybridRigidBody* upper = w.addBlock({0, 1.5F, 0});
  for (int i = 0; i < 30; ++i) w.step();
  w.world.getPairSwitchingInfo().m_auditDistance = distance;
  w.world.requestLevel(upper, 2);
  int audits = 0;
  for (int i = 0; i < 60; ++i) {
    upper->setLinearVelocity(btVector3(0.3F, 0, 0));
    w.step();
    audits += w.pairInfo().audits;
  }
  EXPECT_LT(w.levelOf(lower, upper), 3);
  return audits;
}

TEST_F(MisuseTest, AuditDistancesThatMakeNoSenseMeanNever) {
  EXPECT_GT(auditsOf(0.03F), 0);
  for (const float distance : {0.0F, -1.0F, kNaN, -kInfinity}) EXPECT_EQ(auditsOf(distance), 0) << distance;
  EXPECT_EQ(auditsOf(kInfinity), auditsOf(1000));
}

/// The level of a cross that is asked for level 1 beside another, at this distance, after five steps of body
/// switching.
int levelBeside(float distance, const std::function<void(btHybridSwitchingInfo&)>& change) {
  HybridTestWorld w;
  btHybridRigidBody* body = w.addCross({0, 0, 0});
  w.addCross({2 + distance, 0, 0}, 1);
  change(w.world.getSwitchingInfo());
  w.world.requestLevel(body, 1);
  w.steps(5);
  EXPECT_GE(w.world.viewRequest(body).m_retrySteps, body->getRequest().isStanding() ? 1 : 0);
  return body->getLevel();
}

TEST_F(MisuseTest, SafetyGapsThatMakeNoSenseActAsTheNearest) {
  for (const float gap : {-5.0F, kNaN, -kInfinity}) {
    const auto change = [=](btHybridSwitchingInfo& info) { info.m_safetyGap = gap; };
    EXPECT_EQ(levelBeside(0.005F, change), 1) << gap;
    EXPECT_EQ(levelBeside(-0.005F, change), 3) << gap;
  }
  EXPECT_EQ(levelBeside(3, [](btHybridSwitchingInfo& info) { info.m_safetyGap = kInfinity; }), 3);
  EXPECT_EQ(levelBeside(3, [](btHybridSwitchingInfo& info) { info.m_safetyGap = 1e30F; }), 3);
}

TEST_F(MisuseTest, RetryIntervalsOfBodiesOutOfRangeActAsTheNearest) {
  for (const int interval : {INT_MIN, -1, 0, 1, INT_MAX}) {
    EXPECT_EQ(levelBeside(-0.1F, [=](btHybridSwitchingInfo& info) { info.m_retryInterval = interval; }), 3);
  }
}

/// In how many steps a lonely cross of level 1 is finest, with another one far away that flies by.
int stepsUntilFinest(const std::function<void(btHybridSwitchingInfo&)>& change) {
  HybridTestWorld w;
  w.world.getSwitchingInfo().m_proximity = true;
  btHybridRigidBody* body = w.addCross({0, 0, 0}, 1);
  w.addCross({20, 0, 0}, 3)->setLinearVelocity(btVector3(0, 5, 0));
  change(w.world.getSwitchingInfo());
  for (int i = 1; i < 100; ++i) {
    w.step();
    if (body->getLevel() == 3) return i;
  }
  return 100;
}

TEST_F(MisuseTest, ProximityOutOfRangeActsAsTheNearest) {
  const auto quiet = [](int steps) {
    return [=](btHybridSwitchingInfo& info) { info.m_quietSteps = steps; };
  };
  EXPECT_EQ(stepsUntilFinest(quiet(5)), 5);
  for (const int steps : {1, 0, -1, INT_MIN}) EXPECT_EQ(stepsUntilFinest(quiet(steps)), 1);
  const auto proximity = [](float steps) {
    return [=](btHybridSwitchingInfo& info) { info.m_proximitySteps = steps; };
  };
  const int usual = stepsUntilFinest(proximity(0));
  for (const float steps : {-0.5F, -1000.0F, kNaN, -kInfinity})
    EXPECT_EQ(stepsUntilFinest(proximity(steps)), usual);
  EXPECT_EQ(stepsUntilFinest(proximity(kInfinity)), 100) << "there always is a neighbour";
}

}  // namespace
}  // namespace scatter::test
