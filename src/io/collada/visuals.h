#pragma once

#include "io/collada/frame.h"
#include "io/collada/transforms.h"

#include <scatter/io/model.h>

#include <map>
#include <pugixml.hpp>
#include <set>
#include <string>
#include <vector>

namespace scatter::io {

/// A `<geometry>` that a node shows.
struct VisualPart {
  pugi::xml_node geometry;
  Placement place{};  ///< In the frame of the body that the node shows.
};

/// Equal for parts that show the same.
[[nodiscard]] std::string visualKey(const std::vector<VisualPart>& parts);

/// Finds and reads the meshes that nodes show.
class ColladaVisuals {
 public:
  /// `moved` are the hash values of the nodes that bodies move: what such a node shows is not shown by the
  /// nodes around it.
  ColladaVisuals(const ColladaFrame& frame, std::set<std::size_t> moved)
      : frame_(&frame), moved_(std::move(moved)) {}

  /// What a node and those in it show. `residue` is the node's frame in that of its body.
  [[nodiscard]] Result<std::vector<VisualPart>> find(const pugi::xml_node& node, const Placement& residue);

  /// One mesh of all parts, in the body's frame, y up.
  [[nodiscard]] Result<VisualMesh> read(const std::vector<VisualPart>& parts);

 private:
  [[nodiscard]] Result<void> visit(const pugi::xml_node& node, const Placement& place, int depth,
                                   std::vector<VisualPart>& parts);
  [[nodiscard]] Result<void> visitElement(const pugi::xml_node& element, const Placement& place, int depth,
                                          std::vector<VisualPart>& parts);
  [[nodiscard]] Result<const VisualMesh*> meshOf(const pugi::xml_node& geometry);

  const ColladaFrame* frame_;
  std::set<std::size_t> moved_;
  std::map<std::size_t, VisualMesh> meshes_;  ///< By the geometry's hash value.
};

}  // namespace scatter::io
