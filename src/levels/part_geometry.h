#pragma once

#include <scatter/levels/convex_part.h>
#include <scatter/result.h>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "levels/polytope.h"

namespace scatter::levels {

/// Lengths are floats in models, and doubles where they are computed with.
[[nodiscard]] inline double toDouble(float value) {
  return static_cast<double>(value);
}

/// A Transform in double precision.
struct DoublePose {
  glm::dvec3 position{0.0};
  glm::dmat3 rotation{1.0};

  explicit DoublePose(const Transform& pose);
  [[nodiscard]] glm::dvec3 operator()(const glm::dvec3& local) const { return position + rotation * local; }
  [[nodiscard]] glm::dvec3 toLocal(const glm::dvec3& point) const { return (point - position) * rotation; }
};

/// All points within `radius` of the convex hull of `points`.
struct RoundedHull {
  std::vector<glm::dvec3> points;
  double radius = 0.0;
};

/// The corners of a prism around a cylinder.
[[nodiscard]] std::vector<glm::dvec3> prismAround(const Cylinder& cylinder, const DoublePose& pose);

/// The corners of a prism with so many sides, a multiple of 4, in a cylinder.
[[nodiscard]] std::vector<glm::dvec3> prismIn(const Cylinder& cylinder, int sides, const DoublePose& pose);

/// The part in the model's frame, exactly; but a cylinder as prismAround() it.
[[nodiscard]] RoundedHull roundedHull(const ConvexPart& part, double hullMargin);

/// How far the part, hull margin included, reaches along a unit direction.
[[nodiscard]] double support(const ConvexPart& part, double hullMargin, const glm::dvec3& direction);

/// A box, or a hull without its margin; nothing for round shapes. Fails on a hull
/// without volume.
[[nodiscard]] Result<std::optional<Polytope>> flatSidedCore(const ConvexPart& part);

/// A polytope that holds the part, hull margin included, and touches it in the directions `tangents`.
/// Elsewhere a sphere or capsule is exceeded by at most 1 % of its radius, a cylinder by 0.5 %, and a hull
/// by 8 % of its margin.
[[nodiscard]] Polytope outerPolytope(const ConvexPart& part, double hullMargin,
                                     std::span<const glm::dvec3> tangents, double epsilon);

/// A polytope of points whose distance from the part's outside, hull margin included, is at least `inset`;
/// empty if there are none. `inset` is 0 or the hull margin. Of a round shape at most 1 % of the radius is
/// lost; of a hull's margin, with inset 0, what rounds its edges and corners.
[[nodiscard]] Polytope innerPolytope(const ConvexPart& part, double hullMargin, double inset);

/// A hull without its margin, in the model's frame. Fails if it has no volume.
[[nodiscard]] Result<Polytope> placedHull(const ConvexHull& hull, const Transform& pose);

/// By which engines widen a part, metres: hulls alone have a margin.
[[nodiscard]] inline double marginOf(const ConvexPart& part, double hullMargin) {
  return std::holds_alternative<ConvexHull>(part.shape) ? hullMargin : 0.0;
}

}  // namespace scatter::levels
