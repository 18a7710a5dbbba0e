#pragma once

#include <map>
#include <optional>

#include "io/gltf/bodies.h"
#include "io/gltf/shapes.h"

namespace scatter::io {

/// Makes document shapes of colliders.
class GltfColliders {
 public:
  GltfColliders(GltfFile& file, const GltfNodes& nodes, GltfMeshes& meshes)
      : file_(&file), nodes_(&nodes), meshes_(&meshes) {}

  /// Nothing, with a warning, if the collider cannot be used.
  [[nodiscard]] std::optional<DocumentShape> shapeOf(const GltfCollider& collider);

 private:
  [[nodiscard]] std::optional<ScaledShape> buildGeometry(const GltfCollider& collider,
                                                         const JsonPlace& place);
  [[nodiscard]] std::optional<GltfShape> meshHull(const GltfCollider& collider, const JsonPlace& place);

  /// The meshes at and below the collider's source node, whose own place does not count.
  [[nodiscard]] VisualMesh meshOf(const GltfCollider& collider, const GltfPlacement& base,
                                  const JsonPlace& place);

  GltfFile* file_;
  const GltfNodes* nodes_;
  GltfMeshes* meshes_;
  std::map<std::size_t, std::optional<GltfShape>> shapes_;  ///< Of KHR_implicit_shapes, as they were read.
};

}  // namespace scatter::io
