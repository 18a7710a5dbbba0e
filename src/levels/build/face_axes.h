#pragma once

#include <glm/mat3x3.hpp>

#include "levels/mesh/triangle_hull.h"

namespace scatter::levels {

/// Right-handed unit axes that most of the hull's area faces: those of the box around a box.
[[nodiscard]] glm::dmat3 faceAxes(const TriangleHull& hull);

/// Some unit direction at a right angle to this one.
[[nodiscard]] glm::dvec3 anyAcross(const glm::dvec3& direction);

/// The unit direction that the largest flat face of the hull is turned to, whatever triangles it is made of:
/// along the axis of a prism or a cylinder.
[[nodiscard]] glm::dvec3 largestFace(const TriangleHull& hull);

}  // namespace scatter::levels
