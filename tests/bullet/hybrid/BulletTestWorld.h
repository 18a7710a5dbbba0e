#pragma once

#include <btBulletDynamicsCommon.h>

#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

namespace scatter::test {

inline bool isSoft(const btBroadphaseProxy* proxy) {
  const auto* object = static_cast<const btCollisionObject*>(proxy->m_clientObject);
  return object->getInternalType() == btCollisionObject::CO_SOFT_BODY;
}

/// Of all pairs of a cache. Bullet's algorithm for two soft bodies has none, and names one that it never set.
inline int countManifolds(btOverlappingPairCache& cache) {
  btBroadphasePairArray& overlaps = cache.getOverlappingPairArray();
  btManifoldArray owned;
  for (int i = 0; i < overlaps.size(); ++i) {
    if (overlaps[i].m_algorithm == nullptr) continue;
    if (isSoft(overlaps[i].m_pProxy0) && isSoft(overlaps[i].m_pProxy1)) continue;
    overlaps[i].m_algorithm->getAllContactManifolds(owned);
  }
  return owned.size();
}

/// A Bullet world of either type with everything that it needs, and the bodies and shapes added to it.
template <class WorldType, class Solver = btSequentialImpulseConstraintSolver,
          class Configuration = btDefaultCollisionConfiguration>
class BulletTestWorld {
 public:
  /// `more`: what the world's constructor takes besides what every Bullet world does.
  template <class... More>
  explicit BulletTestWorld(More... more) : world{&dispatcher, &broadphase, &solver, &configuration, more...} {
    world.setGravity(btVector3(0, -10, 0));
  }

  ~BulletTestWorld() {
    for (auto& joint : joints) world.removeConstraint(joint.get());
    for (auto& body : bodies) {
      if (body->getWorldArrayIndex() >= 0) world.removeRigidBody(body.get());
    }
  }

  BulletTestWorld(const BulletTestWorld&) = delete;
  BulletTestWorld& operator=(const BulletTestWorld&) = delete;

  template <class Shape, class... Args>
  Shape* shape(Args&&... args) {
    auto owned = std::make_unique<Shape>(std::forward<Args>(args)...);
    Shape* raw = owned.get();
    shapes.push_back(std::move(owned));
    return raw;
  }

  btRigidBody* add(btScalar mass, btCollisionShape* form, const btVector3& position) {
    bodies.push_back(std::make_unique<btRigidBody>(info(mass, form, position)));
    world.addRigidBody(bodies.back().get());
    return bodies.back().get();
  }

  static btRigidBody::btRigidBodyConstructionInfo info(btScalar mass, btCollisionShape* form,
                                                       const btVector3& position) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0) form->calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo result(mass, nullptr, form, inertia);
    result.m_startWorldTransform.setIdentity();
    result.m_startWorldTransform.setOrigin(position);
    return result;
  }

  btRigidBody* addGround() {
    return add(0, shape<btStaticPlaneShape>(btVector3(0, 1, 0), btScalar(0)), {0, 0, 0});
  }

  template <class Joint, class... Args>
  Joint* join(Args&&... args) {
    auto owned = std::make_unique<Joint>(std::forward<Args>(args)...);
    Joint* raw = owned.get();
    world.addConstraint(raw, true);
    joints.push_back(std::move(owned));
    return raw;
  }

  /// Small worlds are made by the thousand; larger ones take more memory as they need it.
  static btDefaultCollisionConstructionInfo smallPools() {
    btDefaultCollisionConstructionInfo info;
    info.m_defaultMaxPersistentManifoldPoolSize = 128;
    info.m_defaultMaxCollisionAlgorithmPoolSize = 128;
    return info;
  }

  void step() { world.stepSimulation(btScalar(1) / 60, 0); }

  /// The exact bits of every body's state.
  [[nodiscard]] std::vector<std::uint32_t> bits() const {
    std::vector<std::uint32_t> result;
    auto append = [&result](const btVector3& v) {
      for (int i = 0; i < 3; ++i) {
        const float value = v[i];
        std::uint32_t word = 0;
        std::memcpy(&word, &value, sizeof word);
        result.push_back(word);
      }
    };
    for (const auto& body : bodies) {
      append(body->getWorldTransform().getOrigin());
      for (int row = 0; row < 3; ++row) append(body->getWorldTransform().getBasis()[row]);
      append(body->getLinearVelocity());
      append(body->getAngularVelocity());
      result.push_back(static_cast<std::uint32_t>(body->getActivationState()));
    }
    return result;
  }

  /// Manifolds that no pair of the broadphase has.
  [[nodiscard]] int countOrphans() {
    return dispatcher.getNumManifolds() - countManifolds(*broadphase.getOverlappingPairCache());
  }

  Configuration configuration{smallPools()};
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  Solver solver;
  WorldType world;
  std::vector<std::unique_ptr<btCollisionShape>> shapes;
  std::vector<std::unique_ptr<btStridingMeshInterface>> meshes;
  std::vector<std::unique_ptr<btRigidBody>> bodies;
  std::vector<std::unique_ptr<btTypedConstraint>> joints;
};

}  // namespace scatter::test
