#include "io/gltf/nodes.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace scatter::io {
namespace {

constexpr double kMaxScale = 1e6;

/// A matrix as a rotation and what is left: its scale and shear.
GltfPlacement readMatrix(const JsonPlace& place) {
  const std::vector<double> m = place.numbers(16);
  const glm::dmat3 linear(m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]);
  for (int column = 0; column < 3; ++column) {
    if (!(glm::length(linear[column]) <= kMaxScale)) {
      place.fail("scales by more than " + std::to_string(static_cast<int>(kMaxScale)));
    }
  }
  if (!isInReach({m[12], m[13], m[14]})) {
    place.fail("lies too far from the origin");
  }
  GltfPlacement placement;
  placement.position = {m[12], m[13], m[14]};
  placement.stretch = linear;
  // Gram and Schmidt: a rotation whose x axis is the matrix's and whose y axis is near the matrix's.
  const double xLength = glm::length(linear[0]);
  const glm::dvec3 x = xLength > 0.0 ? linear[0] / xLength : glm::dvec3(0.0);
  const glm::dvec3 across = linear[1] - x * glm::dot(x, linear[1]);
  const double acrossLength = glm::length(across);
  if (xLength > 0.0 && acrossLength > 1e-9 * glm::length(linear[1])) {
    const glm::dvec3 y = across / acrossLength;
    const glm::dmat3 turn(x, y, glm::cross(x, y));
    placement.rotation = glm::normalize(glm::quat_cast(turn));
    placement.stretch = glm::transpose(glm::mat3_cast(placement.rotation)) * linear;
  }
  return placement;
}

GltfPlacement readPlacement(const JsonPlace& node) {
  if (const auto matrix = node.find("matrix")) {
    return readMatrix(*matrix);
  }
  GltfPlacement placement;
  if (const auto translation = node.find("translation")) {
    placement.position = translation->vector();
  }
  if (const auto rotation = node.find("rotation")) {
    placement.rotation = rotation->rotation();
  }
  if (const auto scale = node.find("scale")) {
    const glm::dvec3 s = scale->vector(kMaxScale);
    placement.stretch = glm::dmat3(s.x, 0.0, 0.0, 0.0, s.y, 0.0, 0.0, 0.0, s.z);
  }
  return placement;
}

/// Scales multiply down a chain of nodes; what grows out of bounds is refused before it overflows.
void checkWorld(const JsonPlace& node, const GltfPlacement& world) {
  // What is in reach of its body may be further away from the world's origin.
  bool bounded = isInReach(world.position / 10.0);
  for (int column = 0; column < 3; ++column) {
    bounded = bounded && glm::length(world.stretch[column]) <= kMaxScale;
  }
  if (!bounded) {
    node.fail("lies too far from the origin or is scaled too much");
  }
}

}  // namespace

GltfNodes::GltfNodes(GltfFile& file) : file_(&file), nodes_(file.count("nodes")) {
  linkChildren();
  sort();
  findScene();
}

void GltfNodes::linkChildren() {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const JsonPlace node = json(i);
    nodes_[i].local = readPlacement(node);
    const auto children = node.find("children");
    for (std::size_t j = 0; children && j < children->size(); ++j) {
      const JsonPlace place = (*children)[j];
      const std::size_t child = place.index(nodes_.size(), "node");
      if (nodes_[child].parent || child == i) {
        place.fail("node " + std::to_string(child) + " is already a child of node " +
                   std::to_string(nodes_[child].parent.value_or(i)) + "; nodes form trees");
      }
      nodes_[child].parent = i;
      nodes_[i].children.push_back(child);
    }
  }
}

void GltfNodes::sort() {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (!nodes_[i].parent) {
      order_.push_back(i);
    }
  }
  for (std::size_t next = 0; next < order_.size(); ++next) {
    GltfNode& node = nodes_[order_[next]];
    node.world = node.parent ? nodes_[*node.parent].world * node.local : node.local;
    // Rotations of length nearly 1 drift when they are multiplied down a long chain.
    node.world.rotation = withUnitLength(node.world.rotation);
    checkWorld(json(order_[next]), node.world);
    order_.insert(order_.end(), node.children.begin(), node.children.end());
  }
  if (order_.size() < nodes_.size()) {
    std::vector<bool> reached(nodes_.size(), false);
    for (const std::size_t i : order_) {
      reached[i] = true;
    }
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (!reached[i]) {
        json(i).fail("is its own ancestor; nodes form trees");
      }
    }
  }
}

void GltfNodes::findScene() {
  const auto chosen = file_->root().find("scene");
  if (file_->count("scenes") == 0) {
    // Without scenes all nodes count.
    for (GltfNode& node : nodes_) {
      node.inScene = true;
    }
    return;
  }
  scene_ = chosen ? file_->entry("scenes", *chosen) : file_->entry("scenes", std::size_t{0});
  if (file_->count("scenes") > 1) {
    file_->warn(file_->root().at("scenes"), "only " + scene_->path() + " is read");
  }
  if (const auto roots = scene_->find("nodes")) {
    for (std::size_t i = 0; i < roots->size(); ++i) {
      nodes_[(*roots)[i].index(nodes_.size(), "node")].inScene = true;
    }
  }
  for (const std::size_t i : order_) {
    nodes_[i].inScene = nodes_[i].inScene || (nodes_[i].parent && nodes_[*nodes_[i].parent].inScene);
  }
}

}  // namespace scatter::io
