#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "levels/mesh/triangle_hull.h"

namespace scatter::levels {

/// Whether all points lie strictly inside the hull of `hull.vertices`: a proof, whatever rounding did to the
/// triangles. If those form a closed surface and a point is on the inner side of each, the surface winds
/// around it, which it cannot do around a point outside the hull of its corners. Sides are told by
/// determinants that exceed their rounding error (Shewchuk, Adaptive Precision Floating-Point Arithmetic,
/// 1997); false where one does not.
[[nodiscard]] bool provesInside(const TriangleHull& hull, std::span<const glm::dvec3> points);

}  // namespace scatter::levels
