#include "levels/build/distance_grid.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <glm/common.hpp>
#include <limits>

namespace scatter::levels {

DistanceGrid::DistanceGrid(const MeshSpace& space, const RegionMap& regions, int cells)
    : largestWeight_(regions.largestWeight()) {
  const glm::dvec3 size = space.mesh.bounds.max - space.mesh.bounds.min;
  step_ = std::max({size.x, size.y, size.z}) / cells;
  cellsPerMetre_ = 1.0 / step_;
  low_ = space.mesh.bounds.min - 1.5 * step_;
  count_ = glm::ivec3(size / step_) + 4;
  values_.assign(index(0, 0, count_.z), 0.0F);
  if (!regions.isEmpty()) weights_.assign(values_.size(), 1.0F);
}

DistanceGrid::DistanceGrid(const MeshSpace& space, const RegionMap& regions, int cells,
                           const std::function<void(double)>& progress)
    : DistanceGrid(space, regions, cells) {
  std::atomic<int> next = 0;
  const auto fillNext = [&] {
    const int k = next++;
    if (k < count_.z) fillSlice(space, regions, k);
    return k < count_.z;
  };
  const std::future<void> helper = std::async([&] {
    while (fillNext()) continue;
  });
  // An interrupt comes as an exception; the helper then has nothing left to do.
  struct Stop {
    ~Stop() { next = count; }
    std::atomic<int>& next;
    int count;
  } const stop{next, count_.z};
  while (fillNext()) progress(std::min(1.0, static_cast<double>(next) / count_.z));
}

void DistanceGrid::fillSlice(const MeshSpace& space, const RegionMap& regions, int k) {
  for (int j = 0; j < count_.y; ++j) {
    double last = std::numeric_limits<double>::infinity();
    bool isInside = false;
    for (int i = 0; i < count_.x; ++i) {
      const glm::dvec3 point = low_ + step_ * glm::dvec3(i, j, k);
      const double distance = space.tree.distance(point, last + 1.001 * step_);
      // Between neighbours, a closed surface can only pass where both are near it.
      const bool mayCross = !space.isClosed || i == 0 || distance + last <= 1.001 * step_;
      if (mayCross) isInside = space.isInside(point);
      last = distance;
      values_[index(i, j, k)] = static_cast<float>(isInside ? -distance : distance);
      if (!weights_.empty()) weights_[index(i, j, k)] = static_cast<float>(regions.weight(point, distance));
    }
  }
}

double DistanceGrid::interpolated(const std::vector<float>& values, const glm::dvec3& point) const {
  const glm::dvec3 last(count_ - 1);
  const glm::dvec3 place = glm::clamp((point - low_) * cellsPerMetre_, glm::dvec3(0.0), last);
  const glm::ivec3 cell = glm::min(glm::ivec3(place), count_ - 2);
  const glm::vec3 t(place - glm::dvec3(cell));
  const auto row = static_cast<std::ptrdiff_t>(count_.x);
  const std::ptrdiff_t slice = row * count_.y;
  const float* corner = &values[index(cell.x, cell.y, cell.z)];
  const auto along = [&t](const float* first) { return first[0] + t.x * (first[1] - first[0]); };
  const auto across = [&](const float* first) {
    const float low = along(first);
    return low + t.y * (along(first + row) - low);
  };
  const float low = across(corner);
  return static_cast<double>(low + t.z * (across(corner + slice) - low));
}

}  // namespace scatter::levels
