#pragma once

#include <BulletCollision/CollisionDispatch/btGhostObject.h>
#include <BulletDynamics/Character/btKinematicCharacterController.h>
#include <btBulletDynamicsCommon.h>
#include <memory>

#include "BulletTestWorld.h"
#include "RandomShapes.h"

namespace scatter::test {

/// A character in a world, as long as it lives. Its ghost keeps pairs beside those of the broadphase, with
/// algorithms of their own, which the character dispatches when it moves.
class TestCharacter {
 public:
  TestCharacter(btDiscreteDynamicsWorld& world, const btVector3& position, int flags = 0) : world_(world) {
    world_.getPairCache()->setInternalGhostPairCallback(&callback_);
    ghost_.setCollisionShape(&capsule_);
    ghost_.setCollisionFlags(btCollisionObject::CF_CHARACTER_OBJECT | flags);
    ghost_.setWorldTransform(btTransform(btQuaternion::getIdentity(), position));
    walker_.setGravity(btVector3(0, 0, 0));
    world_.addCollisionObject(&ghost_, btBroadphaseProxy::CharacterFilter, -1);
    world_.addAction(&walker_);
  }
  TestCharacter(const TestCharacter&) = delete;
  TestCharacter& operator=(const TestCharacter&) = delete;
  ~TestCharacter() {
    world_.removeAction(&walker_);
    world_.removeCollisionObject(&ghost_);
    world_.getPairCache()->setInternalGhostPairCallback(nullptr);
  }

  void walk(const btVector3& step) { walker_.setWalkDirection(step); }

  [[nodiscard]] btHashedOverlappingPairCache& ownPairs() { return *ghost_.getOverlappingPairCache(); }

  [[nodiscard]] int countOwnManifolds() { return countManifolds(ownPairs()); }

  /// A body has another shape.
  void cleanPairs(const btRigidBody& body) {
    ownPairs().cleanProxyFromPairs(const_cast<btBroadphaseProxy*>(body.getBroadphaseHandle()),
                                   world_.getDispatcher());
  }

 private:
  btDiscreteDynamicsWorld& world_;
  btGhostPairCallback callback_;
  btCapsuleShape capsule_{0.3F, 0.6F};
  btPairCachingGhostObject ghost_;
  btKinematicCharacterController walker_{&ghost_, &capsule_, 0.2F};
};

/// What a program does at random with its character, or to have one.
inline void letWalk(std::unique_ptr<TestCharacter>& character, btDiscreteDynamicsWorld& world,
                    Random& random) {
  if (!character) {
    character = std::make_unique<TestCharacter>(world, random.inCube(2));
  } else if (random.chance(0.6F)) {
    character->walk(random.inCube(0.1F));
  } else {
    character.reset();
  }
}

}  // namespace scatter::test
