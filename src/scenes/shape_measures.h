#pragma once

#include <scatter/levels/convex_part.h>
#include <scatter/levels/level_set.h>
#include <scatter/math.h>

namespace scatter {

/// How far a convex shape reaches from its own origin, without a collision margin.
[[nodiscard]] float reachOf(const ConvexShape& shape);

/// The radius of a ball around the origin of the model that holds its coarsest level.
[[nodiscard]] float boundingRadius(const LevelSet& levels);

/// The lowest and highest of a turned shape, from its origin.
struct Heights {
  float low = 0.0F;
  float high = 0.0F;
};
[[nodiscard]] Heights heightsOf(const std::vector<ConvexPart>& parts, float hullMargin, const Quat& turn);

/// The part, its size `factor` times what it was, about its middle.
[[nodiscard]] ConvexPart scaledPart(const ConvexPart& part, float factor);

}  // namespace scatter
