#include "levels/build/pre_merge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>

#include "levels/mesh/triangle.h"

namespace scatter::levels {
namespace {

/// How much bending counts beside size.
constexpr double kBending = 8.0;

/// Cells along the diagonal for meshes with too many triangles.
constexpr double kCells = 192.0;

/// Cells along the diagonal for finding what is nearby; a power of two.
constexpr std::uint32_t kCurveCells = 1024;
constexpr std::size_t kCurveNeighbours = 3;

using Pair = std::array<std::uint32_t, 2>;

/// Area moments of a set of triangles.
struct Spread {
  double area = 0.0;
  glm::dvec3 first{0.0};   ///< Area times centre.
  glm::dvec3 normal{0.0};  ///< Sum of area vectors.
  double second = 0.0;     ///< Integral of the squared place.

  void add(const Spread& other) {
    area += other.area;
    first += other.first;
    normal += other.normal;
    second += other.second;
  }

  /// The integral of the squared distance from the centre, more where normals differ.
  [[nodiscard]] double cost() const {
    const double variance = std::max(0.0, second - glm::dot(first, first) / area);
    const double flatness = std::min(1.0, glm::length(normal) / area);
    return variance * (1.0 + kBending * (1.0 - flatness));
  }
};

Spread spreadOf(const WorkMesh& mesh, std::uint32_t triangle) {
  const Triangle& t = mesh.triangles[triangle];
  const glm::dvec3& a = mesh.vertices[t[0]];
  const glm::dvec3& b = mesh.vertices[t[1]];
  const glm::dvec3& c = mesh.vertices[t[2]];
  Spread spread;
  spread.normal = areaVector(a, b, c);
  spread.area = std::max(glm::length(spread.normal), 1e-12 * mesh.diagonal * mesh.diagonal);
  const glm::dvec3 center = (a + b + c) / 3.0;
  spread.first = spread.area * center;
  const double corners = glm::dot(a, a) + glm::dot(b, b) + glm::dot(c, c);
  spread.second = spread.area * (corners + 9.0 * glm::dot(center, center)) / 12.0;
  return spread;
}

/// Triangles of one cell, facing and keeper, at most one triangle each if `isGrouped` is false.
std::vector<Cluster> groupTriangles(const WorkMesh& mesh, const TriangleRegions& regions, bool isGrouped) {
  std::vector<Cluster> groups;
  if (!isGrouped) {
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) groups.push_back({i});
    return groups;
  }
  std::vector<std::pair<std::array<int, 5>, std::uint32_t>> keys;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const Spread spread = spreadOf(mesh, i);
    const glm::dvec3 center = spread.first / spread.area;
    const glm::ivec3 cell((center - mesh.bounds.min) * (kCells / mesh.diagonal));
    const glm::dvec3 size = glm::abs(spread.normal);
    const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const int facing = 2 * axis + (spread.normal[axis] < 0.0 ? 1 : 0);
    keys.push_back({{cell.x, cell.y, cell.z, facing, static_cast<int>(regions.keeperOf(i))}, i});
  }
  std::sort(keys.begin(), keys.end());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (i == 0 || keys[i].first != keys[i - 1].first) groups.emplace_back();
    groups.back().push_back(keys[i].second);
  }
  return groups;
}

double largestWeight(const Cluster& cluster, const TriangleRegions& regions) {
  double largest = 0.0;
  for (const std::uint32_t triangle : cluster) largest = std::max(largest, regions.weightOf(triangle));
  return largest;
}

/// Pairs of groups that share an edge.
std::vector<Pair> sharedEdges(const WorkMesh& mesh, const std::vector<Cluster>& groups) {
  std::vector<std::array<std::uint32_t, 3>> edges;
  for (std::uint32_t g = 0; g < groups.size(); ++g) {
    for (const std::uint32_t i : groups[g]) {
      const Triangle& t = mesh.triangles[i];
      for (std::size_t k = 0; k < 3; ++k) {
        edges.push_back({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3]), g});
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Pair> pairs;
  // Linking each to the next is enough, and keeps an edge of many triangles from having many pairs.
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const auto& [low, high, group] = edges[i - 1];
    if (edges[i][0] == low && edges[i][1] == high && edges[i][2] != group)
      pairs.push_back({group, edges[i][2]});
  }
  return pairs;
}

void insertSorted(std::vector<std::uint32_t>& list, std::uint32_t value) {
  const auto place = std::lower_bound(list.begin(), list.end(), value);
  if (place == list.end() || *place != value) list.insert(place, value);
}

void eraseSorted(std::vector<std::uint32_t>& list, std::uint32_t value) {
  const auto place = std::lower_bound(list.begin(), list.end(), value);
  if (place != list.end() && *place == value) list.erase(place);
}

/// A place on the Morton curve: what is near on it is near in space.
std::uint64_t mortonCode(const glm::uvec3& cell) {
  std::uint64_t code = 0;
  for (unsigned bit = 0; (kCurveCells >> bit) > 0; ++bit) {
    for (int axis = 0; axis < 3; ++axis) {
      code |= static_cast<std::uint64_t>((cell[axis] >> bit) & 1U)
              << (3U * bit + static_cast<unsigned>(axis));
    }
  }
  return code;
}

class PreMerger {
 public:
  PreMerger(const WorkMesh& mesh, const TriangleRegions& regions, std::vector<Cluster> groups)
      : mesh_(mesh), members_(std::move(groups)) {
    const std::size_t count = members_.size();
    alive_ = count;
    spreads_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      for (const std::uint32_t triangle : members_[i]) spreads_[i].add(spreadOf(mesh, triangle));
      weights_.push_back(largestWeight(members_[i], regions));
      keepers_.push_back(regions.keeperOf(members_[i].front()));
    }
    neighbours_.resize(count);
    versions_.assign(count, 0);
    isAlive_.assign(count, true);
    for (const Pair& pair : sharedEdges(mesh, members_)) link(pair[0], pair[1]);
  }

  void mergeTo(std::size_t target) {
    if (alive_ <= target) return;
    for (std::uint32_t i = 0; i < members_.size(); ++i) pushAll(i, i);
    while (alive_ > target) {
      if (queue_.empty()) linkNearby();
      if (queue_.empty()) return;  // All that is left has keepers of its own.
      const Candidate best = queue_.top();
      queue_.pop();
      const auto& [cost, a, b, versionA, versionB] = best;
      if (!isAlive_[a] || !isAlive_[b] || versions_[a] != versionA || versions_[b] != versionB) continue;
      if (members_[a].size() >= members_[b].size()) {
        merge(a, b);
      } else {
        merge(b, a);
      }
    }
  }

  Patches take() {
    Patches patches;
    std::vector<std::uint32_t> indices(members_.size(), 0);
    for (std::size_t i = 0; i < members_.size(); ++i) {
      if (!isAlive_[i]) continue;
      indices[i] = static_cast<std::uint32_t>(patches.clusters.size());
      patches.clusters.push_back(std::move(members_[i]));
      patches.neighbours.push_back(std::move(neighbours_[i]));
    }
    for (auto& list : patches.neighbours) {
      for (std::uint32_t& neighbour : list) neighbour = indices[neighbour];
    }
    return patches;
  }

 private:
  /// Cost, then the two clusters and their versions: a total order, the same everywhere.
  using Candidate = std::tuple<double, std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;

  void link(std::uint32_t a, std::uint32_t b) {
    // What may not merge are neighbours nevertheless, for later.
    insertSorted(neighbours_[a], b);
    insertSorted(neighbours_[b], a);
  }

  void push(std::uint32_t a, std::uint32_t b) {
    if (keepers_[a] != keepers_[b]) return;
    Spread both = spreads_[a];
    both.add(spreads_[b]);
    // Gaps grow as the square of sizes, and this as the fourth power.
    const double weight = std::max(weights_[a], weights_[b]);
    queue_.emplace(weight * weight * both.cost(), a, b, versions_[a], versions_[b]);
  }

  /// Offers `a` together with its neighbours above `above`.
  void pushAll(std::uint32_t a, std::uint32_t above) {
    const auto& list = neighbours_[a];
    for (auto it = std::upper_bound(list.begin(), list.end(), above); it != list.end(); ++it) push(a, *it);
  }

  void merge(std::uint32_t into, std::uint32_t from) {
    spreads_[into].add(spreads_[from]);
    weights_[into] = std::max(weights_[into], weights_[from]);
    members_[into].insert(members_[into].end(), members_[from].begin(), members_[from].end());
    members_[from] = {};
    isAlive_[from] = false;
    ++versions_[into];
    --alive_;
    for (const std::uint32_t other : neighbours_[from]) {
      eraseSorted(neighbours_[other], from);
      if (other != into) link(into, other);
    }
    neighbours_[from] = {};
    for (const std::uint32_t other : neighbours_[into]) push(into, other);
  }

  /// Links each cluster to the next ones of its keeper along a curve through space.
  void linkNearby() {
    std::vector<std::tuple<std::uint32_t, std::uint64_t, std::uint32_t>> order;
    for (std::uint32_t i = 0; i < members_.size(); ++i) {
      if (!isAlive_[i]) continue;
      const glm::dvec3 center = spreads_[i].first / spreads_[i].area - mesh_.bounds.min;
      const glm::dvec3 cell = center * ((kCurveCells - 1) / mesh_.diagonal);
      order.emplace_back(keepers_[i], mortonCode(glm::uvec3(glm::max(cell, glm::dvec3(0.0)))), i);
    }
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (std::size_t j = i + 1; j < std::min(order.size(), i + 1 + kCurveNeighbours); ++j) {
        const std::uint32_t a = std::get<2>(order[i]);
        const std::uint32_t b = std::get<2>(order[j]);
        if (keepers_[a] != keepers_[b]) break;
        link(a, b);
        push(a, b);
      }
    }
  }

  const WorkMesh& mesh_;
  std::vector<Cluster> members_;
  std::vector<Spread> spreads_;
  std::vector<double> weights_;
  std::vector<std::uint32_t> keepers_;
  std::vector<std::vector<std::uint32_t>> neighbours_;
  std::vector<std::uint32_t> versions_;
  std::vector<bool> isAlive_;
  std::size_t alive_ = 0;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;
};

}  // namespace

Patches preMerge(const WorkMesh& mesh, const TriangleRegions& regions, std::size_t count,
                 std::size_t maxTriangles) {
  const bool isGrouped = mesh.triangles.size() > maxTriangles;
  PreMerger merger(mesh, regions, groupTriangles(mesh, regions, isGrouped));
  merger.mergeTo(std::max<std::size_t>(1, count));
  Patches patches = merger.take();
  patches.isGrouped = isGrouped;
  return patches;
}

}  // namespace scatter::levels
