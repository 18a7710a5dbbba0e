#pragma once

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

namespace scatter::levels {

/// The inertia of a point mass of one kilogram at `offset`, about the origin (the parallel axis theorem).
[[nodiscard]] inline glm::dmat3 pointInertia(const glm::dvec3& offset) {
  return glm::dmat3(glm::dot(offset, offset)) - glm::outerProduct(offset, offset);
}

}  // namespace scatter::levels
