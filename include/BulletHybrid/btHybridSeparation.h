#ifndef BT_HYBRID_SEPARATION_H
#define BT_HYBRID_SEPARATION_H

#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <LinearMath/btTransform.h>

/// A direct query whether two shapes are further than gap apart, collision margins included. Adds nothing
/// to any world, creates no manifold and changes neither shape. True only if a separating plane proves it
/// for every pair of convex pieces; touching, overlapping, unknown shape types, no shape, places and gaps that are not
/// finite, and doubt all give false.
/// A closed triangle mesh is its surface, as everywhere in Bullet.
bool btHybridIsSeparated(const btCollisionShape* shapeA, const btTransform& transformA, const btCollisionShape* shapeB,
                         const btTransform& transformB, btScalar gap);

#endif  // BT_HYBRID_SEPARATION_H
