#include "btHybridGround.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btConcaveShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <LinearMath/btConvexHullComputer.h>

#include <limits>

#include "btHybridConversions.h"

namespace
{
// Half the diagonal of a convex shape against the radius of a body, from which on clipping it pays. A box of twice the body's size has
// no digits to lose, and is clipped anew all the time.
const btScalar c_large = 4;

const size_t c_mostPieces = std::numeric_limits<unsigned short>::max() - 1;

/// Takes the triangles that reach into a box.
struct Collector : public btTriangleCallback
{
	scatter::pairs::GroundPieces& m_pieces;
	btVector3 m_low;
	btVector3 m_high;

	Collector(scatter::pairs::GroundPieces& pieces, const btVector3& low, const btVector3& high)
	    : m_pieces(pieces), m_low(low), m_high(high)
	{
	}
	virtual void processTriangle(btVector3* triangle, int part, int index)
	{
		btVector3 least = triangle[0], most = triangle[0];
		for (int i = 1; i < 3; i++)
		{
			least.setMin(triangle[i]);
			most.setMax(triangle[i]);
		}
		for (int axis = 0; axis < 3; axis++)
			if (least[axis] > m_high[axis] || most[axis] < m_low[axis])
				return;
		const scatter::Vec3 corners[3] = {btHybridVec3(triangle[0]), btHybridVec3(triangle[1]), btHybridVec3(triangle[2])};
		m_pieces.add(part, index, corners);
	}
};

btScalar halfDiagonal(const btCollisionShape* shape)
{
	btVector3 aabbMin, aabbMax;
	shape->getAabb(btTransform::getIdentity(), aabbMin, aabbMax);
	return btScalar(0.5) * (aabbMax - aabbMin).length();
}

// What of a polygon is on the side of an axis' plane that is not `sign`.
void clip(std::vector<btVector3>& polygon, std::vector<btVector3>& memory, int axis, btScalar sign, btScalar bound)
{
	memory.clear();
	for (size_t i = 0; i < polygon.size(); i++)
	{
		const btVector3& from = polygon[i];
		const btVector3& to = polygon[(i + 1) % polygon.size()];
		const btScalar outFrom = sign * (from[axis] - bound);
		const btScalar outTo = sign * (to[axis] - bound);
		if (outFrom <= 0)
			memory.push_back(from);
		if ((outFrom < 0 && outTo > 0) || (outFrom > 0 && outTo < 0))
			memory.push_back(from + (to - from) * (outFrom / (outFrom - outTo)));
	}
	polygon.swap(memory);
}

btVector3 corner(int number, const btVector3& low, const btVector3& high)
{
	return btVector3((number & 1) ? high.x() : low.x(), (number & 2) ? high.y() : low.y(), (number & 4) ? high.z() : low.z());
}
}  // namespace

bool btHybridGround::maybe(int shapeType)
{
	switch (shapeType)
	{
		case STATIC_PLANE_PROXYTYPE:
		case TRIANGLE_MESH_SHAPE_PROXYTYPE:
		case SCALED_TRIANGLE_MESH_SHAPE_PROXYTYPE:
		case MULTIMATERIAL_TRIANGLE_MESH_PROXYTYPE:
		case TERRAIN_SHAPE_PROXYTYPE:
		case BOX_SHAPE_PROXYTYPE:
		case CONVEX_HULL_SHAPE_PROXYTYPE:
			return true;
		default:
			return false;
	}
}

btHybridGroundKind btHybridGround::kindOf(const btCollisionShape* shape, btScalar radius)
{
	if (!maybe(shape->getShapeType()))
		return BT_HYBRID_NO_GROUND;
	if (shape->getShapeType() == STATIC_PLANE_PROXYTYPE)
		return BT_HYBRID_HALF_SPACE;
	if (shape->isConcave())
		return BT_HYBRID_TRIANGLES;
	if (!(halfDiagonal(shape) > c_large * radius))
		return BT_HYBRID_NO_GROUND;
	if (shape->getShapeType() == BOX_SHAPE_PROXYTYPE)
	{
		const btVector3 core = static_cast<const btBoxShape*>(shape)->getHalfExtentsWithoutMargin();
		return core[core.minAxis()] > 0 ? BT_HYBRID_LARGE_BOX : BT_HYBRID_NO_GROUND;
	}
	// Hulls whose polyhedral features are there have contacts of their own kind in Bullet.
	const btConvexHullShape* hull = static_cast<const btConvexHullShape*>(shape);
	return hull->getNumPoints() > 3 && !hull->getConvexPolyhedron() ? BT_HYBRID_LARGE_HULL : BT_HYBRID_NO_GROUND;
}

bool btHybridGround::isCurrent(const btCollisionShape* shape, btHybridGroundKind kind) const
{
	if (shape != m_shape || kind != m_kind || shape->getMargin() != m_margin || !(shape->getLocalScaling() == m_scaling))
		return false;
	if (kind == BT_HYBRID_HALF_SPACE)
		return true;
	btVector3 aabbMin, aabbMax;
	shape->getAabb(btTransform::getIdentity(), aabbMin, aabbMax);
	return aabbMin == m_min && aabbMax == m_max;
}

void btHybridGround::follow(const btCollisionShape* shape, btScalar radius)
{
	const btHybridGroundKind kind = kindOf(shape, radius);
	if (isCurrent(shape, kind))
		return;
	m_shape = shape;
	m_kind = kind;
	m_scaling = shape->getLocalScaling();
	m_margin = shape->getMargin();
	shape->getAabb(btTransform::getIdentity(), m_min, m_max);
	m_faces.clear();
	m_version++;
}

bool btHybridGround::collect(const btVector3& low, const btVector3& high, scatter::pairs::GroundPieces& pieces)
{
	pieces.margin = m_margin;
	if (m_kind == BT_HYBRID_TRIANGLES)
		return collectTriangles(low, high, pieces);
	if (m_kind == BT_HYBRID_LARGE_BOX)
		collectBox(low, high, pieces);
	else
		collectHull(low, high, pieces);
	return true;
}

bool btHybridGround::collectTriangles(const btVector3& low, const btVector3& high, scatter::pairs::GroundPieces& pieces) const
{
	pieces.kind = scatter::PartKind::kTriangle;
	Collector collector(pieces, low, high);
	static_cast<const btConcaveShape*>(m_shape)->processAllTriangles(&collector, low, high);
	return pieces.pieces.size() <= c_mostPieces;
}

void btHybridGround::collectBox(const btVector3& low, const btVector3& high, scatter::pairs::GroundPieces& pieces) const
{
	pieces.kind = scatter::PartKind::kBox;
	const btVector3 core = static_cast<const btBoxShape*>(m_shape)->getHalfExtentsWithoutMargin();
	btVector3 from = low, to = high;
	from.setMax(-core);
	to.setMin(core);
	for (int axis = 0; axis < 3; axis++)
		if (from[axis] > to[axis])
			return;
	scatter::Vec3 corners[8];
	for (int i = 0; i < 8; i++)
		corners[i] = btHybridVec3(corner(i, from, to));
	pieces.add(-1, -1, corners);
}

void btHybridGround::findFaces()
{
	const btConvexHullShape* hull = static_cast<const btConvexHullShape*>(m_shape);
	std::vector<btVector3> points;
	for (int i = 0; i < hull->getNumPoints(); i++)
		points.push_back(hull->getScaledPoint(i));
	btConvexHullComputer computer;
	computer.compute(&points[0].x(), sizeof(btVector3), int(points.size()), 0, 0);
	for (int i = 0; i < computer.faces.size(); i++)
	{
		Face face;
		const btConvexHullComputer::Edge* first = &computer.edges[computer.faces[i]];
		const btConvexHullComputer::Edge* edge = first;
		do
		{
			face.m_corners.push_back(computer.vertices[edge->getSourceVertex()]);
			edge = edge->getNextEdgeOfFace();
		} while (edge != first);
		const std::vector<btVector3>& c = face.m_corners;
		face.m_normal = (c[1] - c[0]).cross(c[2] - c[0]);
		if (!(face.m_normal.length2() > 0))
			continue;
		face.m_normal.normalize();
		face.m_offset = face.m_normal.dot(c[0]);
		m_faces.push_back(face);
	}
	// Outwards, whichever way the sides run.
	const btVector3 center = btScalar(0.5) * (m_min + m_max);
	for (size_t i = 0; i < m_faces.size(); i++)
	{
		if (m_faces[i].m_normal.dot(center) <= m_faces[i].m_offset)
			continue;
		m_faces[i].m_normal = -m_faces[i].m_normal;
		m_faces[i].m_offset = -m_faces[i].m_offset;
	}
}

bool btHybridGround::isInside(const btVector3& point) const
{
	for (size_t i = 0; i < m_faces.size(); i++)
		if (m_faces[i].m_normal.dot(point) > m_faces[i].m_offset)
			return false;
	return true;
}

// The corners of what is in the box: of the hull's sides, clipped, and those of the box that are in the hull.
void btHybridGround::collectHull(const btVector3& low, const btVector3& high, scatter::pairs::GroundPieces& pieces)
{
	pieces.kind = scatter::PartKind::kHull;
	if (m_faces.empty())
		findFaces();
	std::vector<scatter::Vec3> corners;
	std::vector<btVector3> polygon, memory;
	for (size_t i = 0; i < m_faces.size(); i++)
	{
		polygon = m_faces[i].m_corners;
		for (int axis = 0; axis < 3 && !polygon.empty(); axis++)
		{
			clip(polygon, memory, axis, -1, low[axis]);
			clip(polygon, memory, axis, 1, high[axis]);
		}
		for (size_t k = 0; k < polygon.size(); k++)
			corners.push_back(btHybridVec3(polygon[k]));
	}
	for (int i = 0; i < 8; i++)
		if (isInside(corner(i, low, high)))
			corners.push_back(btHybridVec3(corner(i, low, high)));
	if (!corners.empty())
		pieces.add(-1, -1, corners);
}
