#pragma once

#include <BulletHybrid/btHybridDynamicsWorld.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "BulletTestWorld.h"

namespace scatter::test {

/// Writes down what becomes of requests.
class EventLog : public btHybridListener {
 public:
  struct Entry {
    std::string what;
    btHybridRigidBody* body;
    int level;
  };

  void requested(btHybridRigidBody* body, const btHybridRequest& request) override {
    entries.push_back({"requested", body, request.m_targetLevel});
  }
  void acknowledged(btHybridRigidBody* body, const btHybridRequest& request) override {
    entries.push_back({"acknowledged", body, request.m_targetLevel});
  }
  void blocked(btHybridRigidBody* body, const btHybridRequest& request) override {
    entries.push_back({"blocked", body, request.m_targetLevel});
  }
  void switched(btHybridRigidBody* body, int, int to, const btHybridRequest&) override {
    entries.push_back({"switched", body, to});
    justSwitched.push_back(body);
  }
  void retracted(btHybridRigidBody* body, const btHybridRequest& request, btHybridRetraction why) override {
    entries.push_back({"retracted", body, request.m_targetLevel});
    reason = why;
  }

  std::vector<std::string> story(const btHybridRigidBody* body) const {
    std::vector<std::string> result;
    for (const Entry& entry : entries) {
      if (entry.body == body) result.push_back(entry.what + " " + std::to_string(entry.level));
    }
    return result;
  }

  std::vector<Entry> entries;
  std::vector<btHybridRigidBody*> justSwitched;
  btHybridRetraction reason = BT_HYBRID_RETRACTED_BY_CALLER;
};

/// A hybrid Bullet world with three-levelled crosses: level 3 is a cross of three bars of 2 m, level 2 two
/// overlapping slabs around it, level 1 the 2 m cube around those.
class HybridTestWorld : public BulletTestWorld<btHybridDynamicsWorld> {
 public:
  explicit HybridTestWorld(btHybridSwitchingMode mode = BT_HYBRID_BODY_SWITCHING)
      : BulletTestWorld<btHybridDynamicsWorld>(mode) {
    auto* fine = shape<btCompoundShape>();
    for (int axis = 0; axis < 3; ++axis) {
      btVector3 half(0.2F, 0.2F, 0.2F);
      half[axis] = 1;
      fine->addChildShape(btTransform::getIdentity(), shape<btBoxShape>(half));
    }
    auto* middle = shape<btCompoundShape>();
    middle->addChildShape(btTransform::getIdentity(), shape<btBoxShape>(btVector3(1, 1, 0.2F)));
    middle->addChildShape(btTransform::getIdentity(), shape<btBoxShape>(btVector3(0.2F, 0.2F, 1)));
    cross.addLevel(shape<btBoxShape>(btVector3(1, 1, 1)));
    cross.addLevel(middle);
    cross.addLevel(fine);
    world.setListener(&log);
    world.setGravity(btVector3(0, 0, 0));
    world.getSwitchingInfo().m_proximity = false;
  }

  ~HybridTestWorld() { world.setListener(nullptr); }

  btHybridRigidBody* addCross(const btVector3& position, int level = 0) {
    return addHybrid(cross, position, level);
  }

  btHybridRigidBody* addHybrid(const btHybridLevelSet& levels, const btVector3& position, int level = 0) {
    auto body =
        std::make_unique<btHybridRigidBody>(info(1, levels.getLevelShape(1), position), &levels, level);
    btHybridRigidBody* raw = body.get();
    raw->setActivationState(DISABLE_DEACTIVATION);
    bodies.push_back(std::move(body));
    world.addRigidBody(raw);
    return raw;
  }

  void steps(int count) {
    for (int i = 0; i < count; ++i) step();
  }

  double kineticEnergy() const {
    double sum = 0;
    for (const auto& body : bodies) {
      if (body->isStaticObject()) continue;
      const btVector3 spin = body->getAngularVelocity() * body->getWorldTransform().getBasis();
      const btVector3 inverse = body->getInvInertiaDiagLocal();
      sum += 0.5 *
             (body->getLinearVelocity().length2() / body->getInvMass() + spin.x() * spin.x() / inverse.x() +
              spin.y() * spin.y() / inverse.y() + spin.z() * spin.z() / inverse.z());
    }
    return sum;
  }

  /// The smallest contact distance of `body` in its manifolds; a large number without contacts.
  btScalar nearestContact(const btRigidBody* body) {
    btScalar nearest = 1e9F;
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
      const btPersistentManifold* manifold = dispatcher.getManifoldByIndexInternal(i);
      if (manifold->getBody0() != body && manifold->getBody1() != body) continue;
      for (int k = 0; k < manifold->getNumContacts(); ++k) {
        nearest = btMin(nearest, manifold->getContactPoint(k).getDistance());
      }
    }
    return nearest;
  }

  EventLog log;
  btHybridLevelSet cross;
};

}  // namespace scatter::test
