#pragma once

#include <scatter/levels/convex_part.h>
#include <scatter/result.h>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "levels/polytope.h"

namespace scatter::levels {

/// A Transform in double precision.
struct DoublePose {
  glm::dvec3 position{0.0};
  glm::dmat3 rotation{1.0};

  explicit DoublePose(const Transform& pose);
  [[nodiscard]] glm::dvec3 operator()(const glm::dvec3& local) const { return position + rotation * local; }
};

/// The hull's vertices in the model's frame.
[[nodiscard]] std::vector<glm::dvec3> placedVertices(const ConvexHull& hull, const Transform& pose);

}  // namespace scatter::levels
