#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "levels/mesh/region_map.h"
#include "levels/mesh/shells.h"

namespace scatter::levels {

/// Distances to a mesh at the points of a grid around it, negative inside, and what they weigh.
class DistanceGrid {
 public:
  /// `cells` along the longest side of the mesh's bounds. Two threads fill it, to the same values as one;
  /// `progress(share)` is called now and then, on the caller's, and may throw.
  DistanceGrid(const MeshSpace& space, const RegionMap& regions, int cells,
               const std::function<void(double)>& progress);

  [[nodiscard]] double step() const { return step_; }  ///< Size of a cell.

  /// The distance at a point, interpolated; negative inside. Points beyond the grid are moved to its edge.
  [[nodiscard]] double value(const glm::dvec3& point) const { return interpolated(values_, point); }

  /// Whether there are regions that weigh more or less than others.
  [[nodiscard]] bool isWeighted() const { return !weights_.empty(); }
  [[nodiscard]] double largestWeight() const { return largestWeight_; }

  /// What a gap weighs at a point, interpolated. Only if there are regions.
  [[nodiscard]] double weight(const glm::dvec3& point) const { return interpolated(weights_, point); }

 private:
  DistanceGrid(const MeshSpace& space, const RegionMap& regions, int cells);
  void fillSlice(const MeshSpace& space, const RegionMap& regions, int k);
  [[nodiscard]] double interpolated(const std::vector<float>& values, const glm::dvec3& point) const;
  [[nodiscard]] std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(count_.y) + static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(count_.x) +
           static_cast<std::size_t>(i);
  }

  glm::ivec3 count_{0};
  glm::dvec3 low_{0.0};
  double step_ = 1.0;
  double cellsPerMetre_ = 1.0;
  std::vector<float> values_;
  std::vector<float> weights_;  ///< Empty without regions.
  double largestWeight_ = 1.0;
};

}  // namespace scatter::levels
