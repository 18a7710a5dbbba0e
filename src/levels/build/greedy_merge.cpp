#include "levels/build/greedy_merge.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>

#include "levels/build/hull_gap.h"
#include "levels/build/thick_hull.h"

namespace scatter::levels {
namespace {

/// Weight of what a hull still lacks after the vertices it may have.
constexpr double kExcessWeight = 1.5;
/// Weight of size: small parts first where the gap is the same.
constexpr double kSizeWeight = 0.002;

/// Shares of the diagonal.
constexpr double kTrialTolerance = 3e-4;
constexpr double kTrialThickness = 1e-4;
constexpr double kTrialSpacing = 1.0 / 60.0;

/// With at most so many parts, all pairs are candidates.
constexpr std::size_t kAllPairs = 128;
constexpr std::size_t kNearest = 4;
constexpr std::size_t kFewNeighbours = 3;

/// Distance between boxes.
double boxDistance(const DoubleBounds& a, const DoubleBounds& b) {
  return glm::length(glm::max(glm::max(a.min - b.max, b.min - a.max), glm::dvec3(0.0)));
}

/// A part that is not merged yet.
struct Node {
  std::vector<glm::dvec3> hull;  ///< Corners, to within the tolerance.
  DoubleBounds bounds;
  glm::dvec3 middle{0.0};
  NodeIndex id = 0;  ///< In the tree.
  std::uint32_t version = 0;
  bool isAlive = true;

  /// What merging with another one costs at least.
  std::map<std::uint32_t, double> neighbours;

  void setHull(const std::vector<glm::dvec3>& vertices) {
    hull = vertices;
    bounds = {};
    middle = glm::dvec3(0.0);
    for (const glm::dvec3& point : hull) {
      bounds.add(point);
      middle += point / static_cast<double>(hull.size());
    }
  }
};

/// A pair of parts. Ordered by cost, then by number: the same everywhere.
struct MergeCandidate {
  double cost = 0.0;
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::uint32_t versionA = 0;
  std::uint32_t versionB = 0;
  bool isExact = false;  ///< Else `cost` is what it is at least.

  bool operator>(const MergeCandidate& other) const {
    return std::tie(cost, a, b) > std::tie(other.cost, other.a, other.b);
  }
};

class GreedyMerger {
 public:
  GreedyMerger(const WorkMesh& mesh, const DistanceGrid& grid, Patches patches, const MergeDef& definition)
      : grid_(grid), patches_(std::move(patches)), definition_(definition), diagonal_(mesh.diagonal) {
    const auto count = static_cast<std::uint32_t>(patches_.clusters.size());
    nodes_.resize(count);
    alive_.resize(count);
    std::iota(alive_.begin(), alive_.end(), 0U);
    for (std::uint32_t i = 0; i < count; ++i) {
      nodes_[i].id = i;
      buildHull(cornersOf(mesh, patches_.clusters[i]));
      nodes_[i].setHull(hull_.vertices);
    }
    for (std::uint32_t i = 0; i < count; ++i) {
      for (const std::uint32_t other : patches_.neighbours[i]) link(i, other);
    }
    for (std::uint32_t i = 0; i < count; ++i) linkNearest(i);
  }

  MergeTree run() {
    const auto total = static_cast<double>(nodes_.size());
    std::vector<MergeTree::Merge> merges;
    bool hasAllPairs = false;
    while (alive_.size() > 1) {
      if (!hasAllPairs && (alive_.size() <= kAllPairs || queue_.empty())) {
        hasAllPairs = true;
        linkAll();
      }
      MergeCandidate best = queue_.top();
      queue_.pop();
      if (!isCurrent(best.a, best.versionA) || !isCurrent(best.b, best.versionB)) continue;
      if (!best.isExact) {
        best.cost = costOf(best.a, best.b);
        best.isExact = true;
        nodes_[best.a].neighbours[best.b] = best.cost;
        nodes_[best.b].neighbours[best.a] = best.cost;
        queue_.push(best);
        continue;
      }
      merges.push_back({nodes_[best.a].id, nodes_[best.b].id});
      merge(best.a, best.b);
      nodes_[best.a].id = static_cast<NodeIndex>(nodes_.size() + merges.size() - 1);
      if (!hasAllPairs && nodes_[best.a].neighbours.size() < kFewNeighbours) linkNearest(best.a);
      if (definition_.progress) definition_.progress(1.0 - static_cast<double>(alive_.size()) / total);
    }
    return {std::move(patches_.clusters), std::move(merges)};
  }

 private:
  static std::vector<glm::dvec3> cornersOf(const WorkMesh& mesh, const Cluster& cluster) {
    std::vector<std::uint32_t> indices;
    for (const std::uint32_t triangle : cluster) {
      indices.insert(indices.end(), mesh.triangles[triangle].begin(), mesh.triangles[triangle].end());
    }
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    std::vector<glm::dvec3> points;
    points.reserve(indices.size());
    for (const std::uint32_t i : indices) points.push_back(mesh.vertices[i]);
    return points;
  }

  [[nodiscard]] bool isCurrent(std::uint32_t node, std::uint32_t version) const {
    return nodes_[node].isAlive && nodes_[node].version == version;
  }

  void buildHull(const std::vector<glm::dvec3>& points) {
    const HullDef definition{kTrialTolerance * diagonal_, kTrialThickness * diagonal_,
                             definition_.maxVertices};
    buildThickHull(builder_, points, definition, hull_);
  }

  void buildCommonHull(std::uint32_t a, std::uint32_t b) {
    both_ = nodes_[a].hull;
    both_.insert(both_.end(), nodes_[b].hull.begin(), nodes_[b].hull.end());
    buildHull(both_);
  }

  /// The gap of the common hull as it will be once it has few vertices, and a little for its size.
  double costOf(std::uint32_t a, std::uint32_t b) {
    buildCommonHull(a, b);
    const auto valueAt = [this](const glm::dvec3& point) { return grid_.value(point); };
    return largestGap(hull_, kTrialSpacing * diagonal_, valueAt) + kExcessWeight * hull_.excess +
           kSizeWeight * glm::length(hull_.bounds.max - hull_.bounds.min);
  }

  void push(std::uint32_t a, std::uint32_t b, double atLeast) {
    queue_.push({atLeast, std::min(a, b), std::max(a, b), nodes_[std::min(a, b)].version,
                 nodes_[std::max(a, b)].version, false});
  }

  void link(std::uint32_t a, std::uint32_t b) {
    if (!nodes_[a].neighbours.emplace(b, 0.0).second) return;
    nodes_[b].neighbours.emplace(a, 0.0);
    push(a, b, 0.0);
  }

  /// Merges `b` into `a`. A hull that grows moves away from the mesh: what the parts cost together with
  /// others is about the least that the merged part will.
  void merge(std::uint32_t a, std::uint32_t b) {
    buildCommonHull(a, b);
    Node& into = nodes_[a];
    Node& from = nodes_[b];
    into.setHull(hull_.vertices);
    ++into.version;
    from.isAlive = false;
    alive_.erase(std::lower_bound(alive_.begin(), alive_.end(), b));
    into.neighbours.erase(b);
    for (const auto& [other, cost] : from.neighbours) {
      if (other == a) continue;
      nodes_[other].neighbours.erase(b);
      double& known = into.neighbours.emplace(other, 0.0).first->second;
      known = std::max(known, cost);
    }
    from.neighbours.clear();
    from.hull.clear();
    for (const auto& [other, cost] : into.neighbours) {
      nodes_[other].neighbours[a] = cost;
      push(a, other, cost);
    }
  }

  void linkNearest(std::uint32_t node) {
    std::vector<std::pair<double, std::uint32_t>> others;
    for (const std::uint32_t i : alive_) {
      if (i == node) continue;
      const double apart = boxDistance(nodes_[node].bounds, nodes_[i].bounds);
      others.emplace_back(apart + 0.3 * glm::length(nodes_[node].middle - nodes_[i].middle), i);
    }
    const auto last = others.begin() + static_cast<std::ptrdiff_t>(std::min(kNearest, others.size()));
    std::partial_sort(others.begin(), last, others.end());
    for (auto it = others.begin(); it != last; ++it) link(node, it->second);
  }

  void linkAll() {
    for (auto a = alive_.begin(); a != alive_.end(); ++a) {
      for (auto b = a + 1; b != alive_.end(); ++b) link(*a, *b);
    }
  }

  const DistanceGrid& grid_;
  Patches patches_;
  const MergeDef& definition_;
  double diagonal_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> alive_;  ///< Nodes that are not merged into another, in order.
  std::priority_queue<MergeCandidate, std::vector<MergeCandidate>, std::greater<>> queue_;
  HullBuilder builder_;
  TriangleHull hull_;
  std::vector<glm::dvec3> both_;
};

}  // namespace

MergeTree mergeGreedily(const WorkMesh& mesh, const DistanceGrid& grid, Patches patches,
                        const MergeDef& definition) {
  return GreedyMerger(mesh, grid, std::move(patches), definition).run();
}

}  // namespace scatter::levels
