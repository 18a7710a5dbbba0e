#pragma once

#include <cstddef>
#include <optional>

#include "levels/build/mirror.h"
#include "levels/mesh/triangle_hull.h"

namespace scatter::levels {

/// Nearer to its mirror's plane than this, as a share of the hull's diagonal, a corner is on it.
inline constexpr double kOnPlane = 1e-7;

struct CollapseDef {
  std::size_t maxVertices = 16;
  std::optional<Mirror> mirror{};  ///< If edges are to be replaced together with their images.
};

/// Replaces edges of `hull` by single points beyond them until it has at most `maxVertices` vertices, the
/// edge first whose point is nearest to `original` (after Sander et al., Silhouette Clipping, 2000). It never
/// loses anything. False if it cannot go on.
[[nodiscard]] bool collapseEdges(HullBuilder& builder, const TriangleHull& original,
                                 const CollapseDef& definition, TriangleHull& hull);

}  // namespace scatter::levels
