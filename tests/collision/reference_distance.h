#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "collision/part_list.h"

namespace scatter::testing {

/// What is certain about the distance of two polytopes: a plane shows `lower`, two of their points `upper`.
struct DistanceBounds {
  double lower = 0.0;
  double upper = 0.0;
  glm::dvec3 axis{0.0};  ///< From A to B, of length 1; zero if they overlap.
};

using Points = std::vector<glm::dvec3>;

/// Slow, but proves its answer: in double precision, the nearest point of each simplex by trying all of its
/// faces. Both in the same frame.
DistanceBounds referenceDistance(const Points& a, const Points& b);

/// Exactly where the frame puts the points.
glm::dvec3 placed(const Frame& frame, const Vec3& point);
Points placed(const Frame& frame, const PolytopeView& polytope);

}  // namespace scatter::testing
