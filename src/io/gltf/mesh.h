#pragma once

#include <scatter/io/model.h>

#include <glm/mat3x3.hpp>
#include <map>

#include "io/gltf/file.h"

namespace scatter::io {

/// Where something is: x becomes position + rotation · stretch · x. What nodes with scale do to
/// a rigid frame is kept apart in `stretch`, which is 1 without scale.
struct GltfPlacement {
  glm::dvec3 position{0.0};
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
  glm::dmat3 stretch{1.0};

  [[nodiscard]] GltfPlacement operator*(const GltfPlacement& child) const;
  [[nodiscard]] Transform rigid() const { return toTransform(position, rotation); }
  [[nodiscard]] bool isIdentity() const;
};

/// The triangles of a file's meshes, each read when it is first asked for.
class GltfMeshes {
 public:
  explicit GltfMeshes(GltfFile& file) : file_(&file) {}

  [[nodiscard]] const VisualMesh& at(const JsonPlace& reference);

  /// Adds a mesh, moved to its place, to another.
  void append(const JsonPlace& reference, const GltfPlacement& placement, VisualMesh& target);

 private:
  [[nodiscard]] VisualMesh read(const JsonPlace& mesh);
  void readPrimitive(const JsonPlace& primitive, VisualMesh& mesh);

  GltfFile* file_;
  std::map<std::size_t, VisualMesh> meshes_;
};

}  // namespace scatter::io
