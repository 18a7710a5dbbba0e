#ifndef BT_HYBRID_HULL_H
#define BT_HYBRID_HULL_H

#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <vector>

#include "levels/polytope.h"

/// The points whose hull, widened by its margin, a shape is, in its frame: of a btConvexHullShape all of them, of a
/// btConvexTriangleMeshShape its mesh's vertices. None if it is of another kind, or has polyhedral features: Bullet's
/// contacts of those are of their own kind.
std::vector<btVector3> btHybridHullPoints(const btCollisionShape* shape);

/// The convex hull of points; empty if they have no volume. Bullet finds which points are corners, with coordinates
/// rounded to a ten-thousandth of the extent; each face's plane is moved out so that it holds all points, and `moved`,
/// unless 0, is set to the furthest of these moves.
scatter::levels::Polytope btHybridHullOf(const std::vector<glm::dvec3>& points, double* moved = 0);

#endif  // BT_HYBRID_HULL_H
