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

/// Nodes that are to be looked at for what is nearest to a point, the next one last.
class MeshTree::Visits {
 public:
  Visits(const MeshTree& tree, const glm::dvec3& point) : tree_(tree), point_(point) {
    visits_[depth_++] = {squaredDistance(tree.nodes_.front().bounds, point), 0};
  }

  /// The next node whose bounds are nearer than the square root of `best`; null if there is none.
  const Node* next(double best) {
    while (depth_ > 0) {
      const Visit& visit = visits_[--depth_];
      if (visit.nearest < best) return &tree_.nodes_[visit.node];
    }
    return nullptr;
  }

  /// The nearer one comes first.
  void addChildren(const Node& node) {
    const Visit left{squaredDistance(tree_.nodes_[node.left].bounds, point_), node.left};
    const Visit right{squaredDistance(tree_.nodes_[node.left + 1].bounds, point_), node.left + 1};
    const bool isLeftNearer = left.nearest < right.nearest;
    visits_[depth_++] = isLeftNearer ? right : left;
    visits_[depth_++] = isLeftNearer ? left : right;
  }

 private:
  struct Visit {
    double nearest = 0.0;  ///< Squared.
    std::uint32_t node = 0;
  };

  const MeshTree& tree_;
  const glm::dvec3& point_;
  std::array<Visit, kStackSize> visits_;
  std::size_t depth_ = 0;
};

MeshTree::MeshTree(const WorkMesh& mesh) {
  corners_.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    corners_.push_back({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
  }
  nodes_.reserve(mesh.triangles.size());
  sums_.reserve(mesh.triangles.size());
  nodes_.emplace_back();
  sums_.emplace_back();
  build(0, 0, corners_.size());
}

void MeshTree::build(std::uint32_t index, std::size_t first, std::size_t last) {
  nodes_[index].first = static_cast<std::uint32_t>(first);
  nodes_[index].count = static_cast<std::uint32_t>(last - first);
  summarise(index);
  if (last - first <= kLeafSize) return;

  DoubleBounds middles;
  for (std::size_t i = first; i < last; ++i) middles.add(corners_[i][0] + corners_[i][1] + corners_[i][2]);
  const glm::dvec3 size = middles.max - middles.min;
  const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  const std::size_t half = (first + last) / 2;
  const auto at = [this](std::size_t i) { return corners_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(half), at(last), [axis](const Corners& a, const Corners& b) {
    return a[0][axis] + a[1][axis] + a[2][axis] < b[0][axis] + b[1][axis] + b[2][axis];
  });
  const auto left = static_cast<std::uint32_t>(nodes_.size());
  nodes_[index].left = left;
  nodes_.resize(nodes_.size() + 2);
  sums_.resize(nodes_.size());
  build(left, first, half);
  build(left + 1, half, last);
}

void MeshTree::summarise(std::uint32_t index) {
  Node& node = nodes_[index];
  Sum& sum = sums_[index];
  double total = 0.0;
  glm::dvec3 plain{0.0};
  for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
    const Corners& c = corners_[i];
    for (const glm::dvec3& corner : c) node.bounds.add(corner);
    const glm::dvec3 vector = areaVector(c[0], c[1], c[2]);
    const glm::dvec3 middle = (c[0] + c[1] + c[2]) / 3.0;
    sum.area += vector;
    sum.center += glm::length(vector) * middle;
    plain += middle;
    total += glm::length(vector);
  }
  sum.center = total > 0.0 ? sum.center / total : plain / static_cast<double>(node.count);
  const glm::dvec3 reach = glm::max(sum.center - node.bounds.min, node.bounds.max - sum.center);
  sum.radius = glm::length(reach);
}

/// Squared, or `best` if that is less.
double MeshTree::leafDistance(const Node& leaf, const glm::dvec3& point, double best) const {
  for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
    const Corners& c = corners_[i];
    const glm::dvec3 offset = closestPoint(point, c[0], c[1], c[2]) - point;
    best = std::min(best, glm::dot(offset, offset));
  }
  return best;
}

double MeshTree::distance(const glm::dvec3& point, double limit) const {
  double best = limit * limit;
  Visits visits(*this, point);
  while (const Node* node = visits.next(best)) {
    if (node->left == 0) {
      best = leafDistance(*node, point, best);
    } else {
      visits.addChildren(*node);
    }
  }
  return std::sqrt(best);
}

bool MeshTree::isWithin(const glm::dvec3& point, double reach) const {
  const double squared = reach * reach;
  Visits visits(*this, point);
  while (const Node* node = visits.next(squared)) {
    if (node->left != 0) {
      visits.addChildren(*node);
    } else if (leafDistance(*node, point, squared) < squared) {
      return true;
    }
  }
  return false;
}

double MeshTree::winding(const glm::dvec3& point) const {
  double angle = 0.0;
  std::array<std::uint32_t, kStackSize> stack{};
  std::size_t depth = 1;
  while (depth > 0) {
    const std::uint32_t index = stack[--depth];
    const Node& node = nodes_[index];
    const Sum& sum = sums_[index];
    const glm::dvec3 toCenter = sum.center - point;
    const double distance = glm::length(toCenter);
    if (distance > kFarRadii * sum.radius) {
      angle += glm::dot(sum.area, toCenter) / (distance * distance * distance);
    } else if (node.left == 0) {
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        angle += solidAngle(point, corners_[i][0], corners_[i][1], corners_[i][2]);
      }
    } else {
      stack[depth++] = node.left;
      stack[depth++] = node.left + 1;
    }
  }
  return angle / (4.0 * std::numbers::pi);
}

}  // namespace scatter::levels
