#pragma once

#include <scatter/levels/mesh_region.h>
#include <scatter/levels/surface_mesh.h>
#include <scatter/result.h>

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "levels/mesh/mesh_tree.h"
#include "levels/mesh/work_mesh.h"

namespace scatter::levels {

/// Which places are nearest to which regions of a mesh.
class RegionMap {
 public:
  RegionMap() = default;  ///< Without regions.

  /// Fails on a region that has nothing of the mesh, and on weights that make no sense.
  [[nodiscard]] static Result<RegionMap> create(const std::vector<MeshRegion>& regions,
                                                const SurfaceMesh& mesh, const WorkMesh& work);

  /// Of a mesh that is symmetric about the plane through zero across this axis, to within a tolerance: what a
  /// region has on one side it has on the other, too.
  void countOnBothSides(int axis, double tolerance) { mirror_ = {axis, tolerance}; }

  [[nodiscard]] bool isEmpty() const { return regions_.empty(); }
  [[nodiscard]] std::size_t count() const { return regions_.size(); }

  /// Whether the region is as near to the point as the mesh is, which is at `distance`.
  [[nodiscard]] bool holds(std::size_t region, const glm::dvec3& point, double distance) const;

  /// Of what the mesh has nearest to the point, at `distance`; 1 without regions.
  [[nodiscard]] double weight(const glm::dvec3& point, double distance) const;

  /// Of all there are, 1 among them: the mesh may be larger than its regions.
  [[nodiscard]] double largestWeight() const { return largestWeight_; }

  /// Which kept region has this point of the mesh, the first of several, from 1; 0 if none has.
  [[nodiscard]] std::uint32_t keeperOf(const glm::dvec3& point) const;

 private:
  struct Region {
    MeshTree tree;
    double weight = 1.0;
    bool isKept = false;
  };

  struct BothSides {
    int axis = 0;
    double tolerance = 0.0;
  };

  std::vector<Region> regions_;
  std::optional<BothSides> mirror_;
  double largestWeight_ = 1.0;
  double tolerance_ = 0.0;
};

/// What regions say about each triangle of a mesh; empty without regions.
struct TriangleRegions {
  std::vector<float> weights;
  std::vector<std::uint32_t> keepers;  ///< See RegionMap::keeperOf().

  [[nodiscard]] double weightOf(std::uint32_t triangle) const {
    return weights.empty() ? 1.0 : static_cast<double>(weights[triangle]);
  }
  [[nodiscard]] std::uint32_t keeperOf(std::uint32_t triangle) const {
    return keepers.empty() ? 0 : keepers[triangle];
  }
};

/// By the triangles' middles.
[[nodiscard]] TriangleRegions regionsOfTriangles(const WorkMesh& mesh, const RegionMap& regions);

}  // namespace scatter::levels
