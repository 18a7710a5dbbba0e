#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "levels/mesh/triangle_hull.h"

namespace scatter::levels {

/// The hull of any points, made solid: sets thinner than `definition.thickness` in a direction are thickened
/// to it on both sides. True if they had to be.
bool buildThickHull(HullBuilder& builder, std::span<const glm::dvec3> points, const HullDef& definition,
                    TriangleHull& result);

/// The points, and where they are thinner than `thickness`, what they lack of it on both sides of them.
[[nodiscard]] std::vector<glm::dvec3> thickenedTo(std::span<const glm::dvec3> points, double thickness);

}  // namespace scatter::levels
