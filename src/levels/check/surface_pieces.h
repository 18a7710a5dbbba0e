#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

#include "levels/check/solid_part.h"
#include "levels/polytope.h"

namespace scatter::levels {

/// A convex piece of a triangle, by its corners in order.
using Piece = std::vector<glm::dvec3>;

[[nodiscard]] double areaOf(const Piece& piece);

/// The largest distance of a corner from the corners' mean, and that mean.
[[nodiscard]] std::pair<double, glm::dvec3> radiusOf(const Piece& piece);

/// Two pieces, cut across the longest edge through the middle.
[[nodiscard]] std::pair<Piece, Piece> halves(const Piece& piece);

/// What is outside of a part with flat sides, whose planes are moved out by `widening`. Slivers within
/// `epsilon` of a plane are dropped.
[[nodiscard]] std::vector<Piece> cutAway(const Piece& piece, const SolidPart& part, double widening,
                                         double epsilon);

/// What is outside of all parts widened by `widening`. What round parts hold together is found by halving
/// down to `resolution`; a piece with a corner outside of all counts as outside altogether.
[[nodiscard]] std::vector<Piece> cutAway(const Piece& piece, std::span<const SolidPart* const> parts,
                                         double widening, double resolution);

}  // namespace scatter::levels
