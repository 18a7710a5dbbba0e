#include "levels/build/enclosing_hull.h"

#include <algorithm>
#include <cassert>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

#include "levels/build/edge_collapse.h"
#include "levels/build/enclosure.h"
#include "levels/build/outward_simplify.h"
#include "levels/build/place_search.h"
#include "levels/build/thick_hull.h"

namespace scatter::levels {
namespace {

/// Shares of the diagonal.
constexpr double kTolerance = 2e-4;  ///< Made up for when the hull is moved out.
constexpr double kThickness = 1e-4;
constexpr double kSymmetric = 1e-9;    ///< Rounding, when a hull is put together with its image.
constexpr double kFirstMargin = 2e-7;  ///< More than rounding to single precision takes.

constexpr double kMarginGrowth = 4.0;
constexpr int kTries = 6;

glm::dvec3 roundedToFloat(const glm::dvec3& point) {
  const Vec3 rounded(point);
  return {rounded.x, rounded.y, rounded.z};
}

/// Of corners that were found one by one, those before the plane and their images; where there are none
/// before it, images of those behind.
std::vector<glm::dvec3> madeSymmetric(const TriangleHull& hull, const std::vector<glm::dvec3>& corners,
                                      const Mirror& mirror) {
  std::vector<glm::dvec3> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3& from = hull.vertices[i];
    const bool isBehind = from[mirror.axis] < 0.0;
    const auto& all = hull.vertices;
    if (isBehind && std::find(all.begin(), all.end(), mirror(from)) != all.end()) continue;
    kept.push_back(from[mirror.axis] == 0.0 ? mirror.flattened(corners[i]) : corners[i]);
  }
  return withImages(kept, mirror);
}

/// Adds the images that are missing.
std::vector<glm::dvec3> completed(std::vector<glm::dvec3> corners, const Mirror& mirror) {
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 image = mirror(corners[i]);
    if (std::find(corners.begin(), corners.end(), image) == corners.end()) corners.push_back(image);
  }
  return corners;
}

/// The hull's vertices moved out the shortest way that lets its planes hold the points with the margin to
/// spare; nothing if the hull is too sharp for that.
std::optional<std::vector<glm::dvec3>> movedOut(const TriangleHull& hull, std::span<const glm::dvec3> points,
                                                double margin, const std::optional<Mirror>& mirror) {
  std::vector<std::vector<HalfSpace>> demands(hull.vertices.size());
  for (std::size_t i = 0; i < hull.triangles.size(); ++i) {
    const glm::dvec3& normal = hull.planes[i].normal;
    const double distance = std::max(0.0, reach(points, normal) - hull.planes[i].offset) + margin;
    for (const std::uint32_t vertex : hull.triangles[i]) demands[vertex].push_back({normal, distance});
  }
  std::vector<glm::dvec3> result;
  result.reserve(hull.vertices.size());
  for (std::size_t i = 0; i < hull.vertices.size(); ++i) {
    const Places steps = findPlaces(demands[i], glm::dvec3(0.0), glm::dvec3(0.0), 1e-3 * margin);
    if (!steps.nearest) return std::nullopt;
    result.push_back(roundedToFloat(hull.vertices[i] + *steps.nearest));
  }
  if (mirror) result = madeSymmetric(hull, result, *mirror);
  return result;
}

/// The hull scaled about its middle so that its planes hold the points with the margin to spare.
std::vector<glm::dvec3> scaledUp(const TriangleHull& hull, std::span<const glm::dvec3> points, double margin,
                                 const std::optional<Mirror>& mirror) {
  const glm::dvec3 center = mirror ? mirror->flattened(centerOf(hull)) : centerOf(hull);
  double scale = 1.0;
  for (const HalfSpace& plane : hull.planes) {
    const double own = plane.offset - glm::dot(plane.normal, center);
    const double needed = reach(points, plane.normal) + margin - glm::dot(plane.normal, center);
    if (own > 0.0) scale = std::max(scale, needed / own);
  }
  std::vector<glm::dvec3> result;
  result.reserve(hull.vertices.size());
  for (const glm::dvec3& vertex : hull.vertices) {
    result.push_back(roundedToFloat(center + scale * (vertex - center)));
  }
  if (mirror) result = madeSymmetric(hull, result, *mirror);
  return result;
}

/// The axis-aligned box around the points: what is left when rounding defeats everything else.
std::vector<glm::dvec3> boxAround(std::span<const glm::dvec3> points, double margin) {
  DoubleBounds bounds;
  for (const glm::dvec3& point : points) bounds.add(point);
  std::vector<glm::dvec3> corners;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const glm::dvec3 choice{(corner & 1U) != 0 ? 1.0 : 0.0, (corner & 2U) != 0 ? 1.0 : 0.0,
                            (corner & 4U) != 0 ? 1.0 : 0.0};
    corners.push_back(
        roundedToFloat(bounds.min - margin + choice * (bounds.max - bounds.min + glm::dvec3(2.0 * margin))));
  }
  return corners;
}

}  // namespace

TriangleHull encloseInHull(HullBuilder& builder, std::span<const glm::dvec3> points,
                           const EnclosingHullDef& definition) {
  const double diagonal = definition.diagonal;
  const HullDef exact{kTolerance * diagonal, kThickness * diagonal, definition.maxVertices};
  TriangleHull hull;
  buildThickHull(builder, points, exact, hull);
  if (definition.mirror) {
    const double epsilon = kSymmetric * diagonal;
    builder.build(withImages(hull.vertices, *definition.mirror, kOnPlane * diagonal),
                  {epsilon, epsilon, exact.budget}, hull);
  }
  const auto most = static_cast<std::size_t>(definition.maxVertices);

  TriangleHull result;
  const auto isProven = [&](const std::vector<glm::dvec3>& corners) {
    if (!builder.build(corners, {}, result)) return false;
    // Of corners within rounding of a face, one may be left out where its image is not.
    if (definition.mirror) result.vertices = completed(result.vertices, *definition.mirror);
    return result.vertices.size() <= most && provesInside(result, points);
  };
  const std::optional<TriangleHull> simple =
      simplifyOutward(builder, hull, {definition.maxVertices, definition.mirror});
  if (simple) {
    double margin = kFirstMargin * diagonal;
    for (int i = 0; i < kTries; ++i, margin *= kMarginGrowth) {
      const std::optional<std::vector<glm::dvec3>> corners =
          movedOut(*simple, points, margin, definition.mirror);
      if ((corners && isProven(*corners)) || isProven(scaledUp(*simple, points, margin, definition.mirror)))
        return result;
    }
  }
  std::vector<glm::dvec3> box = boxAround(points, kThickness * diagonal);
  if (definition.mirror) box = withImages(box, *definition.mirror);
  const bool isBuilt = builder.build(box, {}, result);
  assert(isBuilt && provesInside(result, points));
  static_cast<void>(isBuilt);
  return result;
}

}  // namespace scatter::levels
