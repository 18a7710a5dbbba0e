#pragma once

#include <glm/vec3.hpp>

namespace scatter::levels {

/// The point of the triangle nearest to `point` (Ericson, Real-Time Collision Detection, 5.1.5). The
/// triangle may be degenerate.
[[nodiscard]] glm::dvec3 closestPoint(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b,
                                      const glm::dvec3& c);

[[nodiscard]] double triangleArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// Half the cross product of two edges: the area along the normal.
[[nodiscard]] glm::dvec3 areaVector(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// The solid angle, seen from `eye`, positive if the triangle turns its back (van Oosterom and Strackee,
/// 1983).
[[nodiscard]] double solidAngle(const glm::dvec3& eye, const glm::dvec3& a, const glm::dvec3& b,
                                const glm::dvec3& c);

}  // namespace scatter::levels
