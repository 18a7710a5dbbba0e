#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "PairTestWorld.h"

// What Bullet does with ordinary bodies goes on with hybrids whose pairs are coarse.

namespace scatter::test {
namespace {

/// Two blocks on a floor, one on the other, that were asked for level 2 when they had come to rest.
class OnCredit : public PairTestWorld {
 public:
  OnCredit() {
    world.setGravity(btVector3(0, -10, 0));
    floor = addFloor();
    lower = addBlock({0, 0.5F, 0});
    upper = addBlock({0.1F, 1.5F, 0});
    steps(120);
    requestAll(2);
    steps(5);
  }

  [[nodiscard]] static float height(const btRigidBody* body) {
    return body->getWorldTransform().getOrigin().y();
  }

  btRigidBody* floor;
  btHybridRigidBody* lower;
  btHybridRigidBody* upper;
};

TEST(OnCredit, IsWhatTheseTestsAreAbout) {
  OnCredit w;
  EXPECT_EQ(w.levelOf(w.lower, w.upper), 2);
  EXPECT_EQ(w.levelOf(w.lower, w.floor), 2);
  EXPECT_EQ(w.pairInfo().creditedPairs, 2);
  EXPECT_EQ(w.pairInfo().touchingFinest, 0);
  EXPECT_NEAR(OnCredit::height(w.upper), 1.5F, 0.01F);
}

TEST(OnCredit, RaysAndSweepsHitTheFinestShape) {
  OnCredit w;
  const btVector3 from(0.1F, 5, 0.1F);
  const btVector3 to(0.1F, 0, 0.1F);
  btCollisionWorld::ClosestRayResultCallback ray(from, to);
  w.world.rayTest(from, to, ray);
  ASSERT_TRUE(ray.hasHit());
  EXPECT_EQ(ray.m_collisionObject, w.upper);
  EXPECT_NEAR(ray.m_hitPointWorld.y(), 2, 0.02F);
  EXPECT_NEAR(ray.m_hitNormalWorld.y(), 1, 1e-3F);

  const btSphereShape ball(0.2F);
  btCollisionWorld::ClosestConvexResultCallback sweep(from, to);
  w.world.convexSweepTest(&ball, btTransform(btQuaternion::getIdentity(), from),
                          btTransform(btQuaternion::getIdentity(), to), sweep);
  ASSERT_TRUE(sweep.hasHit());
  EXPECT_NEAR(5 - 5 * sweep.m_closestHitFraction, 2.2F, 0.03F);
}

struct Nearest : public btCollisionWorld::ContactResultCallback {
  Nearest() { m_closestDistanceThreshold = 0.05F; }
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                           const btCollisionObjectWrapper*, int, int) override {
    ++count;
    least = btMin(least, point.getDistance());
    return 0;
  }
  int count = 0;
  btScalar least = 1e9F;
};

TEST(OnCredit, ContactTestsSeeTheFinestShapeAndChangeNothing) {
  OnCredit w;
  OnCredit untouched;
  for (int i = 0; i < 10; ++i) {
    Nearest pair;
    w.world.contactPairTest(w.lower, w.upper, pair);
    EXPECT_GT(pair.count, 0);
    EXPECT_GT(pair.least, -0.02F) << "coarse shapes are 20 cm deep";
    w.step();
    untouched.step();
    ASSERT_EQ(w.bits(), untouched.bits());
  }
  EXPECT_EQ(w.pairInfo().pairs, untouched.pairInfo().pairs);
}

TEST(OnCredit, FiltersLetBodiesThrough) {
  {
    OnCredit w;
    w.world.removeRigidBody(w.upper);
    w.world.addRigidBody(w.upper, 2, 4);
    w.steps(60);
    EXPECT_LT(OnCredit::height(w.upper), 0) << "group and mask";
  }
  {
    OnCredit w;
    w.upper->getBroadphaseHandle()->m_collisionFilterMask = 0;
    w.world.refreshBroadphaseProxy(w.upper);
    w.steps(60);
    EXPECT_LT(OnCredit::height(w.upper), 0) << "a mask that changes";
  }
  {
    OnCredit w;
    w.upper->setIgnoreCollisionCheck(w.lower, true);
    w.lower->setIgnoreCollisionCheck(w.upper, true);
    w.broadphase.getOverlappingPairCache()->cleanProxyFromPairs(w.upper->getBroadphaseHandle(),
                                                                &w.dispatcher);
    w.steps(60);
    EXPECT_NEAR(OnCredit::height(w.upper), 0.6F, 0.02F) << "down to the floor, which it meets at level 2";
  }
}

int nearCalls = 0;
void skipAll(btBroadphasePair&, btCollisionDispatcher&, const btDispatcherInfo&) {
  ++nearCalls;
}

TEST(OnCredit, TheNearCallbackDecides) {
  OnCredit w;
  nearCalls = 0;
  const btNearCallback usual = w.dispatcher.getNearCallback();
  w.dispatcher.setNearCallback(skipAll);
  w.step();
  EXPECT_EQ(nearCalls, w.broadphase.getOverlappingPairCache()->getNumOverlappingPairs());
  w.dispatcher.setNearCallback(usual);
  w.steps(60);
  EXPECT_NEAR(OnCredit::height(w.upper), 1.5F, 0.02F);
}

/// Kinematic bodies have no pairs among themselves, and push others.
TEST(OnCredit, AKinematicBlockLiftsTheOther) {
  OnCredit w;
  w.world.removeRigidBody(w.lower);
  w.lower->setMassProps(0, btVector3(0, 0, 0));
  w.lower->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
  w.world.addRigidBody(w.lower);
  w.steps(30);
  ASSERT_EQ(w.levelOf(w.lower, w.upper), 2);
  for (int i = 0; i < 120; ++i) {
    btTransform pose = w.lower->getWorldTransform();
    pose.setOrigin(pose.getOrigin() + btVector3(0, 0.01F, 0));
    w.lower->setWorldTransform(pose);
    w.step();
  }
  EXPECT_NEAR(OnCredit::height(w.lower), 1.7F, 0.01F);
  EXPECT_NEAR(OnCredit::height(w.upper), 2.7F, 0.03F);
  EXPECT_EQ(w.levelOf(w.lower, w.upper), 2);
}

TEST(OnCredit, JointsHoldWithAndWithoutCollision) {
  for (const bool collides : {true, false}) {
    PairTestWorld w;
    btHybridRigidBody* a = w.addBlock({0, 0, 0});
    btHybridRigidBody* b = w.addBlock({1.0F, 0, 0});
    w.steps(2);
    w.requestAll(2);
    w.steps(2);
    const btTransform inA(btQuaternion::getIdentity(), btVector3(0.5F, 0, 0));
    const btTransform inB(btQuaternion::getIdentity(), btVector3(-0.5F, 0, 0));
    auto joint = std::make_unique<btFixedConstraint>(*a, *b, inA, inB);
    w.world.addConstraint(joint.get(), !collides);
    a->setLinearVelocity(btVector3(1, 0, 0));
    b->setAngularVelocity(btVector3(0, 1, 0));
    const double energy = w.kineticEnergy();
    w.steps(120);
    const float apart = a->getWorldTransform().getOrigin().distance(b->getWorldTransform().getOrigin());
    EXPECT_NEAR(apart, 1, 0.02F) << "collides " << collides;
    EXPECT_LE(w.kineticEnergy(), energy + 1e-3) << "collides " << collides;
    w.world.removeConstraint(joint.get());
  }
}

TEST(OnCredit, SleepsAndWakesWithoutAJump) {
  OnCredit w;
  for (btHybridRigidBody* body : {w.lower, w.upper}) body->forceActivationState(ACTIVE_TAG);
  w.steps(300);
  ASSERT_EQ(w.upper->getActivationState(), ISLAND_SLEEPING);
  EXPECT_EQ(w.levelOf(w.lower, w.upper), 2);
  const btVector3 asleep = w.upper->getWorldTransform().getOrigin();
  w.requestAll(3);
  w.steps(10);
  EXPECT_EQ(w.levelOf(w.lower, w.upper), 2) << "sleeping pairs do not switch";
  w.upper->activate(true);
  w.lower->activate(true);
  w.steps(60);
  EXPECT_LT(w.upper->getWorldTransform().getOrigin().distance(asleep), 0.01F);
  EXPECT_EQ(w.levelOf(w.lower, w.upper), 3);
  EXPECT_FALSE(w.upper->getRequest().isStanding());
}

TEST(OnCredit, AFastBodyDoesNotPassThrough) {
  OnCredit w;
  btHybridRigidBody* shot = w.addBlock({0.1F, 30, 0}, 1, 2);
  shot->setCcdMotionThreshold(0.3F);
  shot->setCcdSweptSphereRadius(0.4F);
  shot->setLinearVelocity(btVector3(0, -150, 0));
  for (int i = 0; i < 30; ++i) {
    w.step();
    ASSERT_GT(OnCredit::height(shot), OnCredit::height(w.upper)) << "step " << i;
  }
}

TEST(OnCredit, BodiesAreTakenOutAndPutBack) {
  OnCredit w;
  for (int round = 0; round < 20; ++round) {
    btHybridRigidBody* body = round % 2 == 0 ? w.upper : w.lower;
    const btVector3 before = w.upper->getWorldTransform().getOrigin();
    w.world.removeRigidBody(body);
    w.world.addRigidBody(body);
    w.steps(6);
    ASSERT_LT(w.upper->getWorldTransform().getOrigin().distance(before), 0.02F) << "round " << round;
    ASSERT_LT(std::sqrt(w.kineticEnergy()), 0.2) << "round " << round;
    EXPECT_EQ(w.levelOf(w.lower, w.upper), 2) << "new pairs start finest, and go back on credit";
  }
  EXPECT_EQ(w.pairInfo().unsafeSwitches, 0);
}

TEST(OnCredit, ASensorHasFineContactsAndABodyAgainCoarseOnes) {
  OnCredit w;
  const int flags = w.upper->getCollisionFlags();
  w.upper->setCollisionFlags(flags | btCollisionObject::CF_NO_CONTACT_RESPONSE);
  w.upper->setGravity(btVector3(0, 0, 0));
  w.upper->setLinearVelocity(btVector3(0, 0, 0));
  w.steps(20);
  EXPECT_EQ(w.levelOf(w.lower, w.upper), 3);
  EXPECT_GT(w.contactsOf(w.lower, w.upper), 0);
  w.upper->setCollisionFlags(flags);
  w.upper->setGravity(btVector3(0, -10, 0));
  w.steps(20);
  EXPECT_EQ(w.levelOf(w.lower, w.upper), 2);
  EXPECT_NEAR(OnCredit::height(w.upper), 1.5F, 0.03F);
}

TEST(OnCredit, AWorldEndsBeforeItsBodies) {
  const OnCredit shapes;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btHybridRigidBody a(PairTestWorld::info(1, shapes.block.getLevelShape(3), {0, 0, 0}), &shapes.block);
  btHybridRigidBody b(PairTestWorld::info(1, shapes.block.getLevelShape(3), {0, 1, 0}), &shapes.block);
  auto world = std::make_unique<btHybridDynamicsWorld>(&dispatcher, &broadphase, &solver, &configuration);
  world->addRigidBody(&a);
  world->addRigidBody(&b);
  world->setGravity(btVector3(0, 0, 0));
  for (int i = 0; i < 10; ++i) {
    if (i == 3) world->requestLevel(&a, 2);
    if (i == 6) world->requestLevel(&b, 1);
    world->stepSimulation(1.0F / 60, 0);
  }
  EXPECT_LT(world->getPairLevel(&a, &b), 3);
  world.reset();
  EXPECT_EQ(dispatcher.getNumManifolds(), 0);
}

}  // namespace
}  // namespace scatter::test
