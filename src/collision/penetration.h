#pragma once

#include <optional>

#include "collision/gjk.h"

namespace scatter {

/// How two polytopes that overlap come apart soonest.
struct Penetration {
  Vec3 axis{0.0F};     ///< From A to B, of length 1: B moved along it by `depth` only touches A.
  float depth = 0.0F;  ///< Metres; negative by rounding where they all but touch.
  Vec3 pointB{0.0F};   ///< The point of B, before it is moved, that then touches A.
  WarmSimplex face{};  ///< Of the difference, across the axis: from it GJK finds the next overlap soonest.
  int iterations = 0;
};

/// The penetration depth of two convex polytopes, in A's frame: the expanding polytope algorithm (van den
/// Bergen 2001) from the corners of the difference A - B with which GJK found the overlap. The depth is never
/// less than the true one: it is how far both reach along the axis; it exceeds the true one by no more than
/// `tolerance` (metres) unless rounding ends the expansion early. Nothing if the difference is a line or a
/// point, so that no axis is better than others, or so thin that rounding hides where they touch.
[[nodiscard]] std::optional<Penetration> penetrationOf(const PolytopeView& a, const PolytopeView& b,
                                                       const Frame& frameB, const OverlapSimplex& overlap,
                                                       float tolerance);

}  // namespace scatter
