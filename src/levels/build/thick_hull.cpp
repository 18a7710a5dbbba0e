#include "levels/build/thick_hull.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <vector>

#include "levels/build/face_axes.h"

namespace scatter::levels {
namespace {

/// Axes along the greatest extents of the points, found greedily, and those extents.
struct Extents {
  glm::dmat3 axes{1.0};
  glm::dvec3 size{0.0};
};

Extents extentsOf(std::span<const glm::dvec3> points) {
  Extents extents;
  const auto farthestFrom = [&](const auto& offsetOf) {
    glm::dvec3 best{0.0};
    for (const glm::dvec3& point : points) {
      const glm::dvec3 offset = offsetOf(point);
      if (glm::dot(offset, offset) > glm::dot(best, best)) best = offset;
    }
    return best;
  };
  const glm::dvec3 start =
      points.front() + farthestFrom([&](const glm::dvec3& p) { return p - points.front(); });
  const glm::dvec3 longest = farthestFrom([&](const glm::dvec3& p) { return p - start; });
  extents.size[0] = glm::length(longest);
  extents.axes[0] = extents.size[0] > 0.0 ? longest / extents.size[0] : glm::dvec3(1.0, 0.0, 0.0);
  const glm::dvec3 widest = farthestFrom([&](const glm::dvec3& p) {
    return p - start - extents.axes[0] * glm::dot(extents.axes[0], p - start);
  });
  extents.size[1] = glm::length(widest);
  // The direction of a width that is mere rounding means nothing.
  const bool hasWidth = extents.size[1] > 1e-9 * extents.size[0];
  extents.axes[1] = hasWidth ? widest / extents.size[1] : anyAcross(extents.axes[0]);
  extents.axes[1] -= extents.axes[0] * glm::dot(extents.axes[0], extents.axes[1]);
  extents.axes[1] = glm::normalize(extents.axes[1]);
  extents.axes[2] = glm::cross(extents.axes[0], extents.axes[1]);
  extents.size[2] = reach(points, extents.axes[2]) + reach(points, -extents.axes[2]);
  return extents;
}

/// The points moved both ways along each axis, as far as is given for it.
std::vector<glm::dvec3> movedBothWays(std::span<const glm::dvec3> points, const Extents& extents,
                                      const glm::dvec3& ways) {
  std::vector<glm::dvec3> result(points.begin(), points.end());
  for (int axis = 0; axis < 3; ++axis) {
    if (!(ways[axis] > 0.0)) continue;
    const glm::dvec3 step = ways[axis] * extents.axes[axis];
    const std::size_t count = result.size();
    for (std::size_t i = 0; i < count; ++i) {
      result.push_back(result[i] + step);
      result[i] -= step;
    }
  }
  return result;
}

/// Along every axis that lacks extent, by all of the thickness.
std::vector<glm::dvec3> thickened(std::span<const glm::dvec3> points, const Extents& extents,
                                  double thickness) {
  glm::dvec3 ways{0.0};
  for (int axis = 0; axis < 3; ++axis) {
    if (extents.size[axis] < thickness) ways[axis] = 0.5 * thickness;
  }
  return movedBothWays(points, extents, ways);
}

/// The box around the points along the axes of their extents.
std::vector<glm::dvec3> boxAround(std::span<const glm::dvec3> points, const Extents& extents,
                                  double thickness) {
  glm::dvec3 low{0.0};
  glm::dvec3 high{0.0};
  for (int axis = 0; axis < 3; ++axis) {
    high[axis] = reach(points, extents.axes[axis]);
    low[axis] = -reach(points, -extents.axes[axis]);
    const double lack = std::max(0.0, thickness - (high[axis] - low[axis]));
    high[axis] += 0.5 * lack;
    low[axis] -= 0.5 * lack;
  }
  std::vector<glm::dvec3> corners;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const glm::dvec3 local{(corner & 1U) != 0 ? high.x : low.x, (corner & 2U) != 0 ? high.y : low.y,
                           (corner & 4U) != 0 ? high.z : low.z};
    corners.push_back(extents.axes * local);
  }
  return corners;
}

}  // namespace

std::vector<glm::dvec3> thickenedTo(std::span<const glm::dvec3> points, double thickness) {
  const Extents extents = extentsOf(points);
  std::vector<glm::dvec3> result = movedBothWays(points, extents, 0.5 * (thickness - extents.size));
  // Rounding must not leave the points themselves outside of what is around them.
  result.insert(result.end(), points.begin(), points.end());
  return result;
}

bool buildThickHull(HullBuilder& builder, std::span<const glm::dvec3> points, const HullDef& definition,
                    TriangleHull& result) {
  if (builder.build(points, definition, result)) return false;
  const Extents extents = extentsOf(points);
  HullDef thin = definition;
  thin.tolerance = std::min(definition.tolerance, 0.01 * definition.thickness);
  thin.thickness = 0.25 * definition.thickness;
  if (builder.build(thickened(points, extents, definition.thickness), thin, result)) return true;
  builder.build(boxAround(points, extents, definition.thickness), thin, result);
  return true;
}

}  // namespace scatter::levels
