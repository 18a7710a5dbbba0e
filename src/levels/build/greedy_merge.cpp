#include "levels/build/greedy_merge.h"

#include <algorithm>
#include <cmath>
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
/// Weight of size. Long parts reach over others, whose bounds an engine then finds near each other: compact
/// ones halve the pairs of parts that plain Bullet looks at, and are as close to the mesh. With 0.002, 0.01,
/// 0.02, 0.04, 0.06, 0.08 and 0.16 it takes 1, 0.86, 0.83, 0.76, 0.77, 0.75 and 0.67 of the time, and gaps
/// are 1, 0.93, 0.98, 1.02, 1.05, 1.06 and 1.16 times as wide (64 parts; `scatter bench levels --piles` on
/// suzanne, cow, teapot, fandisk and homer).
constexpr double kSizeWeight = 0.04;
/// Weight of merging a part with its image, which saves one part where other merges save two, and makes wide
/// parts that overlap; found by trial.
constexpr double kClosingWeight = 4.0;

/// Shares of the diagonal.
constexpr double kTrialTolerance = 3e-4;
constexpr double kTrialThickness = 1e-4;
constexpr double kTrialSpacing = 1.0 / 60.0;

/// In diagonals, what merging over the border of a kept region costs: more than any gap in any other.
constexpr double kBorder = 1e6;

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
  NodeIndex id = 0;      ///< In the tree.
  NodeIndex image = 0;   ///< In a symmetric tree, the same if the part is symmetric.
  double closing = 0.0;  ///< What merging it with its image costs at least.
  std::uint32_t version = 0;
  std::uint32_t keeper = 0;
  double weight = 1.0;  ///< The largest of its triangles'.
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
  GreedyMerger(const WorkMesh& mesh, const DistanceGrid& grid, const TriangleRegions& regions,
               Patches patches, const MergeDef& definition)
      : grid_(grid),
        patches_(std::move(patches)),
        definition_(definition),
        symmetry_(definition.symmetry),
        diagonal_(mesh.diagonal) {
    const auto count = static_cast<std::uint32_t>(patches_.clusters.size());
    nodes_.resize(count);
    alive_.resize(count);
    std::iota(alive_.begin(), alive_.end(), 0U);
    for (std::uint32_t i = 0; i < count; ++i) {
      nodes_[i].id = i;
      setRegion(nodes_[i], patches_.clusters[i], regions);
      buildHull(cornersOf(mesh, patches_.clusters[i]));
      nodes_[i].setHull(hull_.vertices);
    }
    addImages();
    for (std::uint32_t i = 0; i < count; ++i) {
      for (const std::uint32_t other : patches_.neighbours[i]) link(i, other);
    }
    for (std::uint32_t i = 0; i < count; ++i) linkNearest(i);
  }

  MergeTree run() {
    const auto total = static_cast<double>(nodes_.size());
    while (alive_.size() > 1 || isPair(alive_.front())) {
      if (!hasAllPairs_ && (alive_.size() <= kAllPairs || queue_.empty())) {
        hasAllPairs_ = true;
        linkAll();
      }
      MergeCandidate best = queue_.top();
      queue_.pop();
      if (!isCurrent(best.a, best.versionA) || !isCurrent(best.b, best.versionB)) continue;
      if (!best.isExact) {
        best.cost = costOf(best.a, best.b);
        best.isExact = true;
        remember(best);
        queue_.push(best);
        continue;
      }
      buildCommonHull(best.a, best.b);
      growTree(nodes_[best.a], nodes_[best.b]);
      merge(best.a, best.b);
      if (!hasAllPairs_ && nodes_[best.a].neighbours.size() < kFewNeighbours) linkNearest(best.a);
      if (definition_.progress) definition_.progress(1.0 - static_cast<double>(alive_.size()) / total);
    }
    return {std::move(leaves_), std::move(merges_), std::move(images_)};
  }

 private:
  /// A part that is not symmetric in a symmetric tree stands for itself and its image.
  [[nodiscard]] bool isPair(std::uint32_t node) const {
    return symmetry_ != nullptr && nodes_[node].image != nodes_[node].id;
  }

  /// Leaves of the tree are the patches, and behind them the images of those that are not symmetric.
  void addImages() {
    leaves_ = patches_.clusters;
    if (symmetry_ == nullptr) return;
    for (Node& node : nodes_) {
      const Cluster& cluster = patches_.clusters[node.id];
      node.image = node.id;
      if (symmetry_->isAcross[cluster.front()]) continue;
      node.image = static_cast<NodeIndex>(leaves_.size());
      leaves_.push_back(symmetry_->imageOfAll(cluster));
    }
    images_.resize(leaves_.size());
    for (const Node& node : nodes_) {
      images_[node.id] = node.image;
      images_[node.image] = node.id;
    }
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
      if (isPair(i)) push(i, i, 0.0);
    }
  }

  NodeIndex addMerge(NodeIndex left, NodeIndex right, NodeIndex image) {
    const auto index = static_cast<NodeIndex>(leaves_.size() + merges_.size());
    merges_.push_back({left, right});
    if (symmetry_ != nullptr) images_.push_back(image);
    return index;
  }

  /// Merges `from`, and in a symmetric tree its image, into `into`; a part with itself means with its image.
  void growTree(Node& into, const Node& from) {
    if (symmetry_ == nullptr) {
      into.id = addMerge(into.id, from.id, 0);
      return;
    }
    const bool isIntoPair = into.image != into.id;
    const bool isFromPair = from.image != from.id;
    const auto next = static_cast<NodeIndex>(leaves_.size() + merges_.size());
    if (&into == &from) {
      into.id = addMerge(into.id, into.image, next);
    } else if (isIntoPair && isFromPair) {
      into.id = addMerge(into.id, from.id, next + 1);
      into.image = addMerge(into.image, from.image, next);
      return;
    } else if (isIntoPair || isFromPair) {
      const Node& pair = isIntoPair ? into : from;
      const NodeIndex half = addMerge(isIntoPair ? from.id : into.id, pair.id, MergeTree::kNoImage);
      into.id = addMerge(half, pair.image, next + 1);
    } else {
      into.id = addMerge(into.id, from.id, next);
    }
    into.image = into.id;
  }

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

  static void setRegion(Node& node, const Cluster& cluster, const TriangleRegions& regions) {
    node.keeper = regions.keeperOf(cluster.front());
    node.weight = 0.0;
    for (const std::uint32_t triangle : cluster)
      node.weight = std::max(node.weight, regions.weightOf(triangle));
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
    if (a != b) both_.insert(both_.end(), nodes_[b].hull.begin(), nodes_[b].hull.end());
    if (symmetry_ != nullptr && (a == b || isPair(a) != isPair(b))) {
      const std::size_t count = both_.size();
      for (std::size_t i = 0; i < count; ++i) both_.push_back(symmetry_->mirror(both_[i]));
    }
    buildHull(both_);
  }

  /// The gap of the common hull as it will be once it has few vertices, and a little for its size.
  double costOf(std::uint32_t a, std::uint32_t b) {
    buildCommonHull(a, b);
    const double weight = std::max(nodes_[a].weight, nodes_[b].weight);
    const double closing = a == b ? kClosingWeight : 1.0;
    return closing * (gapOf(hull_, weight) + kExcessWeight * weight * hull_.excess +
                      kSizeWeight * glm::length(hull_.bounds.max - hull_.bounds.min)) +
           borderCost(a, b);
  }

  /// Each place counts with its weight, of which `weight` is an idea.
  [[nodiscard]] double gapOf(const TriangleHull& hull, double weight) const {
    const double spacing = kTrialSpacing * diagonal_;
    if (!grid_.isWeighted()) {
      return largestGap(hull, spacing, [this](const glm::dvec3& point) { return grid_.value(point); });
    }
    const auto valueAt = [this](const glm::dvec3& point) { return grid_.weight(point) * grid_.value(point); };
    return largestGap(hull, spacing / std::sqrt(std::max(1.0, weight)), valueAt, 0.0, grid_.largestWeight());
  }

  [[nodiscard]] double borderCost(std::uint32_t a, std::uint32_t b) const {
    return nodes_[a].keeper == nodes_[b].keeper ? 0.0 : kBorder * diagonal_;
  }

  void push(std::uint32_t a, std::uint32_t b, double atLeast) {
    queue_.push({atLeast, std::min(a, b), std::max(a, b), nodes_[std::min(a, b)].version,
                 nodes_[std::max(a, b)].version, false});
  }

  void remember(const MergeCandidate& candidate) {
    const auto [cost, a, b, versionA, versionB, isExact] = candidate;
    if (a == b) {
      nodes_[a].closing = cost;
    } else {
      nodes_[a].neighbours[b] = cost;
      nodes_[b].neighbours[a] = cost;
    }
  }

  void link(std::uint32_t a, std::uint32_t b) {
    const double atLeast = borderCost(a, b);
    // Nothing is merged over a border until all pairs are known, nor then before the others.
    if (atLeast > 0.0 && !hasAllPairs_) return;
    if (!nodes_[a].neighbours.emplace(b, atLeast).second) return;
    nodes_[b].neighbours.emplace(a, atLeast);
    push(a, b, atLeast);
  }

  /// Merges `b`, or the image of `a` if that is `b`, into `a`, whose hull is then hull_. A hull that grows
  /// moves away from the mesh: what the parts cost together with others is about the least that the merged
  /// part will.
  void merge(std::uint32_t a, std::uint32_t b) {
    Node& into = nodes_[a];
    into.setHull(hull_.vertices);
    ++into.version;
    if (a != b) absorb(into, a, b);
    for (const auto& [other, cost] : into.neighbours) {
      nodes_[other].neighbours[a] = cost;
      push(a, other, cost);
    }
    if (isPair(a)) push(a, a, into.closing);
  }

  void absorb(Node& into, std::uint32_t a, std::uint32_t b) {
    Node& from = nodes_[b];
    into.weight = std::max(into.weight, from.weight);
    into.keeper = std::max(into.keeper, from.keeper);
    into.closing = std::max(into.closing, from.closing);
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
  }

  void linkNearest(std::uint32_t node) {
    std::vector<std::pair<double, std::uint32_t>> others;
    for (const std::uint32_t i : alive_) {
      if (i == node || nodes_[i].keeper != nodes_[node].keeper) continue;
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
  const SymmetricMesh* symmetry_;
  double diagonal_;
  std::vector<Cluster> leaves_;
  std::vector<MergeTree::Merge> merges_;
  std::vector<NodeIndex> images_;
  std::vector<Node> nodes_;
  bool hasAllPairs_ = false;
  std::vector<std::uint32_t> alive_;  ///< Nodes that are not merged into another, in order.
  std::priority_queue<MergeCandidate, std::vector<MergeCandidate>, std::greater<>> queue_;
  HullBuilder builder_;
  TriangleHull hull_;
  std::vector<glm::dvec3> both_;
};

}  // namespace

MergeTree mergeGreedily(const WorkMesh& mesh, const DistanceGrid& grid, const TriangleRegions& regions,
                        Patches patches, const MergeDef& definition) {
  return GreedyMerger(mesh, grid, regions, std::move(patches), definition).run();
}

}  // namespace scatter::levels
