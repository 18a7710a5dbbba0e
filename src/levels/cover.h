#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "levels/polytope.h"

namespace scatter::levels {

/// A convex polytope as something that may hold others, widened by a distance at will.
class Cover {
 public:
  /// `solid` is not empty.
  explicit Cover(Polytope solid);

  [[nodiscard]] const Polytope& solid() const { return solid_; }
  [[nodiscard]] const DoubleBounds& bounds() const { return bounds_; }

  /// The faces, and for each edge or corner so sharp that the widened faces would meet far away, a plane
  /// that only touches it: what is within all planes moved out by d is within about 2 d of the solid.
  [[nodiscard]] const std::vector<HalfSpace>& planes() const { return planes_; }

  /// How far the planes must move out to hold the point; negative inside. At most its distance.
  [[nodiscard]] double depthOutside(const glm::dvec3& point) const;

  /// How far the planes must move out to hold all points.
  [[nodiscard]] double depthOutside(std::span<const glm::dvec3> points) const;

 private:
  void addBevels();

  Polytope solid_;
  DoubleBounds bounds_;
  std::vector<HalfSpace> planes_;
};

/// A place that no cover reaches.
struct Uncovered {
  glm::dvec3 point{0.0};
  double distance = 0.0;  ///< From the nearest cover.
};

/// Whether `solid` lies within the union of the covers widened by `tolerance`; as findUncovered, without
/// looking where it sticks out.
[[nodiscard]] bool isCovered(const Polytope& solid, std::span<const Cover> covers, double tolerance,
                             double epsilon);

/// Where `solid` is furthest from the union of the covers, nothing if it lies within the union of the
/// covers widened by `tolerance`. Vertices within `epsilon` of a plane count as lying on it. Of the
/// points furthest out, measured by the planes of the covers, the one with the largest distance is given.
[[nodiscard]] std::optional<Uncovered> findUncovered(const Polytope& solid, std::span<const Cover> covers,
                                                     double tolerance, double epsilon);

}  // namespace scatter::levels
