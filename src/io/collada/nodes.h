#pragma once

#include "io/collada/frame.h"
#include "io/collada/transforms.h"

#include <map>
#include <pugixml.hpp>
#include <set>
#include <utility>
#include <vector>

namespace scatter::io {

/// The nodes of the visual scene that a document shows, and where they stand.
class ColladaNodes {
 public:
  /// `moved` are the hash values of the nodes that bodies move: meshes outside of them are noted.
  [[nodiscard]] static Result<ColladaNodes> read(const ColladaFrame& frame, std::set<std::size_t> moved);

  /// Of a `<node>` in the world. A node that stands in the scene several times is placed where it stands
  /// first; one that does not stand in it, by its own library.
  [[nodiscard]] Result<Placement> placement(const pugi::xml_node& node);

 private:
  ColladaNodes(const ColladaFrame& frame, std::set<std::size_t> moved)
      : frame_(&frame), moved_(std::move(moved)) {}

  [[nodiscard]] Result<void> walk(const pugi::xml_node& scene);
  void noteMesh(const pugi::xml_node& element, const pugi::xml_node& parent) const;
  [[nodiscard]] Result<void> visit(const pugi::xml_node& child, const pugi::xml_node& parent);

  /// Where a node was met first.
  struct Visit {
    pugi::xml_node parent;  ///< The node, or scene, around it.
    int depth = 0;
    bool moved = false;  ///< By a body, with a node around it or alone.
    bool repeated = false;
  };

  const ColladaFrame* frame_;
  std::set<std::size_t> moved_;
  std::map<std::size_t, Visit> visits_;  ///< By the elements' hash values, which are unique.
  std::map<std::size_t, Placement> placements_;
  std::vector<pugi::xml_node> queue_;
};

}  // namespace scatter::io
