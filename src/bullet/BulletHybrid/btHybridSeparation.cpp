#include "BulletHybrid/btHybridSeparation.h"

#include <cmath>

#include "btHybridConvexQuery.h"
#include "btHybridFinite.h"
#include "btHybridPieces.h"

static bool isSeparated(const btHybridPiece& a, const btHybridPiece& b, btScalar gap)
{
	const btHybridPlacedShape& placedA = a.m_placed;
	const btHybridPlacedShape& placedB = b.m_placed;
	if (a.isPlane() && b.isPlane())
		return false;
	if (a.isPlane())
		return -btHybridPlaneDepth(placedA.m_shape, placedA.m_transform, b.asConvex(), placedB.m_transform) > gap;
	if (b.isPlane())
		return -btHybridPlaneDepth(placedB.m_shape, placedB.m_transform, a.asConvex(), placedA.m_transform) > gap;
	return btHybridProvenGap(a.asConvex(), placedA.m_transform, b.asConvex(), placedB.m_transform) > gap;
}

bool btHybridIsSeparated(const btCollisionShape* shapeA, const btTransform& transformA,
                         const btCollisionShape* shapeB, const btTransform& transformB, btScalar gap)
{
	// Bounds of what is nowhere are near nothing.
	if (!shapeA || !shapeB || !btHybridIsFinite(transformA) || !btHybridIsFinite(transformB) || !std::isfinite(gap))
		return false;
	const btHybridPlacedShape a = {shapeA, transformA};
	const btHybridPlacedShape b = {shapeB, transformB};
	return btHybridVisitPieces(a, b, gap, [gap](const btHybridPiece& pieceA, const btHybridPiece& pieceB)
	                           { return isSeparated(pieceA, pieceB, gap); });
}
