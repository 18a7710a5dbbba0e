#include "levels/build/outward_simplify.h"

#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>
#include <utility>

#include "levels/build/edge_collapse.h"
#include "levels/build/face_axes.h"
#include "levels/polytope.h"

namespace scatter::levels {
namespace {

/// Planes are added up to this many times the vertices that may remain: collapsing edges is slower, but
/// chooses better.
constexpr std::size_t kStartFactor = 6;

/// Shares of the hull's diagonal.
constexpr double kPlaneEpsilon = 1e-10;
constexpr double kLeastCut = 1e-5;

/// The box around the hull along the directions that most of it faces, or along those of its symmetry.
Polytope boxAround(const TriangleHull& hull, bool isSymmetric) {
  const glm::dmat3 axes = isSymmetric ? glm::dmat3(1.0) : faceAxes(hull);
  glm::dvec3 center{0.0};
  glm::dvec3 half{0.0};
  for (int axis = 0; axis < 3; ++axis) {
    const double high = reach(hull.vertices, axes[axis]);
    const double low = -reach(hull.vertices, -axes[axis]);
    center += 0.5 * (high + low) * axes[axis];
    half[axis] = 0.5 * (high - low);
  }
  return Polytope::box(center, axes, half);
}

/// Cuts a box around the hull by the hull's own planes, each time the one beyond which a corner is
/// furthest, while it has at most `limit` vertices.
Polytope cutToFit(const TriangleHull& hull, std::size_t limit, double diagonal,
                  const std::optional<Mirror>& mirror) {
  Polytope result = boxAround(hull, mirror.has_value());
  std::vector<bool> isUsed(hull.planes.size(), false);
  for (std::size_t round = 0; round < hull.planes.size(); ++round) {
    double deepest = kLeastCut * diagonal;
    std::size_t best = hull.planes.size();
    for (std::size_t i = 0; i < hull.planes.size(); ++i) {
      if (isUsed[i]) continue;
      for (const glm::dvec3& corner : result.vertices()) {
        const double depth = hull.planes[i].signedDistance(corner);
        if (depth > deepest) {
          deepest = depth;
          best = i;
        }
      }
    }
    if (best == hull.planes.size()) break;
    isUsed[best] = true;
    // Facets of a nearly flat patch are only flat to within rounding: hold all vertices.
    const glm::dvec3& normal = hull.planes[best].normal;
    Polytope cut = result.clipped({normal, reach(hull.vertices, normal)}, kPlaneEpsilon * diagonal);
    if (mirror) {
      const glm::dvec3 image = (*mirror)(normal);
      cut = cut.clipped({image, reach(hull.vertices, image)}, kPlaneEpsilon * diagonal);
    }
    if (cut.isEmpty()) continue;
    if (cut.vertices().size() > limit) break;
    result = std::move(cut);
  }
  return result;
}

}  // namespace

std::optional<TriangleHull> simplifyOutward(HullBuilder& builder, const TriangleHull& hull,
                                            const SimplifyDef& definition) {
  const auto most = static_cast<std::size_t>(definition.maxVertices);
  if (hull.vertices.size() <= most && !definition.mirror) return hull;
  const double diagonal = glm::length(hull.bounds.max - hull.bounds.min);
  const std::size_t start = kStartFactor * most;
  TriangleHull current = hull;
  if (hull.vertices.size() > start) {
    const Polytope cut = cutToFit(hull, start, diagonal, definition.mirror);
    const double epsilon = 1e-9 * diagonal;
    std::vector<glm::dvec3> corners = cut.vertices();
    if (definition.mirror) corners = withImages(corners, *definition.mirror, kOnPlane * diagonal);
    if (!builder.build(corners, {epsilon, epsilon, definition.maxVertices}, current)) return std::nullopt;
  }
  if (!collapseEdges(builder, hull, {most, definition.mirror}, current)) return std::nullopt;
  return current;
}

}  // namespace scatter::levels
