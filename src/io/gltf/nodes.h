#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/gltf/mesh.h"

namespace scatter::io {

struct GltfNode {
  std::optional<std::size_t> parent;
  std::vector<std::size_t> children;
  GltfPlacement local;  ///< In the parent's frame.
  GltfPlacement world;
  bool inScene = false;  ///< Of the scene that is read.
};

/// The node hierarchy of a file: trees, each node after its parent in `order()`.
class GltfNodes {
 public:
  /// Throws GltfFailure if a node has two parents or is its own ancestor.
  explicit GltfNodes(GltfFile& file);

  [[nodiscard]] std::size_t count() const { return nodes_.size(); }
  [[nodiscard]] const GltfNode& operator[](std::size_t index) const { return nodes_[index]; }
  [[nodiscard]] const std::vector<std::size_t>& order() const { return order_; }
  [[nodiscard]] JsonPlace json(std::size_t index) const { return file_->entry("nodes", index); }

  /// The scene that is read: the default one, or the first; nothing if the file has none.
  [[nodiscard]] const std::optional<JsonPlace>& scene() const { return scene_; }

 private:
  void linkChildren();
  void sort();
  void findScene();

  GltfFile* file_;
  std::vector<GltfNode> nodes_;
  std::vector<std::size_t> order_;
  std::optional<JsonPlace> scene_;
};

}  // namespace scatter::io
