#include "io/collada/visuals.h"

#include <cmath>
#include <string_view>
#include <utility>

#include "io/collada/geometry.h"

namespace scatter::io {
namespace {

/// An instance can lead deeper than the file is nested.
constexpr int kMaxVisualDepth = 256;

/// A visit to a node costs as much as some vertices.
constexpr std::size_t kVisitCost = 20;

bool isUnmoved(const Placement& place) {
  return place.rigid && place.pose.position == Vec3(0.0F) && place.pose.rotation == kNoRotation;
}

/// False if a vertex ends up out of reach.
bool append(const VisualMesh& mesh, const Placement& place, VisualMesh& result) {
  const auto first = static_cast<std::uint32_t>(result.vertices.size());
  for (const Vec3& vertex : mesh.vertices) {
    const Vec3 moved = isUnmoved(place) ? vertex : Vec3(place.matrix * glm::dvec4(glm::dvec3(vertex), 1.0));
    constexpr auto kFar = static_cast<float>(ColladaFrame::kMaxLength);
    if (!(std::abs(moved.x) <= kFar && std::abs(moved.y) <= kFar && std::abs(moved.z) <= kFar)) {
      return false;
    }
    result.vertices.push_back(moved);
  }
  const bool mirrored = glm::determinant(glm::dmat3(place.matrix)) < 0.0;
  for (auto triangle : mesh.triangles) {
    if (mirrored) {
      std::swap(triangle[1], triangle[2]);
    }
    result.triangles.push_back({first + triangle[0], first + triangle[1], first + triangle[2]});
  }
  return true;
}

}  // namespace

std::string visualKey(const std::vector<VisualPart>& parts) {
  std::string key;
  for (const VisualPart& part : parts) {
    key += std::to_string(part.geometry.hash_value());
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 3; ++row) {
        key += ' ' + std::to_string(part.place.matrix[column][row]);
      }
    }
    key += ';';
  }
  return key;
}

Result<std::vector<VisualPart>> ColladaVisuals::find(const pugi::xml_node& node, const Placement& residue) {
  std::vector<VisualPart> parts;
  return visit(node, residue, 0, parts).map([&] { return std::move(parts); });
}

Result<void> ColladaVisuals::visit(const pugi::xml_node& node, const Placement& place, int depth,
                                   std::vector<VisualPart>& parts) {
  if (depth > kMaxVisualDepth) {
    return frame_->xml().failAt(
        node, "stands deeper in the scene than " + std::to_string(kMaxVisualDepth) + " nodes");
  }
  for (const pugi::xml_node& element : node.children()) {
    if (const auto visited = visitElement(element, place, depth, parts); !visited) {
      return visited;
    }
  }
  return frame_->take(node, kVisitCost);
}

Result<void> ColladaVisuals::visitElement(const pugi::xml_node& element, const Placement& place, int depth,
                                          std::vector<VisualPart>& parts) {
  const std::string_view name = element.name();
  if (name == "instance_controller") {
    frame_->note(element, "skins and morphs are not supported; it is not shown");
    return {};
  }
  if (name == "instance_geometry") {
    const auto geometry = frame_->followOrMend(element, "url", "geometry", "it is not shown");
    if (!geometry) {
      return tl::unexpected(geometry.error());
    }
    if (*geometry && (geometry->child("mesh") || geometry->child("convex_mesh"))) {
      parts.push_back({*geometry, place});
    } else if (*geometry) {
      frame_->note(*geometry, "has no <mesh> or <convex_mesh> and is not shown");
    }
    return {};
  }
  pugi::xml_node child = name == "node" ? element : pugi::xml_node();
  if (name == "instance_node") {
    const auto found = frame_->followOrMend(element, "url", "node", "it is left out");
    if (!found) {
      return tl::unexpected(found.error());
    }
    child = *found;
  }
  if (!child || moved_.contains(child.hash_value())) {
    return {};
  }
  const auto own = readNodePlacement(*frame_, child);
  if (!own) {
    return tl::unexpected(own.error());
  }
  return visit(child, place * *own, depth + 1, parts);
}

Result<const VisualMesh*> ColladaVisuals::meshOf(const pugi::xml_node& geometry) {
  const auto known = meshes_.find(geometry.hash_value());
  if (known != meshes_.end()) {
    return &known->second;
  }
  // A geometry can have both; the mesh is what was drawn.
  const pugi::xml_node drawn = geometry.child("mesh");
  const auto element = drawn ? drawn : findMeshElement(*frame_, geometry);
  if (!element) {
    return tl::unexpected(element.error());
  }
  return readMesh(*frame_, *element).map([&](VisualMesh mesh) -> const VisualMesh* {
    return &meshes_.emplace(geometry.hash_value(), std::move(mesh)).first->second;
  });
}

Result<VisualMesh> ColladaVisuals::read(const std::vector<VisualPart>& parts) {
  VisualMesh result;
  for (const VisualPart& part : parts) {
    const auto mesh = meshOf(part.geometry);
    if (!mesh) {
      return tl::unexpected(mesh.error());
    }
    if (const auto taken = frame_->take(part.geometry, (*mesh)->vertices.size() + (*mesh)->triangles.size());
        !taken) {
      return tl::unexpected(taken.error());
    }
    if (!append(**mesh, part.place, result)) {
      return frame_->xml().failAt(part.geometry, "is shown too far from its body");
    }
  }
  return result;
}

}  // namespace scatter::io
