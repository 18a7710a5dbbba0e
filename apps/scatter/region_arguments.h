#pragma once

#include <scatter/io/mesh_file.h>
#include <scatter/levels/mesh_region.h>
#include <scatter/result.h>

#include <string>
#include <vector>

namespace scatter::app {

/// Regions of a mesh as the user gave them, each a REGION: "box:X0,Y0,Z0,X1,Y1,Z1", or a name in the mesh
/// file, with "material:", "object:" or "group:" before it if that needs to be said.
struct RegionArguments {
  std::vector<std::string> kept;        ///< REGION
  std::vector<std::string> importance;  ///< REGION=WEIGHT
  std::vector<std::string> watched;     ///< REGION, only measured.

  [[nodiscard]] bool isEmpty() const { return kept.empty() && importance.empty() && watched.empty(); }
};

/// Fails on what is wrong whatever the mesh.
[[nodiscard]] Result<void> checkRegions(const RegionArguments& arguments);

/// In the order of first mention; what is said of the same one twice goes together. Fails on unknown names.
[[nodiscard]] Result<std::vector<MeshRegion>> findRegions(const RegionArguments& arguments,
                                                          const MeshFile& file);

}  // namespace scatter::app
