#include "btHybridHull.h"

#include <LinearMath/btConvexHullComputer.h>

#include <algorithm>
#include <limits>

using scatter::levels::HalfSpace;
using scatter::levels::Polytope;

namespace
{
// Point sets no thicker than this share of their extent have no volume.
const double c_flatness = 1e-6;

/// A face of a hull, and how far it had to be moved out.
struct OuterPlane
{
	HalfSpace m_plane;
	double m_moved;
	bool m_isFlat;  ///< all points lie in it, or it has no area
};

// `extent`: the furthest point from the middle.
OuterPlane planeOf(const std::vector<glm::dvec3>& points, const std::vector<glm::dvec3>& loop, const glm::dvec3& middle, double extent)
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
	outer.m_isFlat = high - low <= c_flatness * extent;
	return outer;
}
}  // namespace

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
		for (const btConvexHullComputer::Edge* edge = first; edge != first || loop.empty(); edge = edge->getNextEdgeOfFace())
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
