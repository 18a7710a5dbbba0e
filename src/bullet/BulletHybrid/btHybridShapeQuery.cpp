#include "btHybridShapeQuery.h"

#include <algorithm>
#include <vector>

#include "btHybridConvexQuery.h"
#include "btHybridPartBody.h"
#include "collision/gjk.h"
#include "collision/part_query.h"

namespace
{
const btScalar c_firstReach = btScalar(0.05);  // metres; most that are asked about touch
const btScalar c_widening = btScalar(4);
const btScalar c_furthest = btScalar(1e5);
const btScalar c_gjkTolerance = btScalar(1e-4);

bool areBoxes(const scatter::PartList::Part& a, const scatter::PartList::Part& b)
{
	return a.kind == scatter::PartKind::kBox && b.kind == scatter::PartKind::kBox;
}

// Whether the part's core and margin are its shape.
bool isExact(const scatter::PartList::Part& part)
{
	return part.kind != scatter::PartKind::kEnclosed && part.kind != scatter::PartKind::kOpaque;
}

// A part of a shape as Bullet knows it.
struct Child
{
	const btConvexShape* m_shape;
	btTransform m_transform;

	Child(const btHybridParts& parts, const btTransform& body, int part)
	    : m_shape(static_cast<const btConvexShape*>(parts.getPartShape(part))),
	      m_transform(body * parts.getPartTransform(part))
	{
	}
};

// Two lists of parts and where they are.
struct PartPlaces
{
	const btHybridParts& m_partsA;
	const btTransform& m_a;
	const btHybridParts& m_partsB;
	const btTransform& m_b;
	scatter::Frame m_frameB;  // in A's

	const scatter::PartList::Part& partA(const scatter::Neighbours& near) const
	{
		return m_partsA.getList().part(near.a);
	}
	const scatter::PartList::Part& partB(const scatter::Neighbours& near) const
	{
		return m_partsB.getList().part(near.b);
	}
	Child childA(const scatter::Neighbours& near) const
	{
		return Child(m_partsA, m_a, near.a);
	}
	Child childB(const scatter::Neighbours& near) const
	{
		return Child(m_partsB, m_b, near.b);
	}
};

scatter::GjkResult coreDistance(const PartPlaces& places, const scatter::Neighbours& near, btScalar enough)
{
	const scatter::PartList::Part& a = places.partA(near);
	const scatter::PartList::Part& b = places.partB(near);
	const bool boxes = areBoxes(a, b);
	scatter::WarmSimplex warm;
	return scatter::gjkDistance(boxes ? a.sharp : a.core, boxes ? b.sharp : b.core, places.m_frameB, near.axis, enough,
	                            c_gjkTolerance, warm);
}

btScalar marginOf(const PartPlaces& places, const scatter::Neighbours& near)
{
	const scatter::PartList::Part& a = places.partA(near);
	const scatter::PartList::Part& b = places.partB(near);
	return areBoxes(a, b) ? btScalar(0) : a.margin + b.margin;
}

// The distance, or anything above `enough` if it is more.
btScalar partDistance(const PartPlaces& places, const scatter::Neighbours& near, btScalar enough)
{
	typedef scatter::GjkResult::State State;
	if (isExact(places.partA(near)) && isExact(places.partB(near)))
	{
		const btScalar margin = marginOf(places, near);
		const scatter::GjkResult result = coreDistance(places, near, enough + margin);
		if (result.state == State::kApart)
			return BT_LARGE_FLOAT;
		if (result.state == State::kConverged)
			return btMax(btScalar(0), result.distance - margin);
		if (result.state == State::kOverlap)
			return 0;
	}
	const Child a = places.childA(near);
	const Child b = places.childB(near);
	return btHybridConvexDistance(a.m_shape, a.m_transform, b.m_shape, b.m_transform);
}

bool partOverlapsDeeper(const PartPlaces& places, const scatter::Neighbours& near, btScalar depth)
{
	typedef scatter::GjkResult::State State;
	const scatter::PartList::Part& partA = places.partA(near);
	const scatter::PartList::Part& partB = places.partB(near);
	if (scatter::partDepth(partA, partB, places.m_frameB) <= depth)
		return false;
	if (areBoxes(partA, partB))
		return true;
	if (isExact(partA) && isExact(partB))
	{
		const btScalar margin = marginOf(places, near);
		const scatter::GjkResult result = coreDistance(places, near, btMax(btScalar(0), margin - depth));
		if (result.state == State::kApart)
			return false;
		if (result.state == State::kConverged)
			return margin - result.distance > depth;
	}
	const Child a = places.childA(near);
	const Child b = places.childB(near);
	return btHybridConvexDepth(a.m_shape, a.m_transform, b.m_shape, b.m_transform) > depth;
}

btScalar pieceDepth(const btHybridPiece& a, const btHybridPiece& b)
{
	if (a.isPlane() && b.isPlane())
		return -BT_LARGE_FLOAT;
	const btTransform& transformA = a.m_placed.m_transform;
	const btTransform& transformB = b.m_placed.m_transform;
	if (a.isPlane())
		return btHybridPlaneDepth(a.m_placed.m_shape, transformA, b.asConvex(), transformB);
	if (b.isPlane())
		return btHybridPlaneDepth(b.m_placed.m_shape, transformB, a.asConvex(), transformA);
	return btHybridConvexDepth(a.asConvex(), transformA, b.asConvex(), transformB);
}

btScalar pieceDistance(const btHybridPiece& a, const btHybridPiece& b)
{
	if (a.isPlane() || b.isPlane())
		return btMax(btScalar(0), -pieceDepth(a, b));
	return btHybridConvexDistance(a.asConvex(), a.m_placed.m_transform, b.asConvex(), b.m_placed.m_transform);
}

bool piecesOverlapDeeper(const btHybridPlacedShape& a, const btHybridPlacedShape& b, btScalar depth)
{
	bool deeper = false;
	btHybridVisitPieces(a, b, 0,
	                    [&](const btHybridPiece& pieceA, const btHybridPiece& pieceB)
	                    {
		                    deeper = pieceDepth(pieceA, pieceB) > depth;
		                    return !deeper;
	                    });
	return deeper;
}

btScalar piecesDistance(const btHybridPlacedShape& a, const btHybridPlacedShape& b)
{
	btScalar least = BT_LARGE_FLOAT;
	// A distance beyond the reach that was searched need not be the least.
	for (btScalar reach = c_firstReach, searched = 0; least > searched && searched < c_furthest;
	     searched = reach, reach *= c_widening)
		btHybridVisitPieces(a, b, reach,
		                    [&](const btHybridPiece& pieceA, const btHybridPiece& pieceB)
		                    {
			                    least = btMin(least, pieceDistance(pieceA, pieceB));
			                    return true;
		                    });
	return least;
}
}  // namespace

btHybridShapeQuery::btHybridShapeQuery()
{
}

btHybridShapeQuery::~btHybridShapeQuery()
{
	for (int i = 0; i < m_parts.size(); i++)
		delete *m_parts.getAtIndex(i);
}

const btHybridParts* btHybridShapeQuery::partsOf(const btCollisionShape* shape)
{
	btHybridParts** const known = m_parts.find(btHashPtr(shape));
	if (known)
		return *known;
	btHybridParts* const parts = btHybridParts::isPartList(shape) ? new btHybridParts(shape) : 0;
	m_parts.insert(btHashPtr(shape), parts);
	return parts;
}

// Nearest, or deepest, first.
void btHybridShapeQuery::findNear(const scatter::PartList& a, const scatter::PartList& b, const scatter::Frame& frameB,
                                  btScalar limit)
{
	m_search.byPartBoxes(a, b, frameB, limit);
	m_near = m_search.found();
	std::stable_sort(m_near.begin(), m_near.end(),
	                 [](const scatter::Neighbours& x, const scatter::Neighbours& y)
	                 { return x.separation < y.separation; });
}

bool btHybridShapeQuery::partsOverlapDeeper(const btHybridParts& partsA, const btTransform& a,
                                            const btHybridParts& partsB, const btTransform& b, btScalar depth)
{
	const PartPlaces places = {partsA, a, partsB, b, scatter::relativeFrame(btHybridFrameOf(a), btHybridFrameOf(b))};
	findNear(partsA.getList(), partsB.getList(), places.m_frameB, -depth);
	return std::any_of(m_near.begin(), m_near.end(),
	                   [&](const scatter::Neighbours& near) { return partOverlapsDeeper(places, near, depth); });
}

btScalar btHybridShapeQuery::partsDistance(const btHybridParts& partsA, const btTransform& a,
                                           const btHybridParts& partsB, const btTransform& b)
{
	const PartPlaces places = {partsA, a, partsB, b, scatter::relativeFrame(btHybridFrameOf(a), btHybridFrameOf(b))};
	btScalar least = BT_LARGE_FLOAT;
	for (btScalar reach = c_firstReach, searched = 0; least > searched && searched < c_furthest;
	     searched = reach, reach *= c_widening)
	{
		findNear(partsA.getList(), partsB.getList(), places.m_frameB, reach);
		for (std::size_t i = 0; i < m_near.size() && m_near[i].separation < least; i++)
			least = btMin(least, partDistance(places, m_near[i], least));
	}
	return least;
}

bool btHybridShapeQuery::overlapDeeper(const btHybridPlacedShape& a, const btHybridPlacedShape& b, btScalar depth)
{
	const btHybridParts* const partsA = partsOf(a.m_shape);
	const btHybridParts* const partsB = partsOf(b.m_shape);
	if (partsA && partsB)
		return partsOverlapDeeper(*partsA, a.m_transform, *partsB, b.m_transform, depth);
	return piecesOverlapDeeper(a, b, depth);
}

btScalar btHybridShapeQuery::getDistance(const btHybridPlacedShape& a, const btHybridPlacedShape& b)
{
	const btHybridParts* const partsA = partsOf(a.m_shape);
	const btHybridParts* const partsB = partsOf(b.m_shape);
	if (partsA && partsB)
		return partsDistance(*partsA, a.m_transform, *partsB, b.m_transform);
	return piecesDistance(a, b);
}
