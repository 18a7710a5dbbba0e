#include <BulletHybrid/btHybridFidelity.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "MisuseTest.h"
#include "NotFinite.h"
#include "PairTestWorld.h"

namespace scatter::test {
namespace {

using testing::HasSubstr;

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

}  // namespace
}  // namespace scatter::test
