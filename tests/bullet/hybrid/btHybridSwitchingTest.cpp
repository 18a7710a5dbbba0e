#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "HybridTestWorld.h"

namespace scatter::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Request, SwitchesAtTheNextStepWhenNothingIsNear) {
  HybridTestWorld w;
  btHybridRigidBody* body = w.addCross({0, 0, 0});
  EXPECT_EQ(body->getLevel(), 3);
  EXPECT_TRUE(w.world.requestLevel(body, 1));
  EXPECT_EQ(body->getLevel(), 3) << "a request is only a wish";
  w.step();
  EXPECT_EQ(body->getLevel(), 1);
  EXPECT_EQ(body->getCollisionShape(), w.cross.getLevelShape(1));
  EXPECT_FALSE(body->getRequest().isStanding());
  EXPECT_THAT(w.log.story(body), ElementsAre("requested 1", "acknowledged 1", "switched 1"));
  EXPECT_EQ(w.world.getStepInfo().m_switchesCoarser, 1);
}

TEST(Request, PersistsAndIsRetriedAtTheIntervalUntilItSucceeds) {
  HybridTestWorld w;
  w.world.getSwitchingInfo().m_retryInterval = 5;
  btHybridRigidBody* body = w.addCross({0, 0, 0});
  // A ball in the corner between the bars: inside levels 1 and 2, outside level 3.
  btRigidBody* ball = w.add(0, w.shape<btSphereShape>(btScalar(0.15)), {0.6F, 0.6F, 0});
  w.world.requestLevel(body, 1);
  w.steps(11);
  EXPECT_EQ(body->getLevel(), 3);
  EXPECT_TRUE(body->getRequest().isStanding());
  EXPECT_THAT(w.log.story(body),
              ElementsAre("requested 1", "acknowledged 1", "blocked 1", "blocked 1", "blocked 1"));
  w.world.removeRigidBody(ball);
  w.steps(5);
  EXPECT_EQ(body->getLevel(), 1);
  EXPECT_EQ(w.log.story(body).back(), "switched 1");
}

TEST(Request, GoesPartOfTheWayAndStandsForTheRest) {
  HybridTestWorld w;
  btHybridRigidBody* body = w.addCross({0, 0, 0});
  // Inside the cube, outside the slabs of level 2.
  btRigidBody* ball = w.add(0, w.shape<btSphereShape>(btScalar(0.15)), {0.6F, 0.6F, 0.6F});
  w.world.requestLevel(body, 1);
  w.step();
  EXPECT_EQ(body->getLevel(), 2);
  EXPECT_EQ(body->getRequest().m_targetLevel, 1);
  w.world.removeRigidBody(ball);
  w.steps(w.world.getSwitchingInfo().m_retryInterval);
  EXPECT_EQ(body->getLevel(), 1);
  EXPECT_THAT(w.log.story(body), ElementsAre("requested 1", "acknowledged 1", "switched 2", "switched 1"));
}

TEST(Request, CanBeRetractedOneByOneAndAllAtOnce) {
  HybridTestWorld w;
  btHybridRigidBody* a = w.addCross({0, 0, 0});
  btHybridRigidBody* b = w.addCross({10, 0, 0});
  w.world.requestLevel(a, 1);
  w.world.requestLevel(b, 2);
  w.world.retractRequest(a);
  w.step();
  EXPECT_EQ(a->getLevel(), 3);
  EXPECT_EQ(b->getLevel(), 2);
  EXPECT_EQ(w.world.getStepInfo().m_retractions, 1);
  w.world.requestLevel(a, 1);
  w.world.requestLevel(b, 1);
  w.world.retractAllRequests();
  w.step();
  EXPECT_EQ(a->getLevel(), 3);
  EXPECT_EQ(b->getLevel(), 2);
  EXPECT_EQ(w.log.reason, BT_HYBRID_RETRACTED_BY_CALLER);
}

TEST(Request, IsRefusedForUnknownLevelsAndForeignBodies) {
  HybridTestWorld w;
  btHybridRigidBody* body = w.addCross({0, 0, 0});
  EXPECT_FALSE(w.world.requestLevel(body, 0));
  EXPECT_FALSE(w.world.requestLevel(body, 4));
  w.world.removeRigidBody(body);
  EXPECT_FALSE(w.world.requestLevel(body, 1));
  EXPECT_THAT(w.log.entries, IsEmpty());
  w.world.addRigidBody(body);
  EXPECT_TRUE(w.world.requestLevel(body, 1));
}

TEST(Request, EndsWhenTheBodyLeavesTheWorld) {
  HybridTestWorld w;
  btHybridRigidBody* body = w.addCross({0, 0, 0});
  w.world.requestLevel(body, 1);
  w.world.removeRigidBody(body);
  EXPECT_FALSE(body->getRequest().isStanding());
  EXPECT_EQ(w.log.reason, BT_HYBRID_RETRACTED_BY_REMOVAL);
  EXPECT_EQ(w.world.getNumHybrids(), 0);
}

TEST(Request, ForTheLevelInUseRetractsTheOneThatStands) {
  HybridTestWorld w;
  btHybridRigidBody* body = w.addCross({0, 0, 0});
  w.world.requestLevel(body, 1);
  EXPECT_TRUE(w.world.requestLevel(body, 3));
  w.step();
  EXPECT_EQ(body->getLevel(), 3);
  EXPECT_THAT(w.log.story(body), ElementsAre("requested 1", "retracted 1"));
}

TEST(FinerLevel, WaitsUntilTheBodyIsFreeOfContact) {
  HybridTestWorld w;
  btHybridRigidBody* body = w.addCross({0, 1.0F, 0}, 1);
  w.addGround();
  body->setGravity(btVector3(0, -10, 0));
  w.steps(60);
  ASSERT_NEAR(body->getWorldTransform().getOrigin().y(), 1, 0.02);
  w.world.requestLevel(body, 3);
  w.steps(60);
  EXPECT_EQ(body->getLevel(), 1) << "it rests on its coarse shape";
  EXPECT_NEAR(body->getWorldTransform().getOrigin().y(), 1, 0.02);
  body->setGravity(btVector3(0, 10, 0));
  w.steps(30);
  EXPECT_EQ(body->getLevel(), 3);
}

/// A body that loses its support when it goes finer in contact drops (report, Figure 3.5): the ball below
/// carries the cube of level 1, and is in the empty corner of level 3.
float dropOfAPerchedBody(bool safetyConditions) {
  HybridTestWorld w;
  w.world.getSwitchingInfo().m_safetyConditions = safetyConditions;
  btHybridRigidBody* body = w.addCross({0, 0, 0}, 1);
  body->setAngularFactor(0);
  for (const float side : {-1.0F, 1.0F}) {
    w.add(0, w.shape<btSphereShape>(btScalar(0.2)), {0.6F * side, -1.2F, 0.6F});
    w.add(0, w.shape<btSphereShape>(btScalar(0.2)), {0.6F * side, -1.2F, -0.6F});
  }
  body->setGravity(btVector3(0, -10, 0));
  w.steps(60);
  const float before = body->getWorldTransform().getOrigin().y();
  w.world.requestLevel(body, 3);
  w.steps(60);
  return before - body->getWorldTransform().getOrigin().y();
}

TEST(FinerLevel, DropsNoBodyWithTheSafetyConditionAndDropsItWithout) {
  EXPECT_LT(dropOfAPerchedBody(true), 0.005F);
  EXPECT_GT(dropOfAPerchedBody(false), 0.3F);
}

/// A clump of crosses hooked into each other by a pull to the centre, then asked to go coarse all at once.
struct ClumpOutcome {
  double risenEnergy = 0;  ///< Sum of the rises of kinetic and potential energy, joules.
  btScalar deepestAfterSwitch = 1e9F;
  int switches = 0;
};

constexpr float kPull = 30;  // newtons, toward the centre, at any distance

void pullToCentre(HybridTestWorld& w) {
  for (const auto& body : w.bodies) {
    const btVector3 position = body->getWorldTransform().getOrigin();
    if (position.length() > 0.01F) body->applyCentralForce(position.normalized() * -kPull);
  }
}

double energyInThePull(const HybridTestWorld& w) {
  double sum = w.kineticEnergy();
  for (const auto& body : w.bodies)
    sum += static_cast<double>(kPull * body->getWorldTransform().getOrigin().length());
  return sum;
}

/// `settle` steps after the start: 400 leave a clump at rest, 8 one that is just gathering.
ClumpOutcome coarsenAClump(bool safetyConditions, int settle) {
  HybridTestWorld w;
  w.world.getSwitchingInfo().m_safetyConditions = safetyConditions;
  for (int i = 0; i < 27; ++i) {
    btHybridRigidBody* body = w.addCross(
        btVector3(static_cast<float>(i % 3), static_cast<float>(i / 3 % 3), static_cast<float>(i / 9)) *
            3.0F -
        btVector3(3, 3, 3));
    const float turn = static_cast<float>(i);
    body->getWorldTransform().setRotation(btQuaternion(btVector3(1, turn, 2 * turn - 9).normalized(), turn));
    body->setDamping(0.5F, 0.5F);
  }
  for (int i = 0; i < settle; ++i) {
    pullToCentre(w);
    w.step();
  }
  for (const auto& body : w.bodies) w.world.requestLevel(btHybridRigidBody::upcast(body.get()), 1);
  ClumpOutcome outcome;
  double energy = energyInThePull(w);
  for (int i = 0; i < 150; ++i) {
    pullToCentre(w);
    w.log.justSwitched.clear();
    w.step();
    for (const btHybridRigidBody* body : w.log.justSwitched) {
      ++outcome.switches;
      outcome.deepestAfterSwitch = btMin(outcome.deepestAfterSwitch, w.nearestContact(body));
    }
    outcome.risenEnergy += btMax(0.0, energyInThePull(w) - energy);
    energy = energyInThePull(w);
  }
  return outcome;
}

TEST(CoarserLevel, NeverMakesContactAtTheSwitchNorAddsEnergyAndDoesBothWithoutTheSafetyCondition) {
  const ClumpOutcome gathering = coarsenAClump(true, 8);
  EXPECT_GT(gathering.switches, 5) << "nothing switched, so nothing was tested";
  EXPECT_GT(gathering.deepestAfterSwitch, 0) << "a switched body is in contact through its new shape";
  EXPECT_LT(gathering.risenEnergy, 1);

  const ClumpOutcome settled = coarsenAClump(true, 400);
  EXPECT_GT(settled.deepestAfterSwitch, 0);
  EXPECT_LT(settled.risenEnergy, 1);

  const ClumpOutcome naive = coarsenAClump(false, 400);
  EXPECT_EQ(naive.switches, 27);
  EXPECT_LT(naive.deepestAfterSwitch, -0.1F);
  EXPECT_GT(naive.risenEnergy, 100);
}

TEST(CoarserLevel, IsBlockedByEveryKindOfPartner) {
  btTriangleMesh triangles;
  triangles.addTriangle(btVector3(-5, 0, -5), btVector3(-5, 0, 5), btVector3(5, 0, 0));
  HybridTestWorld w;
  auto* pair = w.shape<btCompoundShape>();
  pair->addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, 0)),
                      w.shape<btSphereShape>(btScalar(0.1)));
  pair->addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(0.1F, 0, 0)),
                      w.shape<btSphereShape>(btScalar(0.1)));
  btCollisionShape* partners[] = {w.shape<btBoxShape>(btVector3(0.1F, 0.1F, 0.1F)),
                                  w.shape<btSphereShape>(btScalar(0.1)),
                                  w.shape<btCapsuleShape>(btScalar(0.1), btScalar(0.1)), pair};
  for (btCollisionShape* partner : partners) {
    btHybridRigidBody* body = w.addCross({0, 0, 0});
    btRigidBody* other = w.add(0, partner, {0.6F, 0.6F, 0.6F});
    w.world.requestLevel(body, 1);
    w.step();
    EXPECT_EQ(body->getLevel(), 2);
    w.world.removeRigidBody(body);
    w.world.removeRigidBody(other);
  }
  btHybridRigidBody* body = w.addCross({0, 1.5F, 0}, 3);
  w.add(0, w.shape<btBvhTriangleMeshShape>(&triangles, true), {0, 0.6F, 0});
  w.world.requestLevel(body, 1);
  w.step();
  EXPECT_NE(body->getLevel(), 1);
}

TEST(CoarserLevel, IsNotBlockedBySensorsNorByFilteredPartners) {
  HybridTestWorld w;
  btHybridRigidBody* body = w.addCross({0, 0, 0});
  btRigidBody* sensor = w.add(0, w.shape<btSphereShape>(btScalar(0.15)), {0.6F, 0.6F, 0.6F});
  sensor->setCollisionFlags(sensor->getCollisionFlags() | btCollisionObject::CF_NO_CONTACT_RESPONSE);
  btRigidBody* ignored = w.add(0, w.shape<btSphereShape>(btScalar(0.15)), {-0.6F, 0.6F, 0.6F});
  body->setIgnoreCollisionCheck(ignored, true);
  w.world.requestLevel(body, 1);
  w.step();
  EXPECT_EQ(body->getLevel(), 1);
}

TEST(CoarserLevel, AsksASleepingPartnerToo) {
  HybridTestWorld w;
  btHybridRigidBody* body = w.addCross({0, 0, 0});
  btRigidBody* sleeper = w.add(1, w.shape<btSphereShape>(btScalar(0.15)), {0.6F, 0.6F, 0.6F});
  sleeper->forceActivationState(ISLAND_SLEEPING);
  w.world.requestLevel(body, 1);
  w.step();
  EXPECT_EQ(body->getLevel(), 2);
}

class Approach : public testing::TestWithParam<float> {};

TEST_P(Approach, RequestsComeStepsBeforeTheCoarseBoundsOverlap) {
  HybridTestWorld w;
  w.world.getSwitchingInfo().m_proximity = true;
  const float speed = GetParam();
  btHybridRigidBody* a = w.addCross({-speed, 0, 0});
  btHybridRigidBody* b = w.addCross({speed, 0.3F, 0});
  a->setLinearVelocity({speed, 0, 0});
  b->setLinearVelocity({-speed, 0, 0});
  int requested = -1;
  int overlapping = -1;
  for (int i = 0; i < 120 && overlapping < 0; ++i) {
    const float distance = b->getWorldTransform().getOrigin().x() - a->getWorldTransform().getOrigin().x();
    if (distance < 2) overlapping = i;
    w.step();
    if (requested < 0 && !w.log.entries.empty()) {
      requested = i;
      EXPECT_EQ(w.log.entries.front().what, "requested");
      EXPECT_GT(distance, 2);
    }
  }
  ASSERT_GE(requested, 0);
  ASSERT_GE(overlapping, 0);
  EXPECT_GE(overlapping - requested, 3) << "the margin is three steps of the pair's approach";
  EXPECT_EQ(a->getLevel(), 1);
  EXPECT_EQ(b->getLevel(), 1);
}

INSTANTIATE_TEST_SUITE_P(Speeds, Approach, testing::Values(2.0F, 10.0F, 60.0F, 240.0F));

TEST(Proximity, AFastBodyWithoutLevelsIsSeenInTimeToo) {
  HybridTestWorld w;
  w.world.getSwitchingInfo().m_proximity = true;
  w.addCross({0, 0, 0});
  btRigidBody* shot = w.add(1, w.shape<btSphereShape>(btScalar(0.5)), {-50, 0.6F, 0.6F});
  shot->setLinearVelocity({120, 0, 0});
  int requested = -1;
  for (int i = 0; i < 24; ++i) {
    w.step();
    if (requested < 0 && !w.log.entries.empty()) requested = i;
  }
  // The bounds touch when the shot is at x = -1.5, after 24.25 steps of 2 m.
  ASSERT_GE(requested, 0);
  EXPECT_LE(requested, 21);
}

TEST(Proximity, SeparationRetractsWhatWasNotFulfilled) {
  HybridTestWorld w;
  w.world.getSwitchingInfo().m_proximity = true;
  btHybridRigidBody* body = w.addCross({0, 0, 0});
  btRigidBody* ball = w.add(1, w.shape<btSphereShape>(btScalar(0.15)), {0.6F, 0.6F, 0});
  w.steps(3);
  EXPECT_TRUE(body->getRequest().isStanding());
  ball->getWorldTransform().setOrigin({30, 0, 0});
  ball->setInterpolationWorldTransform(ball->getWorldTransform());
  w.steps(1);
  EXPECT_FALSE(body->getRequest().isStanding());
  EXPECT_EQ(w.log.reason, BT_HYBRID_RETRACTED_BY_SEPARATION);
  EXPECT_EQ(body->getLevel(), 3);
}

TEST(Proximity, ALonelyBodyGoesBackToItsFinestLevelAfterTheQuietTime) {
  HybridTestWorld w;
  w.world.getSwitchingInfo().m_proximity = true;
  w.world.getSwitchingInfo().m_quietSteps = 20;
  btHybridRigidBody* body = w.addCross({0, 0, 0}, 1);
  w.steps(19);
  EXPECT_EQ(body->getLevel(), 1);
  w.steps(2);
  EXPECT_EQ(body->getLevel(), 3);
}

TEST(Proximity, AFloorAsksForNothing) {
  HybridTestWorld w;
  w.world.getSwitchingInfo().m_proximity = true;
  w.addGround();
  btHybridRigidBody* body = w.addCross({0, 1.0F, 0});
  body->setGravity(btVector3(0, -10, 0));
  w.steps(60);
  EXPECT_EQ(body->getLevel(), 3);
  EXPECT_THAT(w.log.entries, IsEmpty());
}

TEST(Proximity, LeavesTheProgramsOwnRequestsAlone) {
  HybridTestWorld w;
  w.world.getSwitchingInfo().m_proximity = true;
  btHybridRigidBody* body = w.addCross({0, 0, 0}, 1);
  w.addCross({0.3F, 2.5F, 0}, 1);
  w.world.requestLevel(body, 2, BT_HYBRID_GLOBAL);
  w.steps(2);
  EXPECT_EQ(body->getLevel(), 2);
}

TEST(GlobalPolicy, AFineLoadRetractsStandingRequestsAndPreventsNewOnes) {
  HybridTestWorld w;
  w.world.getSwitchingInfo().m_proximity = true;
  btHybridRigidBody* body = w.addCross({0, 0, 0});
  w.add(1, w.shape<btSphereShape>(btScalar(0.15)), {0.6F, 0.6F, 0});
  w.steps(2);
  ASSERT_TRUE(body->getRequest().isStanding());
  w.world.setLoadIsFine(true);
  w.step();
  EXPECT_FALSE(body->getRequest().isStanding());
  EXPECT_EQ(w.log.reason, BT_HYBRID_RETRACTED_BY_LOAD);
  const std::size_t events = w.log.entries.size();
  w.steps(20);
  EXPECT_EQ(w.log.entries.size(), events);
  w.world.setLoadIsFine(false);
  w.step();
  EXPECT_TRUE(body->getRequest().isStanding());
}

TEST(Levels, AnyNumberOfThemIsWalkedFromCoarseToFine) {
  HybridTestWorld w;
  btHybridLevelSet onion;
  for (int level = 0; level < 8; ++level) {
    const btScalar half = 2 - btScalar(0.2) * static_cast<btScalar>(level);
    onion.addLevel(w.shape<btBoxShape>(btVector3(half, half, half)));
  }
  btHybridRigidBody* body = w.addHybrid(onion, {0, 0, 0});
  // The ball's near side is at x = 1.25: levels 5 to 8 (half extents up to 1.2) fit beside it.
  w.add(0, w.shape<btSphereShape>(btScalar(0.5)), {1.75F, 0, 0});
  w.world.requestLevel(body, 1);
  w.step();
  EXPECT_EQ(body->getLevel(), 5);
  w.world.requestLevel(body, 8);
  w.step();
  EXPECT_EQ(body->getLevel(), 8);
  w.world.removeRigidBody(body);
}

TEST(Switch, NeverChangesTheBitsOfAFreeBodysPath) {
  HybridTestWorld switching;
  HybridTestWorld constant;
  for (HybridTestWorld* w : {&switching, &constant}) {
    btHybridRigidBody* body = w->addCross({1, 2, 3});
    body->setLinearVelocity({3, 1, -2});
    body->setAngularVelocity({0.4F, -2, 1.1F});
    body->setDamping(0.1F, 0.2F);
    body->setGravity(btVector3(0, -10, 0));
  }
  auto* body = btHybridRigidBody::upcast(switching.bodies[0].get());
  int switches = 0;
  for (int i = 0; i < 300; ++i) {
    switching.world.requestLevel(body, 1 + i % 3);
    switching.step();
    constant.step();
    switches +=
        switching.world.getStepInfo().m_switchesCoarser + switching.world.getStepInfo().m_switchesFiner;
    ASSERT_EQ(switching.bits(), constant.bits()) << "step " << i;
  }
  EXPECT_GT(switches, 290);
}

TEST(Switch, LeavesPoseVelocityMassAndInertiaOfEveryBodyInACrowdAlone) {
  HybridTestWorld w;
  struct Watch : EventLog {
    std::vector<std::uint32_t> before;
    HybridTestWorld* world = nullptr;
    int compared = 0;
    void acknowledged(btHybridRigidBody* body, const btHybridRequest& request) override {
      EventLog::acknowledged(body, request);
      before = world->bits();
    }
    void switched(btHybridRigidBody* body, int from, int to, const btHybridRequest& request) override {
      EventLog::switched(body, from, to, request);
      EXPECT_EQ(body->getInvMass(), 1);
      EXPECT_EQ(before, world->bits());
      ++compared;
    }
  } watch;
  watch.world = &w;
  w.world.setListener(&watch);
  w.world.getSwitchingInfo().m_proximity = true;
  for (int i = 0; i < 40; ++i) {
    w.addCross(btVector3(static_cast<float>(i % 4) * 5, static_cast<float>(i / 4 % 4) * 5,
                         static_cast<float>(i / 16) * 5) -
               btVector3(8, 8, 5));
  }
  const btVector3 inertia = w.bodies[0]->getInvInertiaDiagLocal();
  for (int i = 0; i < 200; ++i) {
    pullToCentre(w);
    w.step();
  }
  EXPECT_GT(watch.compared, 30);
  for (const auto& body : w.bodies) EXPECT_EQ(body->getInvInertiaDiagLocal(), inertia);
}

TEST(HybridWorld, TheSameRunTwiceGivesTheSameBits) {
  auto run = [] {
    auto w = std::make_unique<HybridTestWorld>();
    w->world.getSwitchingInfo().m_proximity = true;
    for (int i = 0; i < 30; ++i) {
      w->addCross(
          btVector3(static_cast<float>(i % 5) * 4, static_cast<float>(i / 5) * 4, static_cast<float>(i % 3)) -
          btVector3(8, 10, 0));
    }
    for (int i = 0; i < 300; ++i) {
      pullToCentre(*w);
      w->step();
    }
    EXPECT_GT(w->log.entries.size(), 30U);
    return w->bits();
  };
  EXPECT_EQ(run(), run());
}

TEST(HybridWorld, SurvivesRemovalAndReturnOfBodiesInContact) {
  HybridTestWorld w;
  w.world.getSwitchingInfo().m_proximity = true;
  for (int i = 0; i < 20; ++i)
    w.addCross({static_cast<float>(i % 4) * 2.2F, static_cast<float>(i / 4) * 2.2F, 0});
  for (int i = 0; i < 200; ++i) {
    pullToCentre(w);
    btRigidBody* body = w.bodies[static_cast<std::size_t>(i * 7 % 20)].get();
    if (body->getWorldArrayIndex() >= 0) {
      w.world.removeRigidBody(body);
    } else {
      w.world.addRigidBody(body);
    }
    w.step();
    int present = 0;
    for (const auto& each : w.bodies) present += each->getWorldArrayIndex() >= 0;
    ASSERT_EQ(w.world.getNumHybrids(), present);
  }
}

TEST(BodySwitching, TakesPlainBodiesWithoutHybrids) {
  HybridTestWorld w(BT_HYBRID_BODY_SWITCHING);
  btHybridCollisionInfo info = w.world.getCollisionInfo();
  info.m_plainBodies = true;
  w.world.setCollisionInfo(info);
  auto* shape = w.shape<btCompoundShape>();
  shape->addChildShape(btTransform::getIdentity(), w.shape<btBoxShape>(btVector3(0.5F, 0.5F, 0.5F)));
  for (int i = 0; i < 6; ++i) w.add(1, shape, btVector3(0.9F * static_cast<float>(i), 0, 0));
  w.steps(3);
  EXPECT_GT(w.dispatcher.getNumManifolds(), 0);
  // One that was there has told nothing of objects that have come since.
  w.world.removeRigidBody(w.addCross({0, 9, 0}));
  for (int i = 0; i < 6; ++i) w.add(1, shape, btVector3(0.9F * static_cast<float>(i), 0.9F, 0));
  w.steps(3);
  EXPECT_GT(w.dispatcher.getNumManifolds(), 6);
}

}  // namespace
}  // namespace scatter::test
