#include "btHybridShapeQuery.h"

#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConcaveShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <LinearMath/btAabbUtil2.h>

#include <algorithm>
#include <memory>
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

	Child(const btCollisionShape* shape, const btTransform& body, int part)
	{
		const btCompoundShape* compound = shape->isCompound() ? static_cast<const btCompoundShape*>(shape) : 0;
		m_shape = static_cast<const btConvexShape*>(compound ? compound->getChildShape(part) : shape);
		m_transform = compound ? body * compound->getChildTransform(part) : body;
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
		return Child(m_partsA.getShape(), m_a, near.a);
	}
	Child childB(const scatter::Neighbours& near) const
	{
		return Child(m_partsB.getShape(), m_b, near.b);
	}
};

scatter::GjkResult coreDistance(const PartPlaces& places, const scatter::Neighbours& near, btScalar enough)
{
	const scatter::PartList::Part& a = places.partA(near);
	const scatter::PartList::Part& b = places.partB(near);
	const bool boxes = areBoxes(a, b);
	scatter::WarmSimplex warm;
	return scatter::gjkDistance(boxes ? a.sharp : a.core, boxes ? b.sharp : b.core, places.m_frameB, near.axis, enough, c_gjkTolerance, warm);
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

void getAabb(const btHybridPlacedShape& placed, btScalar wider, btVector3& aabbMin, btVector3& aabbMax)
{
	placed.m_shape->getAabb(placed.m_transform, aabbMin, aabbMax);
	const btVector3 wide(wider, wider, wider);
	aabbMin -= wide;
	aabbMax += wide;
}

// Convex pieces and planes of a shape that is no part list.
class Pieces : public btTriangleCallback
{
	std::vector<btHybridPlacedShape> m_pieces;
	std::vector<std::unique_ptr<btTriangleShape>> m_triangles;
	btTransform m_mesh;
	btScalar m_meshMargin;

public:
	const std::vector<btHybridPlacedShape>& get() const
	{
		return m_pieces;
	}

	// What lies in the box. Shapes that hand out neither children nor triangles have no pieces.
	void collect(const btHybridPlacedShape& placed, const btVector3& aabbMin, const btVector3& aabbMax)
	{
		const btCollisionShape* shape = placed.m_shape;
		if (shape->getShapeType() == STATIC_PLANE_PROXYTYPE)
		{
			m_pieces.push_back(placed);
			return;
		}
		btVector3 lower, upper;
		getAabb(placed, 0, lower, upper);
		if (shape->getShapeType() == EMPTY_SHAPE_PROXYTYPE || !TestAabbAgainstAabb2(lower, upper, aabbMin, aabbMax))
			return;
		if (shape->isConvex())
			m_pieces.push_back(placed);
		else if (shape->isCompound())
			collectChildren(placed, aabbMin, aabbMax);
		else if (shape->isConcave())
			collectTriangles(placed, aabbMin, aabbMax);
	}

	virtual void processTriangle(btVector3* triangle, int, int)
	{
		m_triangles.push_back(std::make_unique<btTriangleShape>(triangle[0], triangle[1], triangle[2]));
		m_triangles.back()->setMargin(m_meshMargin);
		m_pieces.push_back({m_triangles.back().get(), m_mesh});
	}

private:
	void collectChildren(const btHybridPlacedShape& placed, const btVector3& aabbMin, const btVector3& aabbMax)
	{
		const btCompoundShape* compound = static_cast<const btCompoundShape*>(placed.m_shape);
		for (int i = 0; i < compound->getNumChildShapes(); i++)
			collect({compound->getChildShape(i), placed.m_transform * compound->getChildTransform(i)}, aabbMin, aabbMax);
	}

	void collectTriangles(const btHybridPlacedShape& placed, const btVector3& aabbMin, const btVector3& aabbMax)
	{
		m_mesh = placed.m_transform;
		m_meshMargin = placed.m_shape->getMargin();
		btVector3 lower, upper;
		btTransformAabb(aabbMin, aabbMax, m_meshMargin, m_mesh.inverse(), lower, upper);
		static_cast<const btConcaveShape*>(placed.m_shape)->processAllTriangles(this, lower, upper);
	}
};

// Calls `visit` with every two pieces that are not further apart, by their bounds, than `reach`.
template <class Visit>
void forEachPiecePair(const btHybridPlacedShape& a, const btHybridPlacedShape& b, btScalar reach, const Visit& visit)
{
	btVector3 aabbMin, aabbMax;
	Pieces piecesA, piecesB;
	getAabb(b, reach, aabbMin, aabbMax);
	piecesA.collect(a, aabbMin, aabbMax);
	getAabb(a, reach, aabbMin, aabbMax);
	piecesB.collect(b, aabbMin, aabbMax);
	for (const btHybridPlacedShape& pieceA : piecesA.get())
		for (const btHybridPlacedShape& pieceB : piecesB.get())
			visit(pieceA, pieceB);
}

bool isPlane(const btHybridPlacedShape& piece)
{
	return piece.m_shape->getShapeType() == STATIC_PLANE_PROXYTYPE;
}

const btConvexShape* asConvex(const btHybridPlacedShape& piece)
{
	return static_cast<const btConvexShape*>(piece.m_shape);
}

btScalar pieceDepth(const btHybridPlacedShape& a, const btHybridPlacedShape& b)
{
	if (isPlane(a) && isPlane(b))
		return -BT_LARGE_FLOAT;
	if (isPlane(a))
		return btHybridPlaneDepth(a.m_shape, a.m_transform, asConvex(b), b.m_transform);
	if (isPlane(b))
		return btHybridPlaneDepth(b.m_shape, b.m_transform, asConvex(a), a.m_transform);
	return btHybridConvexDepth(asConvex(a), a.m_transform, asConvex(b), b.m_transform);
}

btScalar pieceDistance(const btHybridPlacedShape& a, const btHybridPlacedShape& b)
{
	if (isPlane(a) || isPlane(b))
		return btMax(btScalar(0), -pieceDepth(a, b));
	return btHybridConvexDistance(asConvex(a), a.m_transform, asConvex(b), b.m_transform);
}

bool piecesOverlapDeeper(const btHybridPlacedShape& a, const btHybridPlacedShape& b, btScalar depth)
{
	bool deeper = false;
	forEachPiecePair(a, b, 0, [&](const btHybridPlacedShape& pieceA, const btHybridPlacedShape& pieceB)
	                 { deeper = deeper || pieceDepth(pieceA, pieceB) > depth; });
	return deeper;
}

btScalar piecesDistance(const btHybridPlacedShape& a, const btHybridPlacedShape& b)
{
	btScalar least = BT_LARGE_FLOAT;
	// A distance beyond the reach that was searched need not be the least.
	for (btScalar reach = c_firstReach, searched = 0; least > searched && searched < c_furthest; searched = reach, reach *= c_widening)
		forEachPiecePair(a, b, reach, [&](const btHybridPlacedShape& pieceA, const btHybridPlacedShape& pieceB)
		                 { least = btMin(least, pieceDistance(pieceA, pieceB)); });
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
void btHybridShapeQuery::findNear(const scatter::PartList& a, const scatter::PartList& b, const scatter::Frame& frameB, btScalar limit)
{
	m_search.byPartBoxes(a, b, frameB, limit);
	m_near = m_search.found();
	std::stable_sort(m_near.begin(), m_near.end(), [](const scatter::Neighbours& x, const scatter::Neighbours& y)
	                 { return x.separation < y.separation; });
}

bool btHybridShapeQuery::partsOverlapDeeper(const btHybridParts& partsA, const btTransform& a, const btHybridParts& partsB, const btTransform& b, btScalar depth)
{
	const PartPlaces places = {partsA, a, partsB, b, scatter::relativeFrame(btHybridFrameOf(a), btHybridFrameOf(b))};
	findNear(partsA.getList(), partsB.getList(), places.m_frameB, -depth);
	return std::any_of(m_near.begin(), m_near.end(), [&](const scatter::Neighbours& near)
	                   { return partOverlapsDeeper(places, near, depth); });
}

btScalar btHybridShapeQuery::partsDistance(const btHybridParts& partsA, const btTransform& a, const btHybridParts& partsB, const btTransform& b)
{
	const PartPlaces places = {partsA, a, partsB, b, scatter::relativeFrame(btHybridFrameOf(a), btHybridFrameOf(b))};
	btScalar least = BT_LARGE_FLOAT;
	for (btScalar reach = c_firstReach, searched = 0; least > searched && searched < c_furthest; searched = reach, reach *= c_widening)
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
