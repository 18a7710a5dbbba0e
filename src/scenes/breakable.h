#pragma once

#include <scatter/levels/level_set.h>
#include <scatter/result.h>
#include <scatter/world/body.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "scenes/placement.h"

namespace scatter {

/// An object, and the gibs that take its place when it breaks (report, section 3.2). The gibs are in the
/// object's frame, lie inside it, and keep clear of one another at every level.
struct Breakable {
  std::shared_ptr<const LevelSet> whole;
  std::vector<std::shared_ptr<const LevelSet>> gibs;
  float mass = 1.0F;       ///< Kilograms, of the whole as of all gibs.
  float toughness = 1.0F;  ///< The change of velocity in one step that breaks it, m/s.
};

/// A garden urn, a metre high: hollow, of 24 clay panels and a base, and breaks into 51 shards.
[[nodiscard]] Result<Breakable> makeUrn(Random& random);

/// A box of twelve boards, 0.8 m wide, that breaks into 24 pieces of board.
[[nodiscard]] Result<Breakable> makeBoardBox(Random& random);

/// The gibs in the place of a broken object, with its mass, momentum and angular momentum; `burst` (per
/// second) is how fast they fly apart, times their distance from their common centre of mass.
[[nodiscard]] std::vector<BodyDef> breakApart(const Breakable& object, const BodyDef& def,
                                              const BodyState& state, float burst);

/// How many primitives `count` such objects bring to the narrowphase if everything meets everything (report,
/// section 3.2), the whole ones at the finest level.
struct PrimitiveCount {
  std::size_t whole = 0;
  std::size_t broken = 0;

  /// By how much the number of pairs of primitives grows: about (broken / whole)².
  [[nodiscard]] double pairGrowth() const;
};

/// With gibs at their finest level, or at level 1, where each is one primitive: the report's worst case,
/// whose growth is (g_max / k_max)².
[[nodiscard]] PrimitiveCount countPrimitives(const Breakable& object, std::size_t count, bool finestGibs);

}  // namespace scatter
