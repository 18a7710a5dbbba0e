#ifndef BT_HYBRID_PROVEN_DISTANCE_H
#define BT_HYBRID_PROVEN_DISTANCE_H

#include <BulletCollision/CollisionShapes/btConvexShape.h>
#include <LinearMath/btTransform.h>

/// What is proven of the distance of two convex shapes as Bullet's GJK sees them: cores with margins around them.
struct btHybridProvenDistance
{
	double m_atLeast;  ///< a plane lies between them that shows it
	double m_atMost;   ///< a point of each is that near
	double m_cores;    ///< the same without margins, at most

	/// In double precision, with Bullet's support functions and nothing else of it or of the pair algorithm. Metres;
	/// where cores overlap, all are less than the margins by what is not known.
	btHybridProvenDistance(const btConvexShape* shapeA, const btTransform& a, const btConvexShape* shapeB,
	                       const btTransform& b);
};

#endif  // BT_HYBRID_PROVEN_DISTANCE_H
