#pragma once

#include <scatter/levels/level_set.h>
#include <scatter/result.h>

#include <cstddef>
#include <optional>

namespace scatter {

/// Where a finer level sticks out of the coarser one.
struct ContainmentGap {
  std::size_t part = 0;   ///< Index of the finer level's part that sticks out furthest.
  Vec3 point{0.0F};       ///< The point that sticks out, in the model's frame.
  float distance = 0.0F;  ///< How far it is from the coarser level, metres.
};

/// Checks that the union of `coarser` holds every part of `finer`, collision margins included, by
/// clipping each part against the half-spaces of the coarser parts: exact for polytopes up to
/// rounding, conservative for round shapes (a finer one is replaced by a polytope around it, a coarser one by
/// a polytope within). Returns nothing if nested to within `tolerance` metres, else the worst gap.
[[nodiscard]] Result<std::optional<ContainmentGap>> findContainmentGap(const Level& finer, const Level& coarser,
                                                                       float hullMargin, float tolerance = 1e-4F);

}  // namespace scatter
