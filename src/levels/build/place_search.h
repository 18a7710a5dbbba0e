#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "levels/polytope.h"

namespace scatter::levels {

/// Points beyond all of a few planes.
struct Places {
  std::optional<glm::dvec3> leastVolume;  ///< Least along the gradient.
  std::optional<glm::dvec3> nearest;
};

/// Looks among the corners, edges and faces of the region beyond all planes, to within `epsilon`, for the
/// point that is least along `gradient` (a linear program) and the one nearest to `middle` (a quadratic one).
/// With so few planes, trying all is quick and cannot go wrong. Nothing is found if planes face each other
/// too nearly.
[[nodiscard]] Places findPlaces(std::span<const HalfSpace> planes, const glm::dvec3& gradient,
                                const glm::dvec3& middle, double epsilon);

}  // namespace scatter::levels
