#include <BulletHybrid/btHybridFidelity.h>
#include <BulletHybrid/btHybridSeparation.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <climits>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "MisuseTest.h"
#include "NotFinite.h"
#include "PairTestWorld.h"

namespace scatter::test {
namespace {

using testing::HasSubstr;

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
