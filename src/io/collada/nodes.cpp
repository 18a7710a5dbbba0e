#include "io/collada/nodes.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace scatter::io {
namespace {

/// An instance can lead deeper than the file is nested.
constexpr int kMaxDepth = 256;

bool isNode(const pugi::xml_node& element) {
  return std::string_view(element.name()) == "node";
}

Result<pugi::xml_node> findScene(const ColladaFrame& frame) {
  const pugi::xml_node root = frame.xml().root();
  if (const pugi::xml_node instance = root.child("scene").child("instance_visual_scene")) {
    return frame.followOrMend(instance, "url", "visual_scene", "nodes are placed by their libraries");
  }
  return root.child("library_visual_scenes").child("visual_scene");
}

}  // namespace

Result<ColladaNodes> ColladaNodes::read(const ColladaFrame& frame, std::set<std::size_t> moved) {
  ColladaNodes nodes(frame, std::move(moved));
  const auto scene = findScene(frame);
  if (!scene) {
    return tl::unexpected(scene.error());
  }
  frame.noteUnused("library_visual_scenes", "visual_scene", {scene->hash_value()});
  if (const auto walked = nodes.walk(*scene); !walked) {
    return tl::unexpected(walked.error());
  }
  return nodes;
}

Result<void> ColladaNodes::walk(const pugi::xml_node& scene) {
  queue_.push_back(scene);
  while (!queue_.empty()) {
    const pugi::xml_node parent = queue_.back();
    queue_.pop_back();
    for (const pugi::xml_node& element : parent.children()) {
      noteMesh(element, parent);
      pugi::xml_node child = isNode(element) ? element : pugi::xml_node();
      if (std::string_view(element.name()) == "instance_node") {
        const auto found = frame_->followOrMend(element, "url", "node", "it is left out");
        if (!found) {
          return tl::unexpected(found.error());
        }
        child = *found;
      }
      if (const auto visited = visit(child, parent); !visited) {
        return visited;
      }
    }
  }
  return {};
}

void ColladaNodes::noteMesh(const pugi::xml_node& element, const pugi::xml_node& parent) const {
  const std::string_view name = element.name();
  const auto around = visits_.find(parent.hash_value());
  if ((name == "instance_geometry" || name == "instance_controller") &&
      (around == visits_.end() || !around->second.moved)) {
    frame_->note(element, "belongs to no rigid body and is left out");
  }
}

Result<void> ColladaNodes::visit(const pugi::xml_node& child, const pugi::xml_node& parent) {
  if (!child) {
    return {};
  }
  const auto around = visits_.find(parent.hash_value());
  const int depth = around == visits_.end() ? 1 : around->second.depth + 1;
  if (depth > kMaxDepth) {
    return frame_->xml().failAt(child,
                                "stands deeper in the scene than " + std::to_string(kMaxDepth) + " nodes");
  }
  const bool moved = moved_.contains(child.hash_value()) || (around != visits_.end() && around->second.moved);
  const auto [known, isNew] = visits_.try_emplace(child.hash_value(), Visit{parent, depth, moved, false});
  if (isNew) {
    queue_.push_back(child);
    return {};
  }
  known->second.repeated = true;
  for (pugi::xml_node above = parent; above;) {
    if (above == child) {
      return frame_->xml().failAt(child,
                                  "is instanced by itself; remove the <instance_node> that leads back");
    }
    const auto next = visits_.find(above.hash_value());
    above = next == visits_.end() ? pugi::xml_node() : next->second.parent;
  }
  return {};
}

Result<Placement> ColladaNodes::placement(const pugi::xml_node& node) {
  const auto start = visits_.find(node.hash_value());
  if (start == visits_.end()) {
    frame_->note(node, "does not stand in the visual scene; it is placed by its library");
  } else if (start->second.repeated) {
    frame_->note(node, "stands in the visual scene several times; the first place is taken");
  }
  std::vector<pugi::xml_node> chain;
  for (pugi::xml_node above = node; isNode(above) && !placements_.contains(above.hash_value());) {
    chain.push_back(above);
    const auto visit = visits_.find(above.hash_value());
    above = visit == visits_.end() ? above.parent() : visit->second.parent;
  }
  Placement result;
  std::reverse(chain.begin(), chain.end());
  for (const pugi::xml_node& below : chain) {
    const auto visit = visits_.find(below.hash_value());
    const pugi::xml_node parent = visit == visits_.end() ? below.parent() : visit->second.parent;
    const auto around = placements_.find(parent.hash_value());
    const auto own = readNodePlacement(*frame_, below);
    if (!own) {
      return own;
    }
    result = around == placements_.end() ? *own : around->second * *own;
    placements_.emplace(below.hash_value(), result);
  }
  return placements_.at(node.hash_value());
}

}  // namespace scatter::io
