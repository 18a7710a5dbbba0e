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
/// clipping each part against the half-spaces of the coarser parts, moved out by `tolerance` metres.
/// Returns nothing if nested, else the worst gap. Acceptance is a proof to within twice the tolerance (at
/// sharp corners). Rejection is exact where one coarser part could do alone; across several, a finer
/// round part is replaced by a polytope around it and a coarser one by a polytope within, each up to 1 %
/// of the radius off; the margin of a coarser hull counts for a finer part without margin only over the
/// hull's faces; and a crack between coarser hulls counts although their margins may fill it. Fails on a
/// part that is no solid, or a margin or tolerance that is negative or not finite.
[[nodiscard]] Result<std::optional<ContainmentGap>> findContainmentGap(const Level& finer,
                                                                       const Level& coarser, float hullMargin,
                                                                       float tolerance = 1e-4F);

}  // namespace scatter
