#include "BulletHybrid/btHybridSeparation.h"

#include <BulletCollision/BroadphaseCollision/btDbvt.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConcaveShape.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>
#include <LinearMath/btAabbUtil2.h>

#include <cmath>

#include "btHybridFinite.h"
#include "btHybridPieces.h"

namespace
{
bool isSeparated(const btHybridPlacedShape& a, const btHybridPlacedShape& b, btScalar gap);

bool boundsAreSeparated(const btHybridPlacedShape& a, const btHybridPlacedShape& b, btScalar gap)
{
	btVector3 minA, maxA, minB, maxB;
	a.getAabb(gap, minA, maxA);
	b.getAabb(0, minB, maxB);
	return !TestAabbAgainstAabb2(minA, maxA, minB, maxB);
}

// How far a convex shape, margin included, reaches along a world direction.
btScalar reach(const btConvexShape* shape, const btTransform& transform, const btVector3& direction)
{
	const btVector3 local = shape->localGetSupportingVertex(direction * transform.getBasis());
	return direction.dot(transform(local));
}

// GJK only proposes the plane; the supports prove it, so an inexact GJK can not call an overlap separated.
bool convexIsSeparated(const btHybridPlacedShape& a, const btHybridPlacedShape& b, btScalar gap)
{
	const btConvexShape* convexA = static_cast<const btConvexShape*>(a.m_shape);
	const btConvexShape* convexB = static_cast<const btConvexShape*>(b.m_shape);
	btVector3 guess = b.m_transform.getOrigin() - a.m_transform.getOrigin();
	if (guess.fuzzyZero())
		guess.setValue(1, 0, 0);
	btGjkEpaSolver2::sResults result;
	if (!btGjkEpaSolver2::Distance(convexA, a.m_transform, convexB, b.m_transform, guess, result))
		return false;
	btVector3 normal = result.witnesses[1] - result.witnesses[0];
	const btScalar length = normal.length();
	if (!(length > SIMD_EPSILON))
		return false;
	normal /= length;
	const btScalar distance = -reach(convexB, b.m_transform, -normal) - reach(convexA, a.m_transform, normal);
	return distance > gap;
}

bool planeIsSeparated(const btHybridPlacedShape& plane, const btHybridPlacedShape& convex, btScalar gap)
{
	const btStaticPlaneShape* shape = static_cast<const btStaticPlaneShape*>(plane.m_shape);
	const btVector3 normal = plane.m_transform.getBasis() * shape->getPlaneNormal();
	const btScalar height = shape->getPlaneConstant() + normal.dot(plane.m_transform.getOrigin());
	return -reach(static_cast<const btConvexShape*>(convex.m_shape), convex.m_transform, -normal) - height > gap;
}

/// Whether all parts of a shape are separated from another shape.
struct PartsQuery
{
	const btHybridPlacedShape& m_whole;
	const btHybridPlacedShape& m_other;
	btScalar m_gap;
	bool m_separated;

	void take(const btCollisionShape* part, const btTransform& transform)
	{
		const btHybridPlacedShape placed = {part, transform};
		m_separated = isSeparated(placed, m_other, m_gap);
	}
};

struct TriangleQuery : public PartsQuery, public btTriangleCallback
{
	explicit TriangleQuery(const PartsQuery& query) : PartsQuery(query)
	{
	}

	virtual void processTriangle(btVector3* triangle, int, int)
	{
		if (!m_separated)
			return;
		btTriangleShape shape(triangle[0], triangle[1], triangle[2]);
		shape.setMargin(m_whole.m_shape->getMargin());
		take(&shape, m_whole.m_transform);
	}
};

bool meshIsSeparated(const btHybridPlacedShape& mesh, const btHybridPlacedShape& convex, btScalar gap)
{
	btVector3 aabbMin, aabbMax;
	convex.m_shape->getAabb(mesh.m_transform.inverseTimes(convex.m_transform), aabbMin, aabbMax);
	const btScalar reachOut = gap + mesh.m_shape->getMargin();
	const btVector3 wide(reachOut, reachOut, reachOut);
	TriangleQuery query(PartsQuery{mesh, convex, gap, true});
	static_cast<const btConcaveShape*>(mesh.m_shape)->processAllTriangles(&query, aabbMin - wide, aabbMax + wide);
	return query.m_separated;
}

struct ChildQuery : public PartsQuery, public btDbvt::ICollide
{
	explicit ChildQuery(const PartsQuery& query) : PartsQuery(query)
	{
	}

	void processChild(int index)
	{
		if (!m_separated)
			return;
		const btCompoundShape* shape = static_cast<const btCompoundShape*>(m_whole.m_shape);
		take(shape->getChildShape(index), m_whole.m_transform * shape->getChildTransform(index));
	}

	virtual void Process(const btDbvtNode* leaf)
	{
		processChild(leaf->dataAsInt);
	}
};

// By the compound's tree: bounds in its frame prove gaps that bounds in the world, and GJK's plane, do not.
bool compoundIsSeparated(const btHybridPlacedShape& compound, const btHybridPlacedShape& other, btScalar gap)
{
	const btCompoundShape* shape = static_cast<const btCompoundShape*>(compound.m_shape);
	ChildQuery query(PartsQuery{compound, other, gap, true});
	const btDbvt* tree = shape->getDynamicAabbTree();
	if (!tree || !tree->m_root)
	{
		for (int i = 0; i < shape->getNumChildShapes(); i++)
			query.processChild(i);
		return query.m_separated;
	}
	btVector3 aabbMin, aabbMax;
	other.m_shape->getAabb(compound.m_transform.inverseTimes(other.m_transform), aabbMin, aabbMax);
	const btVector3 wide(gap, gap, gap);
	tree->collideTV(tree->m_root, btDbvtVolume::FromMM(aabbMin - wide, aabbMax + wide), query);
	return query.m_separated;
}

// Shapes of these types hand out triangles; a distance field and its like do not.
bool isTriangleMesh(const btCollisionShape* shape)
{
	switch (shape->getShapeType())
	{
		case TRIANGLE_MESH_SHAPE_PROXYTYPE:
		case SCALED_TRIANGLE_MESH_SHAPE_PROXYTYPE:
		case MULTIMATERIAL_TRIANGLE_MESH_PROXYTYPE:
		case TERRAIN_SHAPE_PROXYTYPE:
		case GIMPACT_SHAPE_PROXYTYPE:
			return true;
		default:
			return false;
	}
}

bool isSeparated(const btHybridPlacedShape& a, const btHybridPlacedShape& b, btScalar gap)
{
	if (a.m_shape->getShapeType() == EMPTY_SHAPE_PROXYTYPE || b.m_shape->getShapeType() == EMPTY_SHAPE_PROXYTYPE)
		return true;
	const bool planeA = a.m_shape->getShapeType() == STATIC_PLANE_PROXYTYPE;
	const bool planeB = b.m_shape->getShapeType() == STATIC_PLANE_PROXYTYPE;
	if (!planeA && !planeB && boundsAreSeparated(a, b, gap))
		return true;
	if (a.m_shape->isCompound())
		return compoundIsSeparated(a, b, gap);
	if (b.m_shape->isCompound())
		return compoundIsSeparated(b, a, gap);
	if (a.m_shape->isConvex() && b.m_shape->isConvex())
		return convexIsSeparated(a, b, gap);
	if (planeA && b.m_shape->isConvex())
		return planeIsSeparated(a, b, gap);
	if (planeB && a.m_shape->isConvex())
		return planeIsSeparated(b, a, gap);
	if (isTriangleMesh(a.m_shape) && b.m_shape->isConvex())
		return meshIsSeparated(a, b, gap);
	if (isTriangleMesh(b.m_shape) && a.m_shape->isConvex())
		return meshIsSeparated(b, a, gap);
	return false;
}

}  // namespace

bool btHybridIsSeparated(const btCollisionShape* shapeA, const btTransform& transformA, const btCollisionShape* shapeB,
                         const btTransform& transformB, btScalar gap)
{
	// A tree of bounds finds nothing near what is nowhere.
	if (!shapeA || !shapeB || !btHybridIsFinite(transformA) || !btHybridIsFinite(transformB) || !std::isfinite(gap))
		return false;
	const btHybridPlacedShape a = {shapeA, transformA};
	const btHybridPlacedShape b = {shapeB, transformB};
	return isSeparated(a, b, gap);
}
