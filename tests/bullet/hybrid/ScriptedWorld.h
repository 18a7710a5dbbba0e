#pragma once

#include <BulletHybrid/btHybridDynamicsWorld.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "BulletTestWorld.h"

namespace scatter::test {

/// A child pair: bodies by their order of addition, the smaller first, and the children's indices.
using ChildPair = std::array<int, 4>;

/// The deepest contact point of a child pair.
struct ChildContact {
  float distance;
  float threshold;   ///< The contact breaking threshold of its manifold.
  btVector3 normal;  ///< From the second body to the first.
};

/// A hybrid world in which nothing moves by itself: a test sets the poses and asks for contacts.
class ScriptedWorld : public BulletTestWorld<btHybridDynamicsWorld> {
 public:
  /// Of the worlds made from now on; InBothModes sets it.
  static inline btHybridSwitchingMode usualMode = BT_HYBRID_PAIR_SWITCHING;

  explicit ScriptedWorld(bool pairAlgorithm = true) : BulletTestWorld<btHybridDynamicsWorld>(usualMode) {
    world.setGravity(btVector3(0, 0, 0));
    world.getSwitchingInfo().m_proximity = false;
    btHybridCollisionInfo collision;
    collision.m_pairAlgorithm = pairAlgorithm;
    world.setCollisionInfo(collision);
    world.verifyContacts(1);
  }

  btHybridRigidBody* addHybrid(const btHybridLevelSet& levels, const btTransform& pose, int level = 0) {
    const int finest = levels.getNumLevels();
    auto body = std::make_unique<btHybridRigidBody>(info(1, levels.getLevelShape(finest), pose.getOrigin()),
                                                    &levels, level);
    btHybridRigidBody* raw = body.get();
    bodies.push_back(std::move(body));
    enter(raw, pose);
    return raw;
  }

  btRigidBody* addOther(btScalar mass, btCollisionShape* form, const btTransform& pose) {
    bodies.push_back(std::make_unique<btRigidBody>(btScalar(mass), nullptr, form, btVector3(1, 1, 1)));
    enter(bodies.back().get(), pose);
    return bodies.back().get();
  }

  static void place(btRigidBody* body, const btTransform& pose) {
    body->setWorldTransform(pose);
    body->setInterpolationWorldTransform(pose);
  }

  void place(int body, const btTransform& pose) { place(bodies[static_cast<std::size_t>(body)].get(), pose); }

  void detect() { world.performDiscreteCollisionDetection(); }

  const btHybridContactReport& report() const { return world.getContactReport(); }

  /// The deepest point of every child pair in contact.
  std::map<ChildPair, ChildContact> contacts() {
    std::map<ChildPair, ChildContact> result;
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
      const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
      for (int k = 0; k < manifold.getNumContacts(); ++k) {
        const btManifoldPoint& point = manifold.getContactPoint(k);
        ChildPair key{numberOf(manifold.getBody0()), numberOf(manifold.getBody1()),
                      childOf(manifold.getBody0(), point.m_index0),
                      childOf(manifold.getBody1(), point.m_index1)};
        const bool swap = key[0] > key[1];
        if (swap) key = {key[1], key[0], key[3], key[2]};
        const ChildContact contact{point.getDistance(), manifold.getContactBreakingThreshold(),
                                   swap ? -point.m_normalWorldOnB : point.m_normalWorldOnB};
        const auto [entry, fresh] = result.try_emplace(key, contact);
        if (!fresh && contact.distance < entry->second.distance) entry->second = contact;
      }
    }
    return result;
  }

  /// How far apart a plane across `normal` (from the second child to the first) shows two convex children to
  /// be: never more than their distance. Their cores have rounded corners, as in Bullet's GJK.
  float separationAlong(const ChildPair& pair, const btVector3& normal) const {
    return -reach(pair[0], pair[2], -normal) - reach(pair[1], pair[3], normal);
  }

  int numberOf(const btCollisionObject* object) const {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (bodies[i].get() == object) return static_cast<int>(i);
    }
    return -1;
  }

 private:
  // The triangle that a point is on is not a child: Bullet has one manifold for all of a mesh.
  static int childOf(const btCollisionObject* object, int index) {
    return object->getCollisionShape()->isCompound() ? index : -1;
  }

  float reach(int body, int child, const btVector3& direction) const {
    const btRigidBody& object = *bodies[static_cast<std::size_t>(body)];
    const btCollisionShape* shape = object.getCollisionShape();
    btTransform pose = object.getWorldTransform();
    if (shape->isCompound()) {
      const auto* compound = static_cast<const btCompoundShape*>(shape);
      pose = pose * compound->getChildTransform(child);
      shape = compound->getChildShape(child);
    }
    const auto* convex = static_cast<const btConvexShape*>(shape);
    const btVector3 local = convex->localGetSupportVertexWithoutMarginNonVirtual(direction * pose.getBasis());
    return (pose * local).dot(direction) + convex->getMarginNonVirtual();
  }

  void enter(btRigidBody* body, const btTransform& pose) {
    body->setActivationState(DISABLE_DEACTIVATION);
    place(body, pose);
    world.addRigidBody(body);
  }
};

/// Runs a suite in pair switching and in body switching.
class InBothModes : public testing::TestWithParam<btHybridSwitchingMode> {
 protected:
  void SetUp() override { ScriptedWorld::usualMode = GetParam(); }
  void TearDown() override { ScriptedWorld::usualMode = BT_HYBRID_PAIR_SWITCHING; }
};

inline auto bothModes() {
  return testing::Values(BT_HYBRID_PAIR_SWITCHING, BT_HYBRID_BODY_SWITCHING);
}

inline std::string nameOfMode(const testing::TestParamInfo<btHybridSwitchingMode>& mode) {
  return mode.param == BT_HYBRID_PAIR_SWITCHING ? "ByPairs" : "ByBodies";
}

}  // namespace scatter::test
