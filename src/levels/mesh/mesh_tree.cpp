#include "levels/mesh/mesh_tree.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "levels/mesh/triangle.h"

namespace scatter::levels {
namespace {

constexpr std::size_t kLeafSize = 4;
constexpr std::size_t kStackSize = 96;  ///< Halving splits need one entry for each power of two.

/// Seen from further than this many radii, the triangles of a node count as one.
constexpr double kFarRadii = 2.3;

double squaredDistance(const DoubleBounds& bounds, const glm::dvec3& point) {
  const glm::dvec3 outside = glm::max(glm::max(bounds.min - point, point - bounds.max), glm::dvec3(0.0));
  return glm::dot(outside, outside);
}

}  // namespace

MeshTree::MeshTree(const WorkMesh& mesh) {
  corners_.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    corners_.push_back({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
  }
  nodes_.reserve(mesh.triangles.size());
  build(0, corners_.size());
}

std::uint32_t MeshTree::build(std::size_t first, std::size_t last) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  Node node;
  node.first = static_cast<std::uint32_t>(first);
  node.count = static_cast<std::uint32_t>(last - first);
  summarise(node);
  nodes_.push_back(node);
  if (last - first <= kLeafSize) return index;

  DoubleBounds middles;
  for (std::size_t i = first; i < last; ++i) middles.add(corners_[i][0] + corners_[i][1] + corners_[i][2]);
  const glm::dvec3 size = middles.max - middles.min;
  const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  const std::size_t half = (first + last) / 2;
  const auto at = [this](std::size_t i) { return corners_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(half), at(last), [axis](const Corners& a, const Corners& b) {
    return a[0][axis] + a[1][axis] + a[2][axis] < b[0][axis] + b[1][axis] + b[2][axis];
  });
  const std::uint32_t left = build(first, half);
  const std::uint32_t right = build(half, last);
  nodes_[index].left = left;
  nodes_[index].right = right;
  return index;
}

void MeshTree::summarise(Node& node) const {
  double total = 0.0;
  glm::dvec3 plain{0.0};
  for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
    const Corners& c = corners_[i];
    for (const glm::dvec3& corner : c) node.bounds.add(corner);
    const glm::dvec3 vector = areaVector(c[0], c[1], c[2]);
    const glm::dvec3 middle = (c[0] + c[1] + c[2]) / 3.0;
    node.area += vector;
    node.center += glm::length(vector) * middle;
    plain += middle;
    total += glm::length(vector);
  }
  node.center = total > 0.0 ? node.center / total : plain / static_cast<double>(node.count);
  const glm::dvec3 reach = glm::max(node.center - node.bounds.min, node.bounds.max - node.center);
  node.radius = glm::length(reach);
}

double MeshTree::distance(const glm::dvec3& point, double limit) const {
  double best = limit * limit;
  std::array<std::uint32_t, kStackSize> stack{};
  std::size_t depth = 1;
  while (depth > 0) {
    const Node& node = nodes_[stack[--depth]];
    if (squaredDistance(node.bounds, point) >= best) continue;
    if (node.left == 0) {
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        const Corners& c = corners_[i];
        const glm::dvec3 offset = closestPoint(point, c[0], c[1], c[2]) - point;
        best = std::min(best, glm::dot(offset, offset));
      }
      continue;
    }
    const bool isLeftNearer =
        squaredDistance(nodes_[node.left].bounds, point) < squaredDistance(nodes_[node.right].bounds, point);
    stack[depth++] = isLeftNearer ? node.right : node.left;
    stack[depth++] = isLeftNearer ? node.left : node.right;
  }
  return std::sqrt(best);
}

double MeshTree::winding(const glm::dvec3& point) const {
  double angle = 0.0;
  std::array<std::uint32_t, kStackSize> stack{};
  std::size_t depth = 1;
  while (depth > 0) {
    const Node& node = nodes_[stack[--depth]];
    const glm::dvec3 toCenter = node.center - point;
    const double distance = glm::length(toCenter);
    if (distance > kFarRadii * node.radius) {
      angle += glm::dot(node.area, toCenter) / (distance * distance * distance);
    } else if (node.left == 0) {
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        angle += solidAngle(point, corners_[i][0], corners_[i][1], corners_[i][2]);
      }
    } else {
      stack[depth++] = node.left;
      stack[depth++] = node.right;
    }
  }
  return angle / (4.0 * std::numbers::pi);
}

}  // namespace scatter::levels
