#pragma once

#include <scatter/levels/level_set.h>
#include <scatter/levels/surface_mesh.h>
#include <scatter/result.h>

namespace scatter::bench {

/// A mesh decomposed by HACD (hierarchical approximate convex decomposition) of Bullet's extras.
struct HacdResult {
  Level level;
  int flatParts = 0;     ///< Left out because they have no volume.
  double seconds = 0.0;  ///< Processor time.
};

/// Into `parts` hulls of at most `maxVertices` vertices (0: as many as they have), within a time limit. Other
/// settings as in Bullet's own example. Fails if it takes longer or crashes.
[[nodiscard]] Result<HacdResult> decompose(const SurfaceMesh& mesh, int parts, int maxVertices,
                                           int limitSeconds);

}  // namespace scatter::bench
