#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "levels/mesh/triangle_hull.h"

namespace scatter::levels {

/// Points whose hull has at most `maxVertices` vertices, holds `hull` to within rounding and exceeds it
/// little; nothing if rounding defeats it.
[[nodiscard]] std::optional<TriangleHull> simplifyOutward(HullBuilder& builder, const TriangleHull& hull,
                                                          int maxVertices);

}  // namespace scatter::levels
