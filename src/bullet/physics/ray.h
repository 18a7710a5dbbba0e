#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>

namespace scatter {

/// Finds the closest hit, of whatever group, but for sensors and one object.
class ClosestRayHit final : public btCollisionWorld::ClosestRayResultCallback {
 public:
  ClosestRayHit(const btVector3& from, const btVector3& to, const btCollisionObject* ignored = nullptr)
      : ClosestRayResultCallback(from, to), ignored_(ignored) {}

  bool needsCollision(btBroadphaseProxy* proxy) const override {
    const auto* object = static_cast<const btCollisionObject*>(proxy->m_clientObject);
    return object != ignored_ && object->hasContactResponse();
  }

 private:
  const btCollisionObject* ignored_;
};

}  // namespace scatter
