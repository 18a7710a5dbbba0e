#pragma once

#include <BulletCollision/CollisionDispatch/btGhostObject.h>
#include <BulletDynamics/Character/btKinematicCharacterController.h>
#include <btBulletDynamicsCommon.h>

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

  [[nodiscard]] int countOwnManifolds() {
    btManifoldArray all;
    for (int i = 0; i < ownPairs().getNumOverlappingPairs(); ++i) {
      btCollisionAlgorithm* own = ownPairs().getOverlappingPairArray()[i].m_algorithm;
      if (own != nullptr) own->getAllContactManifolds(all);
    }
    return all.size();
  }

 private:
  btDiscreteDynamicsWorld& world_;
  btGhostPairCallback callback_;
  btCapsuleShape capsule_{0.3F, 0.6F};
  btPairCachingGhostObject ghost_;
  btKinematicCharacterController walker_{&ghost_, &capsule_, 0.2F};
};

}  // namespace scatter::test
