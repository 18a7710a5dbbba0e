#pragma once

#include "collision/frame.h"

namespace scatter {

/// A lower bound for the distance of two boxes, by the separating axis test over the 15 axes (Gottschalk,
/// Lin, Manocha 1996). Negative if they overlap. Box A is along the axes of its frame; box B is along those
/// of `frameB`, given in A's frame. Stops early when the bound is more than `enough`.
[[nodiscard]] float boxSeparation(const Vec3& centerA, const Vec3& halfA, const Vec3& centerB,
                                  const Vec3& halfB, const Frame& frameB, float enough);

}  // namespace scatter
