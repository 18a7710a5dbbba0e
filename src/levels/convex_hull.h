#pragma once

#include <scatter/result.h>

#include <glm/vec3.hpp>
#include <span>

#include "levels/polytope.h"

namespace scatter::levels {

/// The convex hull of points (through qhull). Fails if they do not span a volume: fewer than four, or no
/// thicker than a millionth of their extent plus `rounding`, the error of their coordinates; the message
/// is a phrase such as "its 5 vertices lie in one plane".
[[nodiscard]] Result<Polytope> convexHull(std::span<const glm::dvec3> points, double rounding = 0.0);

}  // namespace scatter::levels
