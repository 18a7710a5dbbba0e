#pragma once

#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <algorithm>

#include "RandomShapes.h"

namespace scatter::test {

/// How far a shape reaches along a direction in the world.
inline btScalar reachOf(const btCollisionShape* shape, const btTransform& pose, const btVector3& direction) {
  if (!shape->isCompound()) {
    const auto* convex = static_cast<const btConvexShape*>(shape);
    return (pose * convex->localGetSupportingVertex(direction * pose.getBasis())).dot(direction);
  }
  const auto* compound = static_cast<const btCompoundShape*>(shape);
  btScalar reach = -SIMD_INFINITY;
  for (int i = 0; i < compound->getNumChildShapes(); ++i) {
    const btTransform place = pose * compound->getChildTransform(i);
    reach = std::max(reach, reachOf(compound->getChildShape(i), place, direction));
  }
  return reach;
}

/// Of up to ten parts, round ones among them, so that there are those whose balls are too many.
inline btCollisionShape* randomLevel(RandomShapes& shapes) {
  if (shapes.random.chance(0.4F)) return shapes.convex(2);
  auto* compound = shapes.make<btCompoundShape>();
  for (int i = shapes.random.index(10); i >= 0; --i)
    compound->addChildShape(shapes.random.pose(1), shapes.convex(1));
  return compound;
}

}  // namespace scatter::test
