#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "levels/check/solid_part.h"
#include "levels/check/surface_pieces.h"

namespace scatter::levels {

/// A point and its distance from the nearest part.
struct FarPoint {
  glm::dvec3 point{0.0};
  double distance = -1.0;
};

/// The distance of a point from the union of the parts, 0 inside.
[[nodiscard]] double distanceFrom(std::span<const SolidPart> parts, const glm::dvec3& point);

/// Puts into `furthest` the point of the pieces that is furthest from the union of the parts, if it is
/// further than the one already there. Exact to a thousandth, by branch and bound.
void findFurthest(const std::vector<Piece>& pieces, std::span<const SolidPart> parts, double resolution,
                  FarPoint& furthest);

}  // namespace scatter::levels
