#include "viewer/drawing/surface_shading.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace scatter::viewer {

namespace {

/// A vertex of the result that a vertex of the surface has become; it may become several.
struct Made {
  Vec3 normal{0.0F};
  std::uint32_t index = 0;
};

class Shader {
 public:
  Shader(const SurfaceMesh& surface, float crease)
      : surface_(surface),
        leastCosine_(std::cos(crease)),
        around_(surface.vertices.size()),
        made_(around_.size()) {
    for (const auto& triangle : surface.triangles) {
      const Vec3 across = areaVector(triangle);
      areas_.push_back(across);
      const auto id = static_cast<std::uint32_t>(areas_.size() - 1);
      for (const std::uint32_t vertex : triangle) around_[vertex].push_back(id);
    }
  }

  [[nodiscard]] MeshData shade() {
    for (std::size_t i = 0; i < areas_.size(); ++i) {
      if (!(glm::length(areas_[i]) > 0.0F)) continue;
      for (const std::uint32_t vertex : surface_.triangles[i])
        mesh_.indices.push_back(vertexFor(vertex, normalAt(vertex, areas_[i])));
    }
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] Vec3 areaVector(const std::array<std::uint32_t, 3>& triangle) const {
    const Vec3& corner = surface_.vertices[triangle[0]];
    return glm::cross(surface_.vertices[triangle[1]] - corner, surface_.vertices[triangle[2]] - corner);
  }

  /// The mean of the triangles around the vertex, by area, that meet the given one smoothly.
  [[nodiscard]] Vec3 normalAt(std::uint32_t vertex, const Vec3& area) const {
    const Vec3 own = glm::normalize(area);
    Vec3 sum(0.0F);
    for (const std::uint32_t other : around_[vertex]) {
      const float length = glm::length(areas_[other]);
      if (length > 0.0F && glm::dot(own, areas_[other]) >= leastCosine_ * length) sum += areas_[other];
    }
    const float length = glm::length(sum);
    return length > 0.0F ? sum / length : own;
  }

  std::uint32_t vertexFor(std::uint32_t vertex, const Vec3& normal) {
    constexpr float kSameCosine = 0.9999F;
    for (const Made& made : made_[vertex]) {
      if (glm::dot(made.normal, normal) >= kSameCosine) return made.index;
    }
    const auto index = static_cast<std::uint32_t>(mesh_.positions.size());
    mesh_.positions.push_back(surface_.vertices[vertex]);
    mesh_.normals.push_back(normal);
    made_[vertex].push_back({normal, index});
    return index;
  }

  const SurfaceMesh& surface_;
  float leastCosine_;
  std::vector<Vec3> areas_;  ///< Of each triangle, twice its area long.
  std::vector<std::vector<std::uint32_t>> around_;
  std::vector<std::vector<Made>> made_;
  MeshData mesh_;
};

}  // namespace

MeshData shadeSurface(const SurfaceMesh& surface, float crease) {
  return Shader(surface, crease).shade();
}

}  // namespace scatter::viewer
