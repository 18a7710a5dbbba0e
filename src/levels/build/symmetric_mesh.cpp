#include "levels/build/symmetric_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "levels/mesh/mesh_tree.h"

namespace scatter::levels {
namespace {

constexpr std::uint32_t kNoVertex = ~std::uint32_t{0};

/// Whether the images of corners lie on the mesh, and those of middles of edges and triangles nearly so.
bool isSymmetricAbout(const WorkMesh& mesh, const MeshTree& tree, const MirrorPlane& plane) {
  const auto isNear = [&](glm::dvec3 point, double share) {
    point[plane.axis] = 2.0 * plane.offset - point[plane.axis];
    const double tolerance = share * mesh.diagonal;
    return tree.distance(point, 2.0 * tolerance) <= tolerance;
  };
  if (!std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                   [&](const glm::dvec3& vertex) { return isNear(vertex, kSymmetryTolerance); }))
    return false;
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
    const glm::dvec3& a = mesh.vertices[t[0]];
    const glm::dvec3& b = mesh.vertices[t[1]];
    const glm::dvec3& c = mesh.vertices[t[2]];
    const std::array<glm::dvec3, 4> middles{(a + b + c) / 3.0, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)};
    return std::all_of(middles.begin(), middles.end(),
                       [&](const glm::dvec3& middle) { return isNear(middle, kBulgeTolerance); });
  });
}

/// Finds points near others by cells of the size of what counts as near.
class NearPoints {
 public:
  explicit NearPoints(double distance) : distance_(distance) {}

  void add(std::uint32_t index, const glm::dvec3& point) { cells_[cellOf(point)].emplace_back(index, point); }

  /// The nearest one, which is taken away; kNoVertex if none is near.
  std::uint32_t take(const glm::dvec3& point) {
    Cell* from = nullptr;
    std::size_t best = 0;
    double least = distance_;
    const Key middle = cellOf(point);
    for (int i = 0; i < 27; ++i) {
      const auto found =
          cells_.find({middle[0] + i % 3 - 1, middle[1] + i / 3 % 3 - 1, middle[2] + i / 9 - 1});
      if (found == cells_.end()) continue;
      for (std::size_t k = 0; k < found->second.size(); ++k) {
        const double apart = glm::length(found->second[k].second - point);
        if (apart > least || (apart == least && from != nullptr)) continue;
        least = apart;
        from = &found->second;
        best = k;
      }
    }
    if (from == nullptr) return kNoVertex;
    const std::uint32_t index = (*from)[best].first;
    from->erase(from->begin() + static_cast<std::ptrdiff_t>(best));
    return index;
  }

 private:
  using Key = std::array<std::int64_t, 3>;
  using Cell = std::vector<std::pair<std::uint32_t, glm::dvec3>>;

  [[nodiscard]] Key cellOf(const glm::dvec3& point) const {
    const glm::dvec3 cell = glm::floor(point / distance_);
    return {static_cast<std::int64_t>(cell.x), static_cast<std::int64_t>(cell.y),
            static_cast<std::int64_t>(cell.z)};
  }

  double distance_;
  std::map<Key, Cell> cells_;
};

class Symmetriser {
 public:
  Symmetriser(const WorkMesh& mesh, const Mirror& mirror) : tolerance_(kSymmetryTolerance * mesh.diagonal) {
    result_.mirror = mirror;
    result_.mesh = mesh;
    result_.places.resize(mesh.vertices.size());
    images_.assign(mesh.vertices.size(), kNoVertex);
  }

  SymmetricMesh run() {
    pairVertices();
    addImagesOfVertices();
    addImagesOfTriangles();
    for (const Triangle& triangle : result_.mesh.triangles) result_.isAcross.push_back(isAcross(triangle));
    return std::move(result_);
  }

 private:
  void pairVertices() {
    std::vector<glm::dvec3>& vertices = result_.mesh.vertices;
    const Mirror& mirror = result_.mirror;
    NearPoints before(tolerance_);
    for (std::uint32_t i = 0; i < vertices.size(); ++i) {
      if (vertices[i][mirror.axis] > tolerance_) before.add(i, vertices[i]);
    }
    for (std::uint32_t i = 0; i < vertices.size(); ++i) {
      glm::dvec3& vertex = vertices[i];
      if (vertex[mirror.axis] > tolerance_) continue;
      if (vertex[mirror.axis] >= -tolerance_) {
        images_[i] = i;
        place(i, vertex, mirror(vertex));
        vertex = mirror.flattened(vertex);
        continue;
      }
      const std::uint32_t partner = before.take(mirror(vertex));
      if (partner == kNoVertex) continue;
      images_[i] = partner;
      images_[partner] = i;
      place(i, vertex, mirror(vertices[partner]));
      place(partner, vertices[partner], mirror(vertex));
      vertex = mirror(vertices[partner]);
    }
  }

  void place(std::uint32_t index, const glm::dvec3& own, const glm::dvec3& other) {
    result_.places[index] = {own};
    if (other != own) result_.places[index].push_back(other);
  }

  void addImagesOfVertices() {
    const std::size_t count = images_.size();
    for (std::uint32_t i = 0; i < count; ++i) {
      if (images_[i] != kNoVertex) continue;
      const glm::dvec3 image = result_.mirror(result_.mesh.vertices[i]);
      images_[i] = static_cast<std::uint32_t>(images_.size());
      images_.push_back(i);
      result_.places[i] = {result_.mesh.vertices[i]};
      result_.places.push_back({image});
      result_.mesh.vertices.push_back(image);
    }
  }

  void addImagesOfTriangles() {
    std::vector<Triangle>& triangles = result_.mesh.triangles;
    const auto keyOf = [](Triangle triangle) {
      std::sort(triangle.begin(), triangle.end());
      return triangle;
    };
    std::map<Triangle, std::uint32_t> known;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) known.emplace(keyOf(triangles[i]), i);
    result_.imageOf.resize(triangles.size());
    const std::size_t count = triangles.size();
    for (std::uint32_t i = 0; i < count; ++i) {
      const Triangle& t = triangles[i];
      const Triangle image{images_[t[0]], images_[t[2]], images_[t[1]]};
      const auto [found, isNew] = known.emplace(keyOf(image), static_cast<std::uint32_t>(triangles.size()));
      result_.imageOf[i] = found->second;
      if (!isNew) continue;
      triangles.push_back(image);
      result_.imageOf.push_back(i);
    }
  }

  [[nodiscard]] bool isAcross(const Triangle& triangle) const {
    bool isBefore = false;
    bool isBehind = false;
    for (const std::uint32_t vertex : triangle) {
      const double place = result_.mesh.vertices[vertex][result_.mirror.axis];
      isBefore = isBefore || place > 0.0;
      isBehind = isBehind || place < 0.0;
    }
    return isBefore == isBehind;
  }

  double tolerance_;
  SymmetricMesh result_;
  std::vector<std::uint32_t> images_;  ///< Of vertices.
};

}  // namespace

std::optional<MirrorPlane> findMirrorPlane(const WorkMesh& mesh) {
  const double tolerance = kSymmetryTolerance * mesh.diagonal;
  const MeshTree tree(mesh);
  for (const int axis : {0, 2, 1}) {
    const double middle = 0.5 * (mesh.bounds.min[axis] + mesh.bounds.max[axis]);
    const double zero = -static_cast<double>(mesh.origin[axis]);
    const MirrorPlane plane{axis, std::abs(middle - zero) <= 0.5 * tolerance ? zero : middle};
    if (isSymmetricAbout(mesh, tree, plane)) return plane;
  }
  return std::nullopt;
}

Mirror moveToPlane(const MirrorPlane& plane, WorkMesh& mesh) {
  const auto before = static_cast<double>(mesh.origin[plane.axis]);
  mesh.origin[plane.axis] = static_cast<float>(before + plane.offset);
  const double step = static_cast<double>(mesh.origin[plane.axis]) - before;
  for (glm::dvec3& vertex : mesh.vertices) vertex[plane.axis] -= step;
  mesh.bounds.min[plane.axis] -= step;
  mesh.bounds.max[plane.axis] -= step;
  return {plane.axis};
}

Cluster SymmetricMesh::imageOfAll(const Cluster& triangles) const {
  Cluster images;
  images.reserve(triangles.size());
  for (const std::uint32_t triangle : triangles) images.push_back(imageOf[triangle]);
  return images;
}

TriangleRegions SymmetricMesh::regions(const TriangleRegions& ofMesh) const {
  if (ofMesh.keepers.empty()) return {};
  TriangleRegions result = ofMesh;
  result.keepers.resize(mesh.triangles.size(), 0);
  result.weights.resize(mesh.triangles.size(), 0.0F);
  // On the border of a region a triangle may be within, and its image not quite.
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::uint32_t image = imageOf[i];
    const auto [least, most] = std::minmax(result.keepers[i], result.keepers[image]);
    result.keepers[i] = result.keepers[image] = least > 0 ? least : most;
    result.weights[i] = result.weights[image] = std::max(result.weights[i], result.weights[image]);
  }
  return result;
}

Patches SymmetricMesh::patches(const TriangleRegions& regions, std::size_t count,
                               std::size_t maxTriangles) const {
  WorkMesh half = mesh;
  half.triangles.clear();
  Cluster chosen;
  TriangleRegions kinds;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    const double place = mesh.vertices[t[0]][mirror.axis] + mesh.vertices[t[1]][mirror.axis] +
                         mesh.vertices[t[2]][mirror.axis];
    if (isAcross[i] ? imageOf[i] < i : place < 0.0) continue;
    chosen.push_back(i);
    half.triangles.push_back(t);
    kinds.weights.push_back(static_cast<float>(regions.weightOf(i)));
    // What is across the plane is a patch of its own, as what different regions keep is.
    kinds.keepers.push_back(2 * regions.keeperOf(i) + (isAcross[i] ? 1 : 0));
  }
  Patches result = preMerge(half, kinds, count, maxTriangles);
  for (Cluster& cluster : result.clusters) {
    for (std::uint32_t& triangle : cluster) triangle = chosen[triangle];
    if (!isAcross[cluster.front()]) continue;
    const Cluster images = imageOfAll(cluster);
    cluster.insert(cluster.end(), images.begin(), images.end());
    std::sort(cluster.begin(), cluster.end());
    cluster.erase(std::unique(cluster.begin(), cluster.end()), cluster.end());
  }
  return result;
}

SymmetricMesh makeSymmetric(const WorkMesh& mesh, const Mirror& mirror) {
  return Symmetriser(mesh, mirror).run();
}

}  // namespace scatter::levels
