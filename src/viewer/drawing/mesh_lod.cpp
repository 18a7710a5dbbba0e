#include "viewer/drawing/mesh_lod.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

namespace scatter::viewer {

namespace {

constexpr float kCellsAcross[] = {48.0F, 32.0F, 22.0F, 15.0F, 10.0F, 7.0F};

/// A coarser version must have fewer triangles than this share of the one before.
constexpr double kWorthwhile = 0.7;

using Cell = std::tuple<int, int, int>;

/// Which of the six axis directions a normal is nearest to.
int sideOf(const Vec3& normal) {
  const Vec3 size = glm::abs(normal);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  return 2 * axis + (normal[axis] < 0.0F ? 1 : 0);
}

/// Sums over the vertices that become one.
struct Cluster {
  std::uint32_t cell = 0;
  Vec3 normal{0.0F};
  glm::vec3 color{0.0F};
  float occlusion = 0.0F;
  float count = 0.0F;
};

struct CellSum {
  Vec3 position{0.0F};
  float count = 0.0F;
};

class Clustering {
 public:
  Clustering(const MeshData& mesh, float size) : mesh_(mesh), size_(size) {
    clusterOf_.reserve(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) clusterOf_.push_back(add(i));
  }

  /// How far the surface has moved: the distances of the mesh's vertices from where they went, across the
  /// surface there, as a root mean square, doubled. Moves along the surface are not seen.
  [[nodiscard]] float error() const {
    float sum = 0.0F;
    for (std::size_t i = 0; i < mesh_.positions.size(); ++i) {
      const CellSum& cell = cells_[clusters_[clusterOf_[i]].cell];
      const float across = glm::dot(mesh_.normals[i], mesh_.positions[i] - cell.position / cell.count);
      sum += across * across;
    }
    return 2.0F * std::sqrt(sum / static_cast<float>(std::max<std::size_t>(1, mesh_.positions.size())));
  }

  [[nodiscard]] MeshData result() const {
    MeshData coarse;
    coarse.twoSided = mesh_.twoSided;
    for (const Cluster& cluster : clusters_) {
      const CellSum& cell = cells_[cluster.cell];
      coarse.positions.push_back(cell.position / cell.count);
      const float length = glm::length(cluster.normal);
      coarse.normals.push_back(length > 1e-6F ? cluster.normal / length : Vec3(0.0F, 1.0F, 0.0F));
      if (!mesh_.colors.empty()) coarse.colors.push_back(cluster.color / cluster.count);
      if (!mesh_.occlusion.empty()) coarse.occlusion.push_back(cluster.occlusion / cluster.count);
    }
    for (std::size_t i = 0; i + 2 < mesh_.indices.size(); i += 3) addTriangle(i, coarse.indices);
    return coarse;
  }

 private:
  std::uint32_t add(std::size_t vertex) {
    const Vec3 at = glm::floor(mesh_.positions[vertex] / size_);
    const Cell key{static_cast<int>(at.x), static_cast<int>(at.y), static_cast<int>(at.z)};
    const auto cell = static_cast<std::uint32_t>(cellIds_.try_emplace(key, cells_.size()).first->second);
    if (cell == cells_.size()) cells_.emplace_back();
    cells_[cell].position += mesh_.positions[vertex];
    cells_[cell].count += 1.0F;

    const Vec3& normal = mesh_.normals[vertex];
    const auto id = static_cast<std::uint32_t>(
        clusterIds_.try_emplace({cell, sideOf(normal)}, clusters_.size()).first->second);
    if (id == clusters_.size()) clusters_.emplace_back();
    Cluster& cluster = clusters_[id];
    cluster.cell = cell;
    cluster.normal += normal;
    if (!mesh_.colors.empty()) cluster.color += mesh_.colors[vertex];
    if (!mesh_.occlusion.empty()) cluster.occlusion += mesh_.occlusion[vertex];
    cluster.count += 1.0F;
    return id;
  }

  void addTriangle(std::size_t first, std::vector<std::uint32_t>& indices) const {
    const std::uint32_t corners[] = {clusterOf_[mesh_.indices[first]], clusterOf_[mesh_.indices[first + 1]],
                                     clusterOf_[mesh_.indices[first + 2]]};
    const std::uint32_t a = clusters_[corners[0]].cell;
    const std::uint32_t b = clusters_[corners[1]].cell;
    const std::uint32_t c = clusters_[corners[2]].cell;
    if (a != b && b != c && c != a) indices.insert(indices.end(), std::begin(corners), std::end(corners));
  }

  const MeshData& mesh_;
  float size_;
  std::map<Cell, std::size_t> cellIds_;
  std::map<std::pair<std::uint32_t, int>, std::size_t> clusterIds_;
  std::vector<CellSum> cells_;
  std::vector<Cluster> clusters_;
  std::vector<std::uint32_t> clusterOf_;
};

Bounds boundsOf(const MeshData& mesh) {
  if (mesh.positions.empty()) return {};
  Bounds bounds{mesh.positions.front(), mesh.positions.front()};
  for (const Vec3& position : mesh.positions) {
    bounds.min = glm::min(bounds.min, position);
    bounds.max = glm::max(bounds.max, position);
  }
  return bounds;
}

}  // namespace

MeshDetail clusterVertices(const MeshData& mesh, float cell) {
  assert(cell > 0.0F && mesh.normals.size() == mesh.positions.size());
  const Clustering clustering(mesh, cell);
  return {clustering.result(), clustering.error()};
}

std::vector<MeshDetail> makeDetails(const MeshData& mesh) {
  std::vector<MeshDetail> details;
  details.push_back({mesh, 0.0F});
  const Bounds bounds = boundsOf(mesh);
  const float diagonal = glm::length(bounds.max - bounds.min);
  if (!(diagonal > 0.0F)) return details;
  for (const float across : kCellsAcross) {
    MeshDetail coarse = clusterVertices(mesh, diagonal / across);
    const auto before = static_cast<double>(details.back().mesh.indices.size());
    const auto after = static_cast<double>(coarse.mesh.indices.size());
    if (after > 0.0 && after <= kWorthwhile * before) details.push_back(std::move(coarse));
  }
  return details;
}

MeshOutline outlineOf(const std::vector<MeshDetail>& details) {
  MeshOutline outline;
  const MeshData& finest = details.front().mesh;
  const Bounds bounds = boundsOf(finest);
  outline.center = 0.5F * (bounds.min + bounds.max);
  for (const Vec3& position : finest.positions)
    outline.radius = std::max(outline.radius, glm::distance(outline.center, position));
  for (const MeshDetail& detail : details) {
    outline.errors.push_back(detail.error);
    outline.triangles.push_back(detail.mesh.indices.size() / 3);
    outline.shadows.push_back({detail.mesh.positions, detail.mesh.indices, detail.mesh.twoSided});
  }
  return outline;
}

}  // namespace scatter::viewer
