#pragma once

#include <cstddef>
#include <glm/common.hpp>
#include <glm/vec2.hpp>

namespace scatter::levels {

/// The n-th of points that fill a triangle evenly, as how far it is towards the second and the third corner:
/// the additive recurrence that spreads points most evenly in two dimensions (Roberts, 2018), folded at the
/// diagonal.
[[nodiscard]] inline glm::dvec2 evenInTriangle(std::size_t n) {
  const glm::dvec2 step(0.7548776662466927, 0.5698402909980532);
  const glm::dvec2 point = glm::fract(0.5 + step * static_cast<double>(n));
  return point.x + point.y > 1.0 ? 1.0 - point : point;
}

}  // namespace scatter::levels
