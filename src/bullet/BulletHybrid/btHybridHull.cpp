#include "btHybridHull.h"

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btConvexTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btStridingMeshInterface.h>
#include <LinearMath/btConvexHullComputer.h>

#include <algorithm>
#include <array>
#include <limits>

using scatter::levels::HalfSpace;
using scatter::levels::Polytope;

namespace
{
// Point sets no thicker than this share of their extent have no volume.
const double c_noVolume = 1e-6;

/// A face of a hull, and how far it had to be moved out.
struct OuterPlane
{
	HalfSpace m_plane;
	double m_moved;
	bool m_isFlat;  ///< all points lie in it, or it has no area
};

// `extent`: the furthest point from the middle.
OuterPlane planeOf(const std::vector<glm::dvec3>& points, const std::vector<glm::dvec3>& loop, const glm::dvec3& middle,
                   double extent)
{
	OuterPlane outer = {HalfSpace(), 0, true};
	glm::dvec3 normal(0.0);
	for (size_t i = 1; i + 1 < loop.size(); i++)
		normal += glm::cross(loop[i] - loop[0], loop[i + 1] - loop[0]);
	const double area = glm::length(normal);
	if (!(area > 0))
		return outer;
	outer.m_plane.normal = normal / (glm::dot(normal, loop[0] - middle) < 0 ? -area : area);
	double high = -std::numeric_limits<double>::infinity();
	double low = std::numeric_limits<double>::infinity();
	for (size_t i = 0; i < points.size(); i++)
	{
		high = std::max(high, glm::dot(outer.m_plane.normal, points[i]));
		low = std::min(low, glm::dot(outer.m_plane.normal, points[i]));
	}
	double lowest = high;
	for (size_t i = 0; i < loop.size(); i++)
		lowest = std::min(lowest, glm::dot(outer.m_plane.normal, loop[i]));
	outer.m_plane.offset = high;
	outer.m_moved = high - lowest;
	outer.m_isFlat = high - low <= c_noVolume * extent;
	return outer;
}

/// Takes the corners of all triangles.
struct Corners : public btInternalTriangleIndexCallback
{
	std::vector<btVector3> m_points;

	virtual void internalProcessTriangleIndex(btVector3* triangle, int, int)
	{
		m_points.insert(m_points.end(), triangle, triangle + 3);
	}

	// Each once, in an order that is the same everywhere.
	void unite()
	{
		const auto components = [](const btVector3& v) { return std::array<btScalar, 3>{v.x(), v.y(), v.z()}; };
		std::sort(m_points.begin(), m_points.end(),
		          [&](const btVector3& a, const btVector3& b) { return components(a) < components(b); });
		m_points.erase(
		    std::unique(m_points.begin(), m_points.end(),
		                [&](const btVector3& a, const btVector3& b) { return components(a) == components(b); }),
		    m_points.end());
	}
};
}  // namespace

std::vector<btVector3> btHybridHullPoints(const btCollisionShape* shape)
{
	Corners corners;
	if (!shape->isPolyhedral() || static_cast<const btPolyhedralConvexShape*>(shape)->getConvexPolyhedron())
		return corners.m_points;
	if (shape->getShapeType() == CONVEX_HULL_SHAPE_PROXYTYPE)
	{
		const btConvexHullShape* hull = static_cast<const btConvexHullShape*>(shape);
		for (int i = 0; i < hull->getNumPoints(); i++)
			corners.m_points.push_back(hull->getScaledPoint(i));
	}
	if (shape->getShapeType() == CONVEX_TRIANGLEMESH_SHAPE_PROXYTYPE)
	{
		const btVector3 all(BT_LARGE_FLOAT, BT_LARGE_FLOAT, BT_LARGE_FLOAT);
		static_cast<const btConvexTriangleMeshShape*>(shape)->getMeshInterface()->InternalProcessAllTriangles(
		    &corners, -all, all);
		corners.unite();
	}
	return corners.m_points;
}

Polytope btHybridHullOf(const std::vector<glm::dvec3>& points, double* moved)
{
	if (moved)
		*moved = 0;
	Polytope result;
	if (points.size() < 4)
		return result;
	btConvexHullComputer computer;
	computer.compute(&points[0].x, int(sizeof(glm::dvec3)), int(points.size()), 0, 0);
	std::vector<glm::dvec3> corners;
	glm::dvec3 middle(0.0);
	for (int i = 0; i < computer.original_vertex_index.size(); i++)
	{
		corners.push_back(points[computer.original_vertex_index[i]]);
		middle += corners.back() / double(computer.original_vertex_index.size());
		result.addVertex(corners.back());
	}
	double extent = 0;
	for (size_t i = 0; i < points.size(); i++)
		extent = std::max(extent, glm::length(points[i] - middle));
	for (int i = 0; i < computer.faces.size(); i++)
	{
		std::vector<std::uint32_t> members;
		std::vector<glm::dvec3> loop;
		const btConvexHullComputer::Edge* const first = &computer.edges[computer.faces[i]];
		for (const btConvexHullComputer::Edge* edge = first; edge != first || loop.empty();
		     edge = edge->getNextEdgeOfFace())
		{
			members.push_back(static_cast<std::uint32_t>(edge->getSourceVertex()));
			loop.push_back(corners[members.back()]);
		}
		const OuterPlane outer = planeOf(points, loop, middle, extent);
		if (outer.m_isFlat)
			continue;
		if (moved)
			*moved = std::max(*moved, outer.m_moved);
		result.addFace(outer.m_plane, members);
	}
	return result.isEmpty() ? Polytope() : result;
}
