#pragma once

#include <scatter/levels/convex_part.h>
#include <scatter/result.h>

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "levels/part_geometry.h"
#include "levels/polytope.h"

namespace scatter::levels {

/// A part, without hull margin, that can be asked about points; in the model's frame and double precision.
class SolidPart {
 public:
  /// Fails on values that are out of range and on a hull without volume, with a phrase.
  [[nodiscard]] static Result<SolidPart> create(const ConvexPart& part);

  [[nodiscard]] const DoubleBounds& bounds() const { return bounds_; }

  /// Whether planes() bound it; round parts have none.
  [[nodiscard]] bool isFlatSided() const { return !core_.isEmpty(); }

  /// What is inside all of them is inside the part, rounding included.
  [[nodiscard]] std::span<const HalfSpace> planes() const { return planes_; }

  /// Negative inside the part, positive outside, where it is at most the distance; convex.
  [[nodiscard]] double depthOutside(const glm::dvec3& point) const;

  /// Of all points: the largest one.
  [[nodiscard]] double depthOutside(std::span<const glm::dvec3> points) const;

  /// Euclidean, 0 inside.
  [[nodiscard]] double distance(const glm::dvec3& point) const;

 private:
  SolidPart(const ConvexPart& part, Polytope core);

  ConvexShape shape_;
  DoublePose pose_;
  Polytope core_;  ///< Empty for round parts.
  std::vector<HalfSpace> planes_;
  DoubleBounds bounds_;
};

/// The parts of a level; the error names the part, counted from 1.
[[nodiscard]] Result<std::vector<SolidPart>> solidParts(const std::vector<ConvexPart>& parts);

}  // namespace scatter::levels
