#include "btHybridGround.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btConcaveShape.h>
#include <BulletCollision/CollisionShapes/btPolyhedralConvexShape.h>
#include <BulletCollision/CollisionShapes/btScaledBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <BulletCollision/CollisionShapes/btStridingMeshInterface.h>
#include <BulletCollision/CollisionShapes/btTriangleMeshShape.h>

#include <limits>

#include "btHybridConversions.h"
#include "btHybridHull.h"

using scatter::levels::Polytope;

namespace
{
// Half the diagonal of a convex shape against the radius of a body, from which on clipping it pays. A box of twice the
// body's size has no digits to lose, and is clipped anew all the time.
const btScalar c_large = 4;

// Of a size: what counts as nothing, a digit or two above the rounding of single precision.
const double c_flat = 1e-6;

// Of a body's radius: how long a mesh may be that is known as a whole. Bowls and furniture beside bodies of their size
// are, terrains are not. With 0, 4, 8, 16 radii `scatter run` in `lean` of rooms-1 to 10 and 21 to 25 (`scatter
// families --scale 0.5`) takes 340, 307, 310, 311 microseconds a step, of as many of bowl 699, 706, 699, 698.
const btScalar c_small = 8;

// To look these up takes less than half a millisecond, in one step.
const size_t c_mostOfSmall = 2048;

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
		const scatter::Vec3 corners[3] = {btHybridVec3(triangle[0]), btHybridVec3(triangle[1]),
		                                  btHybridVec3(triangle[2])};
		m_pieces.add(part, index, corners);
	}
};

btScalar halfDiagonal(const btCollisionShape* shape)
{
	btVector3 aabbMin, aabbMax;
	shape->getAabb(btTransform::getIdentity(), aabbMin, aabbMax);
	return btScalar(0.5) * (aabbMax - aabbMin).length();
}

// 0: it does not tell.
size_t countTriangles(const btCollisionShape* shape)
{
	if (shape->getShapeType() == SCALED_TRIANGLE_MESH_SHAPE_PROXYTYPE)
		shape = const_cast<btScaledBvhTriangleMeshShape*>(static_cast<const btScaledBvhTriangleMeshShape*>(shape))
		            ->getChildShape();
	if (shape->getShapeType() != TRIANGLE_MESH_SHAPE_PROXYTYPE &&
	    shape->getShapeType() != MULTIMATERIAL_TRIANGLE_MESH_PROXYTYPE)
		return 0;
	const btStridingMeshInterface* mesh = static_cast<const btTriangleMeshShape*>(shape)->getMeshInterface();
	size_t count = 0;
	for (int part = 0; part < mesh->getNumSubParts(); part++)
	{
		const unsigned char *vertices, *indices;
		int numVertices, vertexStride, indexStride, numTriangles;
		PHY_ScalarType vertexType, indexType;
		mesh->getLockedReadOnlyVertexIndexBase(&vertices, numVertices, vertexType, vertexStride, &indices, indexStride,
		                                       numTriangles, indexType, part);
		mesh->unLockReadOnlyVertexBase(part);
		count += size_t(numTriangles);
	}
	return count;
}

btVector3 corner(int number, const btVector3& low, const btVector3& high)
{
	return btVector3((number & 1) ? high.x() : low.x(), (number & 2) ? high.y() : low.y(),
	                 (number & 4) ? high.z() : low.z());
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
		case CONVEX_TRIANGLEMESH_SHAPE_PROXYTYPE:
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
	return static_cast<const btPolyhedralConvexShape*>(shape)->getConvexPolyhedron() ? BT_HYBRID_NO_GROUND
	                                                                                 : BT_HYBRID_LARGE_HULL;
}

btHybridGroundTraits::btHybridGroundTraits(const btCollisionShape* shape, btHybridGroundKind kind)
    : m_shape(shape),
      m_kind(kind),
      m_scaling(shape->getLocalScaling()),
      m_min(0, 0, 0),
      m_max(0, 0, 0),
      m_margin(shape->getMargin())
{
	if (kind != BT_HYBRID_HALF_SPACE)
		shape->getAabb(btTransform::getIdentity(), m_min, m_max);
}

void btHybridGround::follow(const btCollisionShape* shape, btScalar radius)
{
	const btHybridGroundTraits traits(shape, kindOf(shape, radius));
	if (traits == m_traits)
		return;
	m_traits = traits;
	m_numTriangles = countTriangles(shape);
	m_core.reset();
	m_version++;
}

btScalar btHybridGround::getReach(const btVector3& direction) const
{
	return direction.dot(
	    static_cast<const btConvexShape*>(m_traits.m_shape)->localGetSupportVertexWithoutMarginNonVirtual(direction));
}

bool btHybridGround::isSmall(btScalar radius) const
{
	const btVector3 size = m_traits.m_max - m_traits.m_min;
	return m_numTriangles > 0 && m_numTriangles <= c_mostOfSmall && size[size.maxAxis()] <= c_small * radius;
}

void btHybridGround::collectAll(scatter::pairs::GroundPieces& pieces) const
{
	pieces.margin = m_traits.m_margin;
	collectTriangles(m_traits.m_min, m_traits.m_max, pieces);
}

bool btHybridGround::collect(const btVector3& low, const btVector3& high, scatter::pairs::GroundPieces& pieces)
{
	pieces.margin = m_traits.m_margin;
	if (m_traits.m_kind == BT_HYBRID_TRIANGLES)
		return collectTriangles(low, high, pieces);
	if (m_traits.m_kind == BT_HYBRID_LARGE_BOX)
		collectBox(low, high, pieces);
	else
		collectHull(low, high, pieces);
	return true;
}

bool btHybridGround::collectTriangles(const btVector3& low, const btVector3& high,
                                      scatter::pairs::GroundPieces& pieces) const
{
	pieces.kind = scatter::PartKind::kTriangle;
	Collector collector(pieces, low, high);
	static_cast<const btConcaveShape*>(m_traits.m_shape)->processAllTriangles(&collector, low, high);
	return pieces.pieces.size() <= c_mostPieces;
}

void btHybridGround::collectBox(const btVector3& low, const btVector3& high, scatter::pairs::GroundPieces& pieces) const
{
	pieces.kind = scatter::PartKind::kBox;
	const btVector3 core = static_cast<const btBoxShape*>(m_traits.m_shape)->getHalfExtentsWithoutMargin();
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

const Polytope& btHybridGround::getCore()
{
	if (m_core)
		return *m_core;
	std::vector<glm::dvec3> points;
	for (const btVector3& point : btHybridHullPoints(m_traits.m_shape))
		points.push_back(glm::dvec3(btHybridVec3(point)));
	double moved;
	m_core = btHybridHullOf(points, &moved);
	// Sides that leave points out, or are not flat, would clip off what is there.
	if (moved > c_flat * double((m_traits.m_max - m_traits.m_min).length()))
		m_core = Polytope();
	return *m_core;
}

void btHybridGround::collectHull(const btVector3& low, const btVector3& high, scatter::pairs::GroundPieces& pieces)
{
	pieces.kind = scatter::PartKind::kHull;
	std::vector<scatter::Vec3> corners;
	if (getCore().isEmpty())
	{
		for (const btVector3& point : btHybridHullPoints(m_traits.m_shape))
			corners.push_back(btHybridVec3(point));
		if (!corners.empty())
			pieces.add(-1, -1, corners);
		return;
	}
	Polytope near = getCore();
	const double epsilon = c_flat * double((high - low).length());
	for (int side = 0; side < 6 && !near.isEmpty(); side++)
	{
		glm::dvec3 normal(0.0);
		normal[side / 2] = side % 2 == 0 ? 1 : -1;
		near = near.clipped({normal, side % 2 == 0 ? double(high[side / 2]) : -double(low[side / 2])}, epsilon);
	}
	if (near.isEmpty())
		return;
	for (const glm::dvec3& vertex : near.vertices())
		corners.push_back(scatter::Vec3(vertex));
	pieces.add(-1, -1, corners);
}
