#pragma once

#include <cstddef>

#include "levels/mesh/triangle_hull.h"

namespace scatter::levels {

/// Replaces edges of `hull` by single points beyond them until it has at most `maxVertices` vertices, the
/// edge first whose point is nearest to `original` (after Sander et al., Silhouette Clipping, 2000). It never
/// loses anything. False if it cannot go on.
[[nodiscard]] bool collapseEdges(HullBuilder& builder, const TriangleHull& original, std::size_t maxVertices,
                                 TriangleHull& hull);

}  // namespace scatter::levels
