#pragma once

#include <memory>
#include <string>
#include <vector>

#include "HybridTestWorld.h"
#include "RandomShapes.h"

namespace scatter::test {

/// Writes down what becomes of pairs, too.
class PairLog : public EventLog {
 public:
  void pairEvent(const btHybridPairEvent& event) override { events.push_back(event); }

  /// What happened to a pair, in words.
  [[nodiscard]] std::vector<std::string> story(const btCollisionObject* a, const btCollisionObject* b) const {
    const char* const names[] = {"requested", "acknowledged", "blocked", "switched", "retracted"};
    std::vector<std::string> result;
    for (const btHybridPairEvent& event : events) {
      const bool isTheirs =
          (event.m_objectA == a && event.m_objectB == b) || (event.m_objectA == b && event.m_objectB == a);
      if (!isTheirs) continue;
      result.push_back(std::string(names[static_cast<int>(event.m_kind)]) + " " +
                       std::to_string(event.m_fromLevel) + " to " + std::to_string(event.m_toLevel) +
                       (event.m_onCredit ? " on credit" : ""));
    }
    return result;
  }

  using EventLog::story;

  std::vector<btHybridPairEvent> events;
};

/// A world that switches by pairs, with three-levelled bodies. Besides the crosses of HybridTestWorld:
/// - blocks: a cube of 1 m made of eight boxes; around it four boxes that stick out by 10 cm; around those
/// one box that
///   sticks out by 20 cm.
/// - ships: hulls in the bars of a cross of 2 m; the bars; the box around them.
class PairTestWorld : public HybridTestWorld {
 public:
  explicit PairTestWorld(btHybridSwitchingMode mode = BT_HYBRID_PAIR_SWITCHING, std::uint64_t seed = 1)
      : HybridTestWorld(mode), shapes_(seed) {
    buildBlock();
    buildShip();
    world.setListener(&pairs);
  }

  ~PairTestWorld() {
    world.setListener(nullptr);
    for (auto& joint : joints) world.removeConstraint(joint.get());
    joints.clear();
    for (auto& body : bodies) {
      if (body->getWorldArrayIndex() >= 0) world.removeRigidBody(body.get());
    }
  }

  btHybridRigidBody* addBody(const btHybridLevelSet& levels, const btTransform& pose, btScalar mass = 1,
                             int level = 0) {
    auto definition = info(mass, levels.getLevelShape(levels.getNumLevels()), pose.getOrigin());
    definition.m_startWorldTransform = pose;
    auto body = std::make_unique<btHybridRigidBody>(definition, &levels, level);
    btHybridRigidBody* raw = body.get();
    raw->setActivationState(DISABLE_DEACTIVATION);
    bodies.push_back(std::move(body));
    world.addRigidBody(raw);
    return raw;
  }

  btHybridRigidBody* addBlock(const btVector3& position, btScalar mass = 1, int level = 0) {
    return addBody(block, btTransform(btQuaternion::getIdentity(), position), mass, level);
  }

  /// The ground as a box, whose top is at y = 0.
  btRigidBody* addFloor() { return add(0, shape<btBoxShape>(btVector3(50, 1, 50)), {0, -1, 0}); }

  void requestAll(int level) {
    for (int i = 0; i < world.getNumHybrids(); ++i) world.requestLevel(world.getHybrid(i), level);
  }

  [[nodiscard]] int levelOf(const btCollisionObject* a, const btCollisionObject* b) const {
    return world.getPairLevel(a, b);
  }

  [[nodiscard]] btHybridPairStepInfo pairInfo() const { return world.getPairStepInfo(); }

  [[nodiscard]] int contactsOf(const btCollisionObject* a, const btCollisionObject* b) const {
    int count = 0;
    forContactsOf(a, b, [&count](const btManifoldPoint&) { ++count; });
    return count;
  }

  /// The distance of the deepest contact of two bodies; a large number without contacts.
  [[nodiscard]] float deepestOf(const btCollisionObject* a, const btCollisionObject* b) const {
    float least = 1e9F;
    forContactsOf(a, b,
                  [&least](const btManifoldPoint& point) { least = btMin(least, point.getDistance()); });
    return least;
  }

  [[nodiscard]] const btPersistentManifold& manifoldAt(int index) const {
    return *const_cast<btCollisionDispatcher&>(dispatcher).getManifoldByIndexInternal(index);
  }

  PairLog pairs;
  btHybridLevelSet block;
  btHybridLevelSet ship;

 private:
  template <class Visit>
  void forContactsOf(const btCollisionObject* a, const btCollisionObject* b, Visit&& visit) const {
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
      const btPersistentManifold& manifold = manifoldAt(i);
      const bool isTheirs = (manifold.getBody0() == a && manifold.getBody1() == b) ||
                            (manifold.getBody0() == b && manifold.getBody1() == a);
      for (int k = 0; isTheirs && k < manifold.getNumContacts(); ++k) visit(manifold.getContactPoint(k));
    }
  }

  void buildBlock() {
    auto* fine = shape<btCompoundShape>();
    auto* small = shape<btBoxShape>(btVector3(0.25F, 0.25F, 0.25F));
    for (int i = 0; i < 8; ++i) {
      const btVector3 corner(i % 2 == 0 ? -0.25F : 0.25F, i / 2 % 2 == 0 ? -0.25F : 0.25F,
                             i / 4 == 0 ? -0.25F : 0.25F);
      fine->addChildShape(btTransform(btQuaternion::getIdentity(), corner), small);
    }
    auto* middle = shape<btCompoundShape>();
    auto* column = shape<btBoxShape>(btVector3(0.3F, 0.6F, 0.3F));
    for (int i = 0; i < 4; ++i) {
      const btVector3 corner(i % 2 == 0 ? -0.3F : 0.3F, 0, i / 2 == 0 ? -0.3F : 0.3F);
      middle->addChildShape(btTransform(btQuaternion::getIdentity(), corner), column);
    }
    block.addLevel(shape<btBoxShape>(btVector3(0.7F, 0.7F, 0.7F)));
    block.addLevel(middle);
    block.addLevel(fine);
  }

  void buildShip() {
    auto* fine = shape<btCompoundShape>();
    auto* middle = shape<btCompoundShape>();
    for (int axis = 0; axis < 3; ++axis) {
      for (int i = 0; i < 4; ++i) {
        btVector3 place(0, 0, 0);
        place[axis] = -0.75F + 0.5F * static_cast<float>(i);
        // A hull reaches no further than half its size and its margin, a tenth, in every direction.
        fine->addChildShape(btTransform(shapes_.random.rotation(), place), shapes_.hull(0.42F, 14));
      }
      btVector3 half(0.3F, 0.3F, 0.3F);
      half[axis] = 1.05F;
      middle->addChildShape(btTransform::getIdentity(), shape<btBoxShape>(half));
    }
    ship.addLevel(shape<btBoxShape>(btVector3(1.15F, 1.15F, 1.15F)));
    ship.addLevel(middle);
    ship.addLevel(fine);
  }

  RandomShapes shapes_;
};

}  // namespace scatter::test
