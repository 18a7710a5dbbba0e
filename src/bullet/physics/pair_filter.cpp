#include "bullet/physics/pair_filter.h"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>

namespace scatter {

bool BulletPairFilter::needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const {
  const auto* first = static_cast<const btCollisionObject*>(a->m_clientObject);
  const auto* second = static_cast<const btCollisionObject*>(b->m_clientObject);
  return (a->m_collisionFilterGroup & b->m_collisionFilterMask) != 0 &&
         (b->m_collisionFilterGroup & a->m_collisionFilterMask) != 0 &&
         !(first->isStaticOrKinematicObject() && second->isStaticOrKinematicObject());
}

}  // namespace scatter
