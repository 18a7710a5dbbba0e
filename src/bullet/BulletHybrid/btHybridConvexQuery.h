#ifndef BT_HYBRID_CONVEX_QUERY_H
#define BT_HYBRID_CONVEX_QUERY_H

#include <BulletCollision/CollisionShapes/btConvexShape.h>
#include <LinearMath/btTransform.h>

/// The distance of two convex shapes, margins included; 0 if they overlap. Metres. Bullet's GJK finds it and both
/// shapes' supports confirm it; where they do not, it is what they prove.
btScalar btHybridConvexDistance(const btConvexShape* shapeA, const btTransform& a, const btConvexShape* shapeB,
                                const btTransform& b);

/// How far two convex shapes must be moved apart, margins included; 0 or less if they do not overlap by more than
/// their margins. Bullet's EPA proposes the direction and both shapes' supports measure it, so that it is never
/// too little. Two boxes have sharp edges. Metres.
btScalar btHybridConvexDepth(const btConvexShape* shapeA, const btTransform& a, const btConvexShape* shapeB,
                             const btTransform& b);

/// How deep a convex shape reaches into the half-space of a btStaticPlaneShape; negative if it is out of it. Metres.
btScalar btHybridPlaneDepth(const btCollisionShape* plane, const btTransform& planeTransform,
                            const btConvexShape* shape, const btTransform& transform);

#endif  // BT_HYBRID_CONVEX_QUERY_H
