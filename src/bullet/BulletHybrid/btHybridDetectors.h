#ifndef BT_HYBRID_DETECTORS_H
#define BT_HYBRID_DETECTORS_H

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

/// Two boxes, into the manifold of the result.
void btHybridCollideBoxes(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                          const btDispatcherInfo& info, btManifoldResult* result);

/// What Bullet does with two convex shapes, or with a convex one and a plane, into a manifold that is given; the result
/// must have it too. The algorithms for boxes and planes insist on manifolds of their own, so their work is called
/// directly. Not for two spheres.
void btHybridDetect(btCollisionDispatcher* dispatcher, const btCollisionObjectWrapper* a,
                    const btCollisionObjectWrapper* b, btPersistentManifold* manifold, const btDispatcherInfo& info,
                    btManifoldResult* result);

#endif  // BT_HYBRID_DETECTORS_H
