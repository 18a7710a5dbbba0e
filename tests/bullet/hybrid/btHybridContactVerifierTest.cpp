#include <BulletCollision/CollisionDispatch/btCompoundCompoundCollisionAlgorithm.h>
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "RandomShapes.h"
#include "ScriptedWorld.h"

namespace scatter::test {
namespace {

constexpr int kSettling = 120;

/// Hybrids of a dozen parts drawn to one point and left there.
class Clump : public ScriptedWorld {
 public:
  explicit Clump(bool pairAlgorithm, int count = 12) : ScriptedWorld(pairAlgorithm), shapes_(7) {
    world.verifyContacts(0);
    const btHybridLevelSet& levels = shapes_.oneLevel(shapes_.plainCompound(12, 1));
    for (int i = 0; i < count; ++i) addHybrid(levels, shapes_.random.pose(2.0F));
    addOther(1, shapes_.make<btSphereShape>(0.4F), shapes_.random.pose(2.0F));
  }

  void pullAndStep() {
    for (auto& body : bodies) body->applyCentralForce(body->getWorldTransform().getOrigin() * -5);
    world.stepSimulation(1.0F / 60, 0);
  }

 private:
  RandomShapes shapes_;
};

TEST(ContactVerifier, FindsNothingAmissInASettledClump) {
  for (const bool pairAlgorithm : {false, true}) {
    Clump clump(pairAlgorithm);
    for (int i = 0; i < kSettling; ++i) clump.pullAndStep();
    clump.world.verifyContacts(1);
    for (int i = 0; i < 20; ++i) clump.pullAndStep();
    const btHybridContactReport& report = clump.report();
    EXPECT_EQ(report.m_steps, 20);
    EXPECT_GT(report.m_expected, 500);
    EXPECT_GE(report.m_childPairs, report.m_expected);
    EXPECT_EQ(report.m_missed, 0) << "pair algorithm: " << pairAlgorithm;
    EXPECT_EQ(report.m_lastMissed.size(), 0);
    // Bullet itself keeps an old contact a little longer than its midphase would make a new one.
    EXPECT_LE(report.m_extra * 100, report.m_expected) << "pair algorithm: " << pairAlgorithm;
  }
}

TEST(ContactVerifier, DoesNotChangeTheSimulation) {
  for (const bool pairAlgorithm : {false, true}) {
    Clump plain(pairAlgorithm);
    Clump verified(pairAlgorithm);
    verified.world.verifyContacts(3);
    for (int i = 0; i < 300; ++i) {
      plain.pullAndStep();
      verified.pullAndStep();
      ASSERT_EQ(plain.bits(), verified.bits()) << "step " << i;
    }
    EXPECT_EQ(verified.report().m_steps, 100);
    EXPECT_GT(verified.report().m_expected, 1000);
    ASSERT_EQ(plain.dispatcher.getNumManifolds(), verified.dispatcher.getNumManifolds());
  }
}

int addedPoints = 0;
int startedManifolds = 0;

bool countAdded(btManifoldPoint&, const btCollisionObjectWrapper*, int, int, const btCollisionObjectWrapper*,
                int, int) {
  ++addedPoints;
  return false;
}
void countStartedManifolds(btPersistentManifold* const&) {
  ++startedManifolds;
}

TEST(ContactVerifier, CallsNoContactCallbackAndPutsThemBack) {
  Clump plain(false);
  Clump verified(false);
  verified.world.verifyContacts(1);
  gContactAddedCallback = countAdded;
  gContactStartedCallback = countStartedManifolds;
  std::vector<std::array<int, 2>> counts;
  for (Clump* clump : {&plain, &verified}) {
    for (auto& body : clump->bodies) {
      body->setCollisionFlags(body->getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
    }
    addedPoints = startedManifolds = 0;
    for (int i = 0; i < 60; ++i) clump->pullAndStep();
    counts.push_back({addedPoints, startedManifolds});
  }
  EXPECT_EQ(gContactAddedCallback, countAdded);
  EXPECT_EQ(gContactStartedCallback, countStartedManifolds);
  gContactAddedCallback = nullptr;
  gContactStartedCallback = nullptr;
  EXPECT_GT(counts[0][0], 100);
  EXPECT_GT(counts[0][1], 10);
  EXPECT_EQ(counts[0], counts[1]);
}

/// A broadphase callback that leaves the contacts of one child pair out: what a broken narrowphase would do.
class Forgetful {
 public:
  static void install(btCollisionDispatcher& dispatcher, int childA, int childB) {
    childA_ = childA;
    childB_ = childB;
    dispatcher.setNearCallback(forget);
  }

 private:
  static void forget(btBroadphasePair& pair, btCollisionDispatcher& dispatcher,
                     const btDispatcherInfo& info) {
    btCollisionDispatcher::defaultNearCallback(pair, dispatcher, info);
    btManifoldArray manifolds;
    if (pair.m_algorithm != nullptr) pair.m_algorithm->getAllContactManifolds(manifolds);
    for (int i = 0; i < manifolds.size(); ++i) {
      for (int k = manifolds[i]->getNumContacts() - 1; k >= 0; --k) {
        const btManifoldPoint& point = manifolds[i]->getContactPoint(k);
        if (point.m_index0 == childA_ && point.m_index1 == childB_) manifolds[i]->removeContactPoint(k);
      }
    }
  }

  static inline int childA_ = 0;
  static inline int childB_ = 0;
};

/// Two bars of three unit cubes each along x, the second over the first by `gap`.
class Bars : public ScriptedWorld {
 public:
  explicit Bars(float gap, bool pairAlgorithm = false) : ScriptedWorld(pairAlgorithm), shapes_(1) {
    auto* bar = shapes_.make<btCompoundShape>();
    for (int i = 0; i < 3; ++i) {
      bar->addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(static_cast<float>(i) * 2, 0, 0)),
                         shapes_.make<btBoxShape>(btVector3(0.5F, 0.5F, 0.5F)));
    }
    const btHybridLevelSet& levels = shapes_.oneLevel(bar);
    addHybrid(levels, btTransform::getIdentity());
    addHybrid(levels, btTransform(btQuaternion::getIdentity(), btVector3(0, 1 + gap, 0)));
  }

 private:
  RandomShapes shapes_;
};

TEST(ContactVerifier, NamesAChildPairWhoseContactsAreGone) {
  for (const bool pairAlgorithm : {false, true}) {
    Bars bars(-0.01F, pairAlgorithm);
    bars.detect();
    EXPECT_EQ(bars.report().m_expected, 3);
    EXPECT_EQ(bars.report().m_missed, 0);
    Forgetful::install(bars.dispatcher, 1, 1);
    bars.detect();
    const btHybridContactReport& report = bars.report();
    EXPECT_EQ(report.m_expected, 6);
    ASSERT_EQ(report.m_missed, 1);
    ASSERT_EQ(report.m_lastMissed.size(), 1);
    const btHybridMissedContact& missed = report.m_lastMissed[0];
    EXPECT_EQ(missed.m_childA, 1);
    EXPECT_EQ(missed.m_childB, 1);
    EXPECT_NE(missed.m_bodyA, missed.m_bodyB);
    EXPECT_NEAR(missed.m_distance, -0.01F, 1e-5F);
  }
}

TEST(ContactVerifier, ExpectsNothingWhereBodiesAreApart) {
  Bars bars(0.2F);
  bars.detect();
  EXPECT_EQ(bars.report().m_steps, 1);
  EXPECT_EQ(bars.report().m_expected, 0);
  EXPECT_EQ(bars.report().m_missed, 0);
}

TEST(ContactVerifier, CountsContactsThatTheMidphaseWouldLeaveOut) {
  Bars bars(-0.01F);
  bars.detect();
  ASSERT_EQ(bars.report().m_extra, 0);
  // The poses change behind the back of the contacts: they stay, but their children are apart.
  bars.dispatcher.setNearCallback([](btBroadphasePair&, btCollisionDispatcher&, const btDispatcherInfo&) {});
  bars.place(1, btTransform(btQuaternion::getIdentity(), btVector3(0, 1.01F, 0)));
  bars.detect();
  EXPECT_EQ(bars.report().m_extra, 3);
  EXPECT_EQ(bars.report().m_missed, 0);
}

TEST(ContactVerifier, LeavesOutPairsThatTheDispatcherDoesNotProcess) {
  Bars bars(-0.01F);
  bars.world.setForceUpdateAllAabbs(true);
  for (auto& body : bars.bodies) body->forceActivationState(ISLAND_SLEEPING);
  bars.detect();
  EXPECT_EQ(bars.report().m_childPairs, 0);
  for (auto& body : bars.bodies) body->forceActivationState(ACTIVE_TAG);
  bars.bodies[0]->setIgnoreCollisionCheck(bars.bodies[1].get(), true);
  bars.detect();
  EXPECT_EQ(bars.report().m_childPairs, 0);
  bars.bodies[0]->setIgnoreCollisionCheck(bars.bodies[1].get(), false);
  bars.detect();
  EXPECT_EQ(bars.report().m_expected, 3);
}

TEST(ContactVerifier, VerifiesEveryNthStepAndForgetsWhenTurnedOnAnew) {
  Bars bars(-0.01F);
  bars.world.verifyContacts(3);
  for (int i = 0; i < 9; ++i) bars.detect();
  EXPECT_EQ(bars.report().m_steps, 3);
  EXPECT_EQ(bars.report().m_expected, 9);
  bars.world.verifyContacts(0);
  EXPECT_EQ(bars.report().m_expected, 0);
  bars.detect();
  EXPECT_EQ(bars.report().m_steps, 0);
}

TEST(ContactVerifier, SkipsShapesThatAreNotConvexParts) {
  Bars bars(3);
  RandomShapes shapes(3);
  auto* nested = shapes.make<btCompoundShape>();
  nested->addChildShape(btTransform::getIdentity(), shapes.plainCompound(2, 1));
  bars.addOther(1, nested, btTransform::getIdentity());
  bars.addOther(1, shapes.make<btEmptyShape>(), btTransform::getIdentity());
  bars.detect();
  EXPECT_EQ(bars.report().m_childPairs, 0);
  for (int i = 3; i >= 2; --i) bars.world.removeRigidBody(bars.bodies[static_cast<std::size_t>(i)].get());
}

bool refuseAll(const btCollisionShape*, const btCollisionShape*) {
  return false;
}

TEST(ContactVerifier, RespectsBulletsChildShapePairCallbacks) {
  Bars bars(-0.01F);
  gCompoundCompoundChildShapePairCallback = refuseAll;
  bars.detect();
  gCompoundCompoundChildShapePairCallback = nullptr;
  EXPECT_EQ(bars.report().m_expected, 0);
  bars.detect();
  EXPECT_EQ(bars.report().m_expected, 3);
}

}  // namespace
}  // namespace scatter::test
