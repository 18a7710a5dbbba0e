#pragma once

#include "io/collada/frame.h"

#include <scatter/io/physics_document.h>

#include <map>
#include <optional>

namespace scatter::io {

/// The physics materials of a document: those of its libraries, then those that stand where they are used.
class ColladaMaterials {
 public:
  [[nodiscard]] static Result<ColladaMaterials> read(const ColladaFrame& frame);

  /// The material of a body or shape: of the `<instance_physics_material>` or `<physics_material>` in it.
  [[nodiscard]] Result<std::optional<std::size_t>> find(const pugi::xml_node& parent);

  [[nodiscard]] const std::vector<DocumentMaterial>& all() const { return materials_; }

 private:
  explicit ColladaMaterials(const ColladaFrame& frame) : frame_(&frame) {}

  [[nodiscard]] Result<std::size_t> add(const pugi::xml_node& material);

  const ColladaFrame* frame_;
  std::vector<DocumentMaterial> materials_;
  std::map<std::size_t, std::size_t> index_;  ///< By the element's hash value, which is unique.
};

}  // namespace scatter::io
