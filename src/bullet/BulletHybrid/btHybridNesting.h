#ifndef BT_HYBRID_NESTING_H
#define BT_HYBRID_NESTING_H

#include <BulletCollision/CollisionShapes/btCollisionShape.h>

/// Where a level sticks out of the one before it.
struct btHybridProtrusion
{
	int m_child;          ///< of the finer level: the one that sticks out furthest; -1: none does
	btVector3 m_point;    ///< in the levels' frame
	btScalar m_distance;  ///< from the coarser level, metres

	btHybridProtrusion() : m_child(-1), m_point(0, 0, 0), m_distance(0)
	{
	}
};

/// Looks whether the union of the coarser shape's parts holds every part of the finer one, collision margins included.
/// Both are convex or compounds of convex shapes, and finite. See btHybridLevelSet::addLevel for what is exact.
/// tolerance: metres by which a part may stick out.
btHybridProtrusion btHybridFindProtrusion(const btCollisionShape* finer, const btCollisionShape* coarser,
                                          double tolerance);

#endif  // BT_HYBRID_NESTING_H
