#pragma once

#include "io/collada/frame.h"
#include "io/collada/transforms.h"

#include <map>
#include <pugixml.hpp>
#include <vector>

namespace scatter::io {

/// The nodes of the visual scene that a document shows, and where they stand.
class ColladaNodes {
 public:
  [[nodiscard]] static Result<ColladaNodes> read(const ColladaFrame& frame);

  /// Of a `<node>` in the world. A node that stands in the scene several times is placed where it stands
  /// first; one that does not stand in it, by its own library.
  [[nodiscard]] Result<Placement> placement(const pugi::xml_node& node);

 private:
  explicit ColladaNodes(const ColladaFrame& frame) : frame_(&frame) {}

  [[nodiscard]] Result<void> walk(const pugi::xml_node& scene);
  [[nodiscard]] Result<void> visit(const pugi::xml_node& child, const pugi::xml_node& parent);

  /// Where a node was met first.
  struct Visit {
    pugi::xml_node parent;  ///< The node, or scene, around it.
    int depth = 0;
    bool repeated = false;
  };

  const ColladaFrame* frame_;
  std::map<std::size_t, Visit> visits_;  ///< By the elements' hash values, which are unique.
  std::map<std::size_t, Placement> placements_;
  std::vector<pugi::xml_node> queue_;
};

}  // namespace scatter::io
