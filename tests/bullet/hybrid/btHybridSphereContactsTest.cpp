#include <gtest/gtest.h>

#include <vector>

#include "RandomShapes.h"
#include "ScriptedWorld.h"

// Bullet finds the contact of two spheres anew in every step and keeps nothing of the one before.

namespace scatter::test {
namespace {

int ended = 0;
int started = 0;
int added = 0;
int destroyed = 0;

void countEnded(btPersistentManifold* const&) {
  ++ended;
}
void countStartedSpheres(btPersistentManifold* const&) {
  ++started;
}
bool countAdded(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                const btCollisionObjectWrapper*, int, int) {
  ++added;
  point.m_userPersistentData = &added;
  return false;
}
bool countDestroyed(void*) {
  ++destroyed;
  return true;
}

/// A compound of two spheres of 1 m over another, or over a bare sphere.
class Spheres : public ScriptedWorld {
 public:
  explicit Spheres(bool pairAlgorithm, bool bare) : ScriptedWorld(pairAlgorithm), shapes_(1) {
    auto* pair = shapes_.make<btCompoundShape>();
    auto* ball = shapes_.make<btSphereShape>(0.5F);
    for (const float x : {0.0F, 3.0F}) {
      pair->addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(x, 0, 0)), ball);
    }
    addHybrid(shapes_.oneLevel(pair), at(0));
    addOther(1, bare ? static_cast<btCollisionShape*>(ball) : pair, at(0.99F));
    for (auto& body : bodies) body->setCollisionFlags(btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
  }

  static btTransform at(float height) {
    return btTransform(btQuaternion::getIdentity(), btVector3(0, height, 0));
  }

  std::vector<btManifoldPoint> points() {
    std::vector<btManifoldPoint> result;
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
      btPersistentManifold* manifold = dispatcher.getManifoldByIndexInternal(i);
      for (int k = 0; k < manifold->getNumContacts(); ++k) result.push_back(manifold->getContactPoint(k));
    }
    return result;
  }

  /// As a solver would.
  void giveImpulses() {
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
      btPersistentManifold* manifold = dispatcher.getManifoldByIndexInternal(i);
      for (int k = 0; k < manifold->getNumContacts(); ++k) manifold->getContactPoint(k).m_appliedImpulse = 7;
    }
  }

 private:
  RandomShapes shapes_;
};

class SphereContacts : public testing::TestWithParam<bool> {
 protected:
  void SetUp() override {
    ended = started = added = destroyed = 0;
    gContactEndedCallback = countEnded;
    gContactStartedCallback = countStartedSpheres;
    gContactAddedCallback = countAdded;
    gContactDestroyedCallback = countDestroyed;
  }
  void TearDown() override {
    gContactEndedCallback = nullptr;
    gContactStartedCallback = nullptr;
    gContactAddedCallback = nullptr;
    gContactDestroyedCallback = nullptr;
  }
};
INSTANTIATE_TEST_SUITE_P(Partners, SphereContacts, testing::Bool());

TEST_P(SphereContacts, AreNewInEveryStep) {
  std::vector<std::vector<int>> events;
  for (const bool pairAlgorithm : {false, true}) {
    SetUp();
    Spheres w(pairAlgorithm, GetParam());
    for (int step = 0; step < 4; ++step) {
      w.place(1, Spheres::at(0.99F - 0.001F * static_cast<float>(step)));
      w.detect();
      EXPECT_EQ(w.points().size(), GetParam() ? 1U : 2U);
      for (const btManifoldPoint& point : w.points()) {
        EXPECT_EQ(point.getLifeTime(), 0);
        EXPECT_EQ(point.m_appliedImpulse, 0.0F);
      }
      w.giveImpulses();
    }
    events.push_back({ended, started, added, destroyed});
    EXPECT_EQ(w.report().m_extra, 0);
  }
  EXPECT_GT(events[0][0], 0);
  EXPECT_EQ(events[0], events[1]);
}

TEST_P(SphereContacts, EndWhereTheSpheresAreApart) {
  Spheres w(true, GetParam());
  w.detect();
  EXPECT_FALSE(w.points().empty());
  // Less than the contact breaking threshold of 1 cm and more.
  w.place(1, Spheres::at(1.002F));
  w.detect();
  EXPECT_TRUE(w.points().empty());
  EXPECT_EQ(w.report().m_extra, 0);
  EXPECT_GT(ended, 0);
  EXPECT_EQ(destroyed, added);
}

/// What the world keeps behind the verifier's back is extra for it.
TEST_P(SphereContacts, ThatAreKeptAreExtraForTheVerifier) {
  Spheres w(true, GetParam());
  w.detect();
  w.dispatcher.setNearCallback([](btBroadphasePair& pair, btCollisionDispatcher&, const btDispatcherInfo&) {
    btManifoldArray manifolds;
    pair.m_algorithm->getAllContactManifolds(manifolds);
    for (int i = 0; i < manifolds.size(); ++i) {
      manifolds[i]->refreshContactPoints(manifolds[i]->getBody0()->getWorldTransform(),
                                         manifolds[i]->getBody1()->getWorldTransform());
    }
  });
  w.place(1, Spheres::at(1.002F));
  w.detect();
  EXPECT_EQ(w.report().m_extra, GetParam() ? 1 : 2);
}

}  // namespace
}  // namespace scatter::test
