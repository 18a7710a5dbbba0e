#pragma once

#include <functional>

#include "levels/build/distance_grid.h"
#include "levels/build/merge_tree.h"
#include "levels/build/pre_merge.h"
#include "levels/build/symmetric_mesh.h"
#include "levels/mesh/region_map.h"
#include "levels/mesh/work_mesh.h"

namespace scatter::levels {

struct MergeDef {
  int maxVertices = 16;
  std::function<void(double share)> progress;

  /// If the tree is to be its own mirror image: what the patches are of, which are then of one side or
  /// symmetric.
  const SymmetricMesh* symmetry = nullptr;
};

/// Merges the patches down to one, each time the pair whose common hull stays closest to the mesh; gaps count
/// with their weight. What different regions keep is merged last.
[[nodiscard]] MergeTree mergeGreedily(const WorkMesh& mesh, const DistanceGrid& grid,
                                      const TriangleRegions& regions, Patches patches,
                                      const MergeDef& definition);

}  // namespace scatter::levels
