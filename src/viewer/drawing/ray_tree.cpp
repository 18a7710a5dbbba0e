#include "viewer/drawing/ray_tree.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace scatter::viewer {

namespace {

constexpr std::uint32_t kLeafTriangles = 4;

/// Where the ray enters the box; negative if it starts inside, `limit` or more if it misses.
float entry(const Bounds& box, const Vec3& origin, const Vec3& inverse, float limit) {
  const Vec3 a = (box.min - origin) * inverse;
  const Vec3 b = (box.max - origin) * inverse;
  const Vec3 low = glm::min(a, b);
  const Vec3 high = glm::max(a, b);
  const float enter = std::max({low.x, low.y, low.z});
  const float leave = std::min({high.x, high.y, high.z});
  return enter <= leave && leave >= 0.0F ? enter : limit;
}

}  // namespace

RayTree::RayTree(const MeshData& mesh) {
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Vec3& corner = mesh.positions[mesh.indices[i]];
    triangles_.push_back(
        {corner, mesh.positions[mesh.indices[i + 1]] - corner, mesh.positions[mesh.indices[i + 2]] - corner});
  }
  if (!triangles_.empty()) build(0, static_cast<std::uint32_t>(triangles_.size()));
}

std::uint32_t RayTree::build(std::uint32_t first, std::uint32_t last) {
  const auto middleOf = [](const Triangle& triangle) {
    return triangle.corner + (triangle.edge1 + triangle.edge2) / 3.0F;
  };
  const auto id = static_cast<std::uint32_t>(nodes_.size());
  Node node;
  node.bounds = {triangles_[first].corner, triangles_[first].corner};
  Bounds middles{middleOf(triangles_[first]), middleOf(triangles_[first])};
  for (std::uint32_t i = first; i < last; ++i) {
    const Triangle& triangle = triangles_[i];
    for (const Vec3& corner :
         {triangle.corner, triangle.corner + triangle.edge1, triangle.corner + triangle.edge2}) {
      node.bounds.min = glm::min(node.bounds.min, corner);
      node.bounds.max = glm::max(node.bounds.max, corner);
    }
    middles.min = glm::min(middles.min, middleOf(triangle));
    middles.max = glm::max(middles.max, middleOf(triangle));
  }
  nodes_.push_back(node);
  if (last - first <= kLeafTriangles) {
    nodes_[id].first = first;
    nodes_[id].count = last - first;
    return id;
  }
  const Vec3 extent = middles.max - middles.min;
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : (extent.y >= extent.z ? 1 : 2);
  const std::uint32_t half = first + (last - first) / 2;
  std::nth_element(
      triangles_.begin() + first, triangles_.begin() + half, triangles_.begin() + last,
      [&](const Triangle& a, const Triangle& b) { return middleOf(a)[axis] < middleOf(b)[axis]; });
  const std::uint32_t left = build(first, half);
  const std::uint32_t right = build(half, last);
  nodes_[id].left = left;
  nodes_[id].right = right;
  return id;
}

float RayTree::nearestHit(const Vec3& origin, const Vec3& direction, float limit) const {
  if (nodes_.empty()) return limit;
  const Vec3 inverse = 1.0F / direction;
  float nearest = limit;
  // Halving keeps the tree at most 32 deep.
  std::array<std::uint32_t, 64> stack{};
  std::size_t depth = 1;
  while (depth > 0) {
    const Node& node = nodes_[stack[--depth]];
    if (entry(node.bounds, origin, inverse, nearest) >= nearest) continue;
    if (node.count == 0) {
      stack[depth++] = node.left;
      stack[depth++] = node.right;
      continue;
    }
    // Möller and Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, 1997.
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const Triangle& triangle = triangles_[i];
      const Vec3 across = glm::cross(direction, triangle.edge2);
      const float determinant = glm::dot(triangle.edge1, across);
      if (determinant == 0.0F) continue;
      const Vec3 offset = origin - triangle.corner;
      const float u = glm::dot(offset, across) / determinant;
      const Vec3 side = glm::cross(offset, triangle.edge1);
      const float v = glm::dot(direction, side) / determinant;
      if (u < 0.0F || v < 0.0F || u + v > 1.0F) continue;
      const float distance = glm::dot(triangle.edge2, side) / determinant;
      if (distance > 0.0F) nearest = std::min(nearest, distance);
    }
  }
  return nearest;
}

}  // namespace scatter::viewer
