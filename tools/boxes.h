#pragma once

#include <scatter/levels/convex_part.h>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace scatter::tools {

/// Rounded to tenths of a millimetre, which hides the last bits, in which maths libraries differ.
[[nodiscard]] Vec3 snapped(const glm::dvec3& v);

/// x along `direction`, y as near to `up` as it can be. Neither needs to be of unit length.
[[nodiscard]] glm::dmat3 axesAlong(const glm::dvec3& direction, const glm::dvec3& up);

/// The smallest box along `axes` around the points, widened by `extra` and rounded up.
[[nodiscard]] ConvexPart boxAround(const std::vector<Vec3>& points, const glm::dmat3& axes, double extra);

/// Adds the corners of a part that is a Box.
void addCorners(const ConvexPart& box, std::vector<Vec3>& points);

}  // namespace scatter::tools
