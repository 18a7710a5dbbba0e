#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "levels/mesh/region_map.h"
#include "levels/mesh/work_mesh.h"

namespace scatter::levels {

/// Triangles that go together into one part.
using Cluster = std::vector<std::uint32_t>;

/// Patches of the mesh, small and flat, and which of them share an edge.
struct Patches {
  std::vector<Cluster> clusters;
  std::vector<std::vector<std::uint32_t>> neighbours;  ///< Sorted.
  bool isGrouped = false;  ///< The triangles were too many and were grouped by cell and facing first.
};

/// Merges neighbouring triangles to at most `count` patches, by the spread of their places and normals
/// (Ward, 1963). Triangles that share no edge are merged with ones nearby if there are still too many.
/// Patches are smaller where regions weigh more, and none is partly in a kept region; that may take some more
/// than `count`.
[[nodiscard]] Patches preMerge(const WorkMesh& mesh, const TriangleRegions& regions, std::size_t count,
                               std::size_t maxTriangles);

}  // namespace scatter::levels
