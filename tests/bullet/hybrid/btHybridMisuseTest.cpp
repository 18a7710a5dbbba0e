#include <BulletCollision/CollisionDispatch/btCollisionDispatcherMt.h>
#include <BulletHybrid/btHybridFidelity.h>
#include <BulletHybrid/btHybridSeparation.h>
#include <LinearMath/btThreads.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <climits>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "NotFinite.h"
#include "PairTestWorld.h"

namespace scatter::test {
namespace {

using testing::HasSubstr;

/// A hybrid world and a body that it does not own.
class LooseWorld {
 public:
  explicit LooseWorld(btHybridSwitchingMode mode = BT_HYBRID_PAIR_SWITCHING)
      : world_(std::make_unique<btHybridDynamicsWorld>(&dispatcher_, &broadphase_, &solver_, &configuration_,
                                                       mode)) {
    world_->setGravity(btVector3(0, 0, 0));
    world_->getSwitchingInfo().m_proximity = false;
  }

  btHybridDynamicsWorld& operator*() { return *world_; }
  btHybridDynamicsWorld* operator->() { return world_.get(); }
  btHybridDynamicsWorld* get() { return world_.get(); }
  void end() { world_.reset(); }
  btCollisionDispatcher& dispatcher() { return dispatcher_; }
  void step() { world_->stepSimulation(1.0F / 60, 0); }

 private:
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  std::unique_ptr<btHybridDynamicsWorld> world_;
};

/// Levels for bodies of any world: two crossing bars in the cube around them.
class MisuseTest : public testing::Test {
 protected:
  MisuseTest() {
    bars_.addChildShape(btTransform::getIdentity(), &barX_);
    bars_.addChildShape(btTransform::getIdentity(), &barZ_);
    levels_.addLevel(&cube_);
    levels_.addLevel(&bars_);
  }

  static btRigidBody::btRigidBodyConstructionInfo info(btCollisionShape* shape, float x = 0) {
    btRigidBody::btRigidBodyConstructionInfo result(1, nullptr, shape, btVector3(1, 1, 1));
    result.m_startWorldTransform.setOrigin(btVector3(x, 0, 0));
    return result;
  }

  std::unique_ptr<btHybridRigidBody> body(float x = 0) {
    auto made = std::make_unique<btHybridRigidBody>(info(nullptr, x), &levels_);
    made->setActivationState(DISABLE_DEACTIVATION);
    return made;
  }

  btBoxShape cube_{btVector3(1, 1, 1)};
  btBoxShape barX_{btVector3(1, 0.2F, 0.2F)};
  btBoxShape barZ_{btVector3(0.2F, 0.2F, 1)};
  btCompoundShape bars_;
  btHybridLevelSet levels_;
};

using PairCall = std::function<const char*(btHybridDynamicsWorld&)>;

/// Every call of pair switching that can be refused, with arguments that are sound.
std::vector<PairCall> soundPairCalls() {
  return {
      [](btHybridDynamicsWorld& w) { return w.setBudgetMilliseconds(4); },
      [](btHybridDynamicsWorld& w) { return w.setBudgetUnits(4); },
      [](btHybridDynamicsWorld& w) {
        const double units[] = {3, 0, 5};
        return w.replayBudget(units, 3);
      },
      [](btHybridDynamicsWorld& w) { return w.removeBudget(); },
      [](btHybridDynamicsWorld& w) { return w.addPolicy("speed"); },
      [](btHybridDynamicsWorld& w) { return w.checkPolicy("speed"); },
      [](btHybridDynamicsWorld& w) { return w.removePolicies(); },
      [](btHybridDynamicsWorld& w) {
        return w.setFocus({0, 0, 0}, {1, 0, 0}, 1);
      },
      [](btHybridDynamicsWorld& w) { return w.removeFocus(); },
  };
}

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
    if (bad != 0.0) {
      EXPECT_THAT(w->replayBudget(units, 2), HasSubstr("finite units")) << bad;
    }
  }
  const double sound[] = {1, 2};
  EXPECT_NE(w->replayBudget(nullptr, 2), nullptr);
  EXPECT_NE(w->replayBudget(sound, 0), nullptr);
  EXPECT_NE(w->replayBudget(sound, -1), nullptr);
  w.step();
  EXPECT_EQ(w->getPairStepInfo().m_budgetUnits, 1234) << "nothing has changed";
}

TEST_F(MisuseTest, ReplayedStepsWithoutBudgetAreReportedAsSuch) {
  LooseWorld w;
  auto one = body();
  w->addRigidBody(one.get());
  const double units[] = {0, 70};
  ASSERT_EQ(w->replayBudget(units, 2), nullptr);
  w.step();
  EXPECT_EQ(w->getPairStepInfo().m_budgetUnits, 0);
  w.step();
  EXPECT_EQ(w->getPairStepInfo().m_budgetUnits, 70);
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
    tries += w.pairInfo().m_blockedTries;
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
    audits += w.pairInfo().m_audits;
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

// Bodies without levels.

TEST_F(MisuseTest, WithoutLevelsItIsAnOrdinaryBody) {
  const btHybridLevelSet none;
  btSphereShape ball(1);
  for (const btHybridLevelSet* levels : {&none, static_cast<const btHybridLevelSet*>(nullptr)}) {
    for (const btHybridSwitchingMode mode : {BT_HYBRID_PAIR_SWITCHING, BT_HYBRID_BODY_SWITCHING}) {
      LooseWorld w(mode);
      w->getSwitchingInfo().m_proximity = true;
      btHybridRigidBody plain(info(&ball), levels, 3);
      EXPECT_EQ(plain.getCollisionShape(), &ball);
      EXPECT_EQ(plain.getFinestLevel(), 0);
      EXPECT_EQ(plain.getLevel(), 0);
      EXPECT_EQ(plain.getLevels().getNumLevels(), 0);
      EXPECT_EQ(btHybridRigidBody::upcast(&plain), nullptr);
      auto other = body(1.5F);
      w->addRigidBody(&plain);
      w->addRigidBody(other.get());
      EXPECT_EQ(plain.getWorld(), w.get());
      EXPECT_EQ(w->getNumHybrids(), 1);
      EXPECT_FALSE(w->requestLevel(&plain, 1));
      for (int i = 0; i < 20; ++i) w.step();
      EXPECT_LT(plain.getWorldTransform().getOrigin().x(), 0) << "pushed by the other";
      EXPECT_GT(w->getPairLevel(&plain, other.get()), 0);
      btHybridFidelity(w.get()).measure();
      w->verifyContacts(1);
      w.step();
      EXPECT_EQ(w->getContactReport().m_missed, 0);
      w->setSwitchingMode(mode == BT_HYBRID_PAIR_SWITCHING ? BT_HYBRID_BODY_SWITCHING
                                                           : BT_HYBRID_PAIR_SWITCHING);
      w.step();
      w->removeRigidBody(&plain);
      EXPECT_EQ(plain.getWorld(), nullptr);
    }
  }
}

TEST_F(MisuseTest, WithoutLevelsAndShapeItIsEmpty) {
  LooseWorld w;
  btHybridRigidBody nothing(info(nullptr), nullptr);
  ASSERT_NE(nothing.getCollisionShape(), nullptr);
  EXPECT_EQ(nothing.getCollisionShape()->getShapeType(), EMPTY_SHAPE_PROXYTYPE);
  auto other = body(0.5F);
  w->addRigidBody(&nothing);
  w->addRigidBody(other.get());
  for (int i = 0; i < 5; ++i) w.step();
  EXPECT_EQ(other->getWorldTransform().getOrigin(), btVector3(0.5F, 0, 0));
}

TEST_F(MisuseTest, StartLevelsOutOfRangeActAsTheNearest) {
  const auto levelOf = [this](int start) {
    return btHybridRigidBody(info(nullptr), &levels_, start).getLevel();
  };
  EXPECT_EQ(levelOf(0), 2);
  EXPECT_EQ(levelOf(1), 1);
  EXPECT_EQ(levelOf(3), 2);
  EXPECT_EQ(levelOf(INT_MAX), 2);
  EXPECT_EQ(levelOf(-1), 1);
  EXPECT_EQ(levelOf(INT_MIN), 1);
}

TEST_F(MisuseTest, LevelsThatComeLaterAreForBodiesThatComeLater) {
  LooseWorld w;
  auto a = body(0);
  auto b = body(0.9F);
  w->addRigidBody(a.get());
  w->addRigidBody(b.get());
  w.step();
  btBoxShape small(btVector3(0.1F, 0.1F, 0.1F));
  for (int i = 0; i < 50; ++i) ASSERT_EQ(levels_.addLevel(&small), nullptr);
  EXPECT_EQ(a->getFinestLevel(), 2);
  EXPECT_FALSE(w->requestLevel(a.get(), 3));
  EXPECT_TRUE(w->requestLevel(a.get(), 1));
  for (int i = 0; i < 20; ++i) w.step();
  EXPECT_EQ(w->getPairLevel(a.get(), b.get()), 1);
  EXPECT_EQ(body()->getFinestLevel(), 52);
}

// Bodies and worlds.

TEST_F(MisuseTest, ABodyKnowsItsWorld) {
  LooseWorld w;
  auto one = body();
  EXPECT_EQ(one->getWorld(), nullptr);
  w->addRigidBody(one.get());
  EXPECT_EQ(one->getWorld(), w.get());
  w->removeCollisionObject(one.get());
  EXPECT_EQ(one->getWorld(), nullptr);
  w->addRigidBody(one.get(), 1, -1);
  EXPECT_EQ(one->getWorld(), w.get());
  w.end();
  EXPECT_EQ(one->getWorld(), nullptr);
}

TEST_F(MisuseTest, RequestsEndWithTheirWorld) {
  for (const btHybridSwitchingMode mode : {BT_HYBRID_PAIR_SWITCHING, BT_HYBRID_BODY_SWITCHING}) {
    auto one = body();
    EventLog log;
    LooseWorld first(mode);
    first->setListener(&log);
    first->addRigidBody(one.get());
    ASSERT_TRUE(first->requestLevel(one.get(), 1));
    const std::size_t heard = log.entries.size();
    first.end();
    EXPECT_FALSE(one->getRequest().isStanding());
    EXPECT_EQ(log.entries.size(), heard) << "a world that ends tells nobody";
    LooseWorld second(mode);
    second->addRigidBody(one.get());
    EXPECT_EQ(second->getRefusal(), nullptr);
    EXPECT_FALSE(second->retractRequest(one.get()));
    second.step();
    EXPECT_EQ(second->getStepInfo().m_standingRequests, 0);
    second->removeRigidBody(one.get());
  }
}

TEST_F(MisuseTest, BodiesOfOtherWorldsAreLeftAlone) {
  LooseWorld own;
  LooseWorld other;
  auto alien = body();
  auto alienToo = body(0.5F);
  auto free = body();
  auto member = body();
  own->addRigidBody(member.get());
  other->addRigidBody(alien.get());
  other->addRigidBody(alienToo.get());
  other.step();
  ASSERT_TRUE(other->requestLevel(alien.get(), 1));
  ASSERT_TRUE(other->setHeld(alien.get(), true));
  for (btHybridRigidBody* body : {alien.get(), free.get(), static_cast<btHybridRigidBody*>(nullptr)}) {
    EXPECT_FALSE(own->requestLevel(body, 1));
    EXPECT_FALSE(own->retractRequest(body));
    EXPECT_FALSE(own->setHeld(body, true));
    EXPECT_FALSE(own->setHeld(body, false));
    EXPECT_EQ(own->viewRequest(body).m_targetLevel, 0);
    EXPECT_EQ(own->getPairLevel(body, member.get()), 0);
    EXPECT_EQ(own->getPairLevel(member.get(), body), 0);
  }
  EXPECT_EQ(own->getPairLevel(alien.get(), alienToo.get()), 0);
  EXPECT_GT(other->getPairLevel(alien.get(), alienToo.get()), 0);
  EXPECT_TRUE(alien->getRequest().isStanding());
  EXPECT_TRUE(alien->isHeld());
  EXPECT_TRUE(other->retractRequest(alien.get()));
  EXPECT_FALSE(other->retractRequest(alien.get())) << "none stands";
  own.step();
  EXPECT_EQ(own->getStepInfo().m_standingRequests, 0);
  EXPECT_EQ(own->getStepInfo().m_retractions, 0);
}

TEST_F(MisuseTest, RequestsForLevelsThatAreNotThereAreRefused) {
  LooseWorld w;
  auto one = body();
  w->addRigidBody(one.get());
  for (const int level : {0, -1, 3, INT_MIN, INT_MAX})
    EXPECT_FALSE(w->requestLevel(one.get(), level)) << level;
  EXPECT_TRUE(w->requestLevel(one.get(), 2));
}

TEST_F(MisuseTest, WhatLeavesIsNotHeld) {
  LooseWorld w;
  auto one = body();
  w->addRigidBody(one.get());
  EXPECT_TRUE(w->setHeld(one.get(), true));
  w->removeRigidBody(one.get());
  EXPECT_FALSE(one->isHeld());
}

TEST_F(MisuseTest, ABodyIsInOneWorldOnce) {
  LooseWorld own;
  LooseWorld other;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld bullets(&dispatcher, &broadphase, &solver, &configuration);
  auto one = body();
  btRigidBody plain(info(&cube_));
  btCollisionObject object;
  object.setCollisionShape(&cube_);
  own->addRigidBody(one.get());
  own->addRigidBody(&plain);
  own->addCollisionObject(&object);
  EXPECT_EQ(own->getRefusal(), nullptr);
  for (btRigidBody* body : {static_cast<btRigidBody*>(one.get()), &plain}) {
    own->addRigidBody(body);
    EXPECT_THAT(own->getRefusal(), HasSubstr("twice"));
    own->addRigidBody(body, 1, -1);
    EXPECT_THAT(own->getRefusal(), HasSubstr("twice"));
    other->addRigidBody(body);
    EXPECT_THAT(other->getRefusal(), HasSubstr("another world"));
    other->addRigidBody(body, 1, -1);
    EXPECT_THAT(other->getRefusal(), HasSubstr("another world"));
    other->removeRigidBody(body);
    EXPECT_THAT(other->getRefusal(), HasSubstr("not in"));
    other->removeCollisionObject(body);
    EXPECT_THAT(other->getRefusal(), HasSubstr("not in"));
  }
  other->addCollisionObject(&object);
  EXPECT_THAT(other->getRefusal(), HasSubstr("another world"));
  other->removeCollisionObject(&object);
  EXPECT_THAT(other->getRefusal(), HasSubstr("not in"));
  for (LooseWorld* w : {&own, &other}) {
    (*w)->addRigidBody(nullptr);
    EXPECT_NE((*w)->getRefusal(), nullptr);
    (*w)->removeRigidBody(nullptr);
    EXPECT_NE((*w)->getRefusal(), nullptr);
    (*w)->removeCollisionObject(nullptr);
    EXPECT_NE((*w)->getRefusal(), nullptr);
  }
  EXPECT_EQ(own->getNumCollisionObjects(), 3);
  EXPECT_EQ(other->getNumCollisionObjects(), 0);
  EXPECT_EQ(one->getWorld(), own.get());
  own.step();
  other.step();
  own->removeRigidBody(one.get());
  EXPECT_EQ(own->getRefusal(), nullptr);
  bullets.addRigidBody(one.get());
  other->addRigidBody(one.get());
  EXPECT_THAT(other->getRefusal(), HasSubstr("another world"));
  EXPECT_EQ(one->getWorld(), nullptr);
  bullets.removeRigidBody(one.get());
  other->addRigidBody(one.get());
  EXPECT_EQ(other->getRefusal(), nullptr);
  EXPECT_EQ(one->getWorld(), other.get());
  own->removeRigidBody(&plain);
  own->removeCollisionObject(&object);
}

/// Keeps what the world warns of.
class Warnings : public btIDebugDraw {
 public:
  void drawLine(const btVector3&, const btVector3&, const btVector3&) override {}
  void drawContactPoint(const btVector3&, const btVector3&, btScalar, int, const btVector3&) override {}
  void reportErrorWarning(const char* warning) override { text += warning; }
  void draw3dText(const btVector3&, const char*) override {}
  void setDebugMode(int) override {}
  int getDebugMode() const override { return 0; }

  std::string text;
};

TEST_F(MisuseTest, TheDebugDrawerIsToldOfRefusals) {
  LooseWorld w;
  Warnings warnings;
  w->setDebugDrawer(&warnings);
  auto one = body();
  w->addRigidBody(one.get());
  EXPECT_EQ(warnings.text, "");
  w->addRigidBody(one.get());
  EXPECT_THAT(warnings.text, HasSubstr("twice"));
  w->setDebugDrawer(nullptr);
}

TEST_F(MisuseTest, BodiesMayEndBeforeTheirWorld) {
  for (const btHybridSwitchingMode mode : {BT_HYBRID_PAIR_SWITCHING, BT_HYBRID_BODY_SWITCHING}) {
    LooseWorld w(mode);
    auto a = body();
    auto b = body(0.9F);
    w->addRigidBody(a.get());
    w->addRigidBody(b.get());
    w->setHeld(b.get(), true);
    w.step();
    w->requestLevel(b.get(), 1);
    b.reset();
    EXPECT_EQ(w->getNumHybrids(), 1);
    EXPECT_EQ(w->getNumCollisionObjects(), 1);
    w.step();
    EXPECT_EQ(w->getStepInfo().m_standingRequests, 0);
    EXPECT_EQ(w->getCollisionMemory().m_pairs, 0);
  }
}

TEST_F(MisuseTest, WorldsMayEndBeforeTheirBodies) {
  auto a = body();
  auto b = body(0.9F);
  {
    LooseWorld w;
    w->addRigidBody(a.get());
    w->addRigidBody(b.get());
    w->requestLevel(a.get(), 1);
    for (int i = 0; i < 5; ++i) w.step();
    w->requestLevel(b.get(), 1);
  }
  EXPECT_EQ(a->getWorld(), nullptr);
  LooseWorld next;
  next->addRigidBody(b.get());
  next->addRigidBody(a.get());
  EXPECT_EQ(next->getRefusal(), nullptr);
  for (int i = 0; i < 5; ++i) next.step();
  EXPECT_GT(next->getPairLevel(a.get(), b.get()), 0);
}

// Dispatchers.

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

// Calls from inside a step.

/// Does something when it hears of anything.
class Meddler : public btHybridListener {
 public:
  explicit Meddler(std::function<void(btHybridRigidBody*)> act) : act_(std::move(act)) {}
  void requested(btHybridRigidBody* body, const btHybridRequest&) override { act(body); }
  void acknowledged(btHybridRigidBody* body, const btHybridRequest&) override { act(body); }
  void blocked(btHybridRigidBody* body, const btHybridRequest&) override { act(body); }
  void switched(btHybridRigidBody* body, int, int, const btHybridRequest&) override { act(body); }
  void pairEvent(const btHybridPairEvent& event) override {
    act(btHybridRigidBody::upcast(const_cast<btCollisionObject*>(event.m_objectA)));
  }
  int calls = 0;

 private:
  void act(btHybridRigidBody* body) {
    ++calls;
    act_(body);
  }
  std::function<void(btHybridRigidBody*)> act_;
};

/// Two bodies that touch and are asked to be coarse and fine by turns, with somebody who meddles.
void meddle(btHybridDynamicsWorld& world, btHybridRigidBody& a, btHybridRigidBody& b,
            const std::function<void(btHybridRigidBody*)>& act) {
  world.addRigidBody(&a);
  world.addRigidBody(&b);
  for (int i = 0; i < 60; ++i) {
    if (i % 5 == 0) world.requestLevel(&a, 1 + i / 5 % 2);
    Meddler meddler(act);
    world.setListener(&meddler);
    world.stepSimulation(1.0F / 60, 0);
    world.setListener(nullptr);
  }
  world.removeRigidBody(&a);
  world.removeRigidBody(&b);
}

TEST_F(MisuseTest, InsideAStepWhatWouldPullTheGroundAwayIsRefused) {
  LooseWorld w;
  auto a = body();
  auto b = body(0.9F);
  int refused = 0;
  meddle(*w, *a, *b, [&](btHybridRigidBody*) {
    EXPECT_EQ(w->setSwitchingMode(BT_HYBRID_BODY_SWITCHING), -1);
    EXPECT_THAT(w->setCollisionInfo(btHybridCollisionInfo()), HasSubstr("between two steps"));
    for (const PairCall& call : soundPairCalls()) EXPECT_THAT(call(*w), HasSubstr("between two steps"));
    ++refused;
  });
  EXPECT_GT(refused, 0);
  EXPECT_EQ(w->getSwitchingMode(), BT_HYBRID_PAIR_SWITCHING);
  EXPECT_EQ(w->setCollisionInfo(btHybridCollisionInfo()), nullptr);
}

TEST_F(MisuseTest, ListenersMayAskRetractAndGo) {
  for (const btHybridSwitchingMode mode : {BT_HYBRID_PAIR_SWITCHING, BT_HYBRID_BODY_SWITCHING}) {
    for (int kind = 0; kind < 6; ++kind) {
      LooseWorld w(mode);
      w->getSwitchingInfo().m_retryInterval = 1;
      auto a = body();
      auto b = body(0.9F);
      meddle(*w, *a, *b, [&](btHybridRigidBody* body) {
        if (kind == 0) w->retractRequest(body);
        if (kind == 1) w->retractAllRequests();
        if (kind == 2) w->requestLevel(b.get(), 1);
        if (kind == 3) w->setListener(nullptr);
        if (kind == 4) w->setHeld(body, !body->isHeld());
        if (kind == 5) w->verifyContacts(kind % 2);
      });
      w.step();
      EXPECT_EQ(w->getStepInfo().m_standingRequests, 0);
    }
  }
}

// What is nowhere, and odds and ends.

TEST_F(MisuseTest, BodiesThatAreNowhereDoNotStopThePlan) {
  const char* const policies[] = {"proximity",   "speed", "contact-time", "focus",
                                  "held",        "mass",  "group-range",  "group-density",
                                  "group-share", "load",  "overlap",      "coarsest"};
  for (const btHybridSwitchingMode mode : {BT_HYBRID_PAIR_SWITCHING, BT_HYBRID_BODY_SWITCHING}) {
    LooseWorld w(mode);
    w->getSwitchingInfo().m_proximity = true;
    if (mode == BT_HYBRID_PAIR_SWITCHING) {
      for (const char* policy : policies) EXPECT_EQ(w->addPolicy(policy), nullptr);
      EXPECT_EQ(w->setFocus({0, 0, 5}, {0, 0, 0}, 1), nullptr);
      EXPECT_EQ(w->setBudgetUnits(50), nullptr);
    }
    std::vector<std::unique_ptr<btHybridRigidBody>> all;
    for (int i = 0; i < 6; ++i) {
      all.push_back(body(0.9F * static_cast<float>(i)));
      w->addRigidBody(all.back().get());
    }
    auto far = body(50);
    w->addRigidBody(far.get());
    for (int i = 0; i < 10; ++i) w.step();
    all[2]->setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(kNaN, 0, 0)));
    all[3]->setLinearVelocity(btVector3(0, kNaN, 0));
    all[4]->setLinearVelocity(btVector3(0, kInfinity, 0));
    for (int i = 0; i < 20; ++i) {
      w->requestLevel(all[static_cast<std::size_t>(i % 6)].get(), 1);
      w.step();
    }
    EXPECT_EQ(far->getWorldTransform().getOrigin(), btVector3(50, 0, 0));
  }
}

TEST_F(MisuseTest, NothingIsProvenAboutWhatIsNowhere) {
  btSphereShape ball(1);
  const btTransform here = btTransform::getIdentity();
  for (const float bad : {kNaN, kInfinity}) {
    const btTransform nowhere(btQuaternion::getIdentity(), btVector3(bad, 0, 0));
    EXPECT_FALSE(btHybridIsSeparated(&bars_, here, &ball, nowhere, 0));
    EXPECT_FALSE(btHybridIsSeparated(&ball, nowhere, &bars_, here, 0));
    const btTransform away(btQuaternion::getIdentity(), btVector3(9, 0, 0));
    EXPECT_TRUE(btHybridIsSeparated(&bars_, here, &ball, away, 0));
    EXPECT_FALSE(btHybridIsSeparated(&bars_, here, &ball, away, bad));
    EXPECT_FALSE(btHybridIsSeparated(nullptr, here, &ball, away, 0));
    EXPECT_FALSE(btHybridIsSeparated(&ball, here, nullptr, away, 0));
  }
}

// None was refused: the levels that other tests use are nested.
TEST(TestLevels, AreAllThere) {
  const PairTestWorld w;
  EXPECT_EQ(w.cross.getNumLevels(), 3);
  EXPECT_EQ(w.block.getNumLevels(), 3);
  EXPECT_EQ(w.ship.getNumLevels(), 3);
}

TEST_F(MisuseTest, OddsAndEnds) {
  LooseWorld w;
  auto one = body();
  w->addRigidBody(one.get());
  EXPECT_EQ(w->getHybrid(0), one.get());
  EXPECT_EQ(w->getHybrid(1), nullptr);
  EXPECT_EQ(w->getHybrid(-1), nullptr);
  w->verifyContacts(INT_MIN);
  w.step();
  EXPECT_EQ(w->getContactReport().m_steps, 0);
  EXPECT_EQ(btHybridFidelity(nullptr).measure().m_touchingPairs, 0);
}

}  // namespace
}  // namespace scatter::test
