#pragma once

#include <glm/mat3x3.hpp>

#include "levels/mesh/triangle_hull.h"

namespace scatter::levels {

/// Right-handed unit axes that most of the hull's area faces: those of the box around a box.
[[nodiscard]] glm::dmat3 faceAxes(const TriangleHull& hull);

}  // namespace scatter::levels
