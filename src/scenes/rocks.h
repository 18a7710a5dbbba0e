#pragma once

#include <scatter/levels/level_set.h>
#include <scatter/result.h>
#include <scatter/world/world.h>

#include <memory>
#include <string>
#include <vector>

#include "scenes/placement.h"

namespace scatter {

/// No rock reaches further from its origin, metres.
inline constexpr float kRockRadius = 0.53F;

/// A lumpy rock of about a metre: eight hulls of eight vertices, one for each octant, in a box.
[[nodiscard]] Result<std::shared_ptr<const LevelSet>> makeRock(std::string name, Random& random);

/// Rocks of several forms.
[[nodiscard]] Result<std::vector<std::shared_ptr<const LevelSet>>> makeRocks(int forms, Random& random);

/// A rock that never falls asleep.
[[nodiscard]] BodyDef rockBody(std::shared_ptr<const LevelSet> levels, std::string name,
                               const Transform& pose);

/// Rocks on a grid of columns above the ground, ready to fall into a heap between four walls.
struct HeapDef {
  int rocks = 0;
  int columns = 0;  ///< Along each side.
};

[[nodiscard]] Result<void> addHeap(World& world, const HeapDef& def, Random& random);

}  // namespace scatter
