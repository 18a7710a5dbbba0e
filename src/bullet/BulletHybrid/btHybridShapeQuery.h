#ifndef BT_HYBRID_SHAPE_QUERY_H
#define BT_HYBRID_SHAPE_QUERY_H

#include <LinearMath/btHashMap.h>

#include <vector>

#include "btHybridParts.h"
#include "btHybridPieces.h"
#include "collision/neighbour_search.h"

/// How deep shapes overlap and how far they are apart, margins included; between their convex parts, in any order.
/// Remembers what it has learned of shapes, which must not change while it lives, and nothing of where they were.
class btHybridShapeQuery
{
	btHashMap<btHashPtr, btHybridParts*> m_parts;
	scatter::NeighbourSearch m_search;
	std::vector<scatter::Neighbours> m_near;

	btHybridShapeQuery(const btHybridShapeQuery&);
	btHybridShapeQuery& operator=(const btHybridShapeQuery&);

	const btHybridParts* partsOf(const btCollisionShape* shape);
	void findNear(const scatter::PartList& a, const scatter::PartList& b, const scatter::Frame& frameB, btScalar limit);
	bool partsOverlapDeeper(const btHybridParts& partsA, const btTransform& a, const btHybridParts& partsB,
	                        const btTransform& b, btScalar depth);
	btScalar partsDistance(const btHybridParts& partsA, const btTransform& a, const btHybridParts& partsB,
	                       const btTransform& b);

public:
	btHybridShapeQuery();
	~btHybridShapeQuery();

	/// Whether a part of one must be moved by more than `depth` metres, which is not negative, to leave a part of
	/// the other. Of meshes a triangle is a part.
	bool overlapDeeper(const btHybridPlacedShape& a, const btHybridPlacedShape& b, btScalar depth);

	/// Metres, however far; 0 if they overlap, BT_LARGE_FLOAT if one of them has no part.
	btScalar getDistance(const btHybridPlacedShape& a, const btHybridPlacedShape& b);
};

#endif  // BT_HYBRID_SHAPE_QUERY_H
