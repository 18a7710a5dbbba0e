#include "levels/mesh/region_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <string>
#include <utility>
#include <variant>

#include "levels/text.h"

namespace scatter::levels {
namespace {

constexpr std::size_t kMostRegions = 64;
constexpr float kLeastWeight = 0.01F;
constexpr float kMostWeight = 100.0F;

/// Of the diagonal: two distances to the same place differ by less.
constexpr double kOnBoundary = 1e-9;

using Loop = std::vector<glm::dvec3>;

/// What of a convex loop is at or below `limit` along an axis; above it with `sign` -1.
Loop cutLoop(const Loop& loop, int axis, double sign, double limit) {
  Loop kept;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const glm::dvec3& a = loop[i];
    const glm::dvec3& b = loop[(i + 1) % loop.size()];
    const double beyondA = sign * (a[axis] - limit);
    const double beyondB = sign * (b[axis] - limit);
    if (beyondA <= 0.0) kept.push_back(a);
    if ((beyondA < 0.0 && beyondB > 0.0) || (beyondA > 0.0 && beyondB < 0.0)) {
      kept.push_back(glm::mix(a, b, beyondA / (beyondA - beyondB)));
    }
  }
  return kept;
}

/// Collects triangles with the mesh's origin taken off.
class Collector {
 public:
  Collector(const SurfaceMesh& mesh, const glm::dvec3& origin) : mesh_(mesh), origin_(origin) {}

  Result<WorkMesh> operator()(const std::vector<std::uint32_t>& triangles) {
    for (const std::uint32_t triangle : triangles) {
      if (triangle >= mesh_.triangles.size()) {
        return fail("triangle " + std::to_string(triangle + 1) + " is none of the mesh's " +
                    std::to_string(mesh_.triangles.size()));
      }
      add(cornersOf(triangle));
    }
    return std::move(result_);
  }

  Result<WorkMesh> operator()(const Bounds& box) {
    if (!(box.min.x <= box.max.x && box.min.y <= box.max.y && box.min.z <= box.max.z))
      return fail("its corners are no numbers, or the first is not the lower one");
    for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
      Loop loop = cornersOf(i);
      for (int axis = 0; axis < 3 && !loop.empty(); ++axis) {
        const double offset = origin_[axis];
        loop = cutLoop(loop, axis, 1.0, static_cast<double>(box.max[axis]) - offset);
        loop = cutLoop(loop, axis, -1.0, static_cast<double>(box.min[axis]) - offset);
      }
      add(loop);
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] Loop cornersOf(std::uint32_t triangle) const {
    Loop loop;
    for (const std::uint32_t vertex : mesh_.triangles[triangle]) {
      loop.push_back(glm::dvec3(mesh_.vertices[vertex]) - origin_);
    }
    return loop;
  }

  void add(const Loop& loop) {
    const auto first = static_cast<std::uint32_t>(result_.vertices.size());
    result_.vertices.insert(result_.vertices.end(), loop.begin(), loop.end());
    for (std::uint32_t i = 2; i < loop.size(); ++i)
      result_.triangles.push_back({first, first + i - 1, first + i});
  }

  const SurfaceMesh& mesh_;
  glm::dvec3 origin_;
  WorkMesh result_;
};

Result<void> checkWeight(float weight) {
  if (weight >= kLeastWeight && weight <= kMostWeight) return {};
  return fail("a weight must be 0.01 to 100, not " + toText(static_cast<double>(weight)));
}

}  // namespace

Result<RegionMap> RegionMap::create(const std::vector<MeshRegion>& regions, const SurfaceMesh& mesh,
                                    const WorkMesh& work) {
  if (regions.size() > kMostRegions) {
    return fail("there are " + std::to_string(regions.size()) + " regions; " + std::to_string(kMostRegions) +
                " are the most");
  }
  RegionMap map;
  map.tolerance_ = kOnBoundary * work.diagonal;
  for (const MeshRegion& region : regions) {
    const std::string name = "region \"" + region.name + "\": ";
    if (auto sound = checkWeight(region.weight); !sound) return fail(name + sound.error().message);
    const Result<WorkMesh> part = std::visit(Collector(mesh, glm::dvec3(work.origin)), region.extent);
    if (!part) return fail(name + part.error().message);
    if (part->triangles.empty()) {
      return fail(name + "has nothing of the mesh, which reaches from " +
                  toText(Vec3(work.bounds.min) + work.origin) + " to " +
                  toText(Vec3(work.bounds.max) + work.origin) + " m");
    }
    map.regions_.push_back({MeshTree(*part), static_cast<double>(region.weight), region.isKept});
    map.largestWeight_ = std::max(map.largestWeight_, static_cast<double>(region.weight));
  }
  return map;
}

bool RegionMap::holds(std::size_t region, const glm::dvec3& point, double distance) const {
  const MeshTree& tree = regions_[region].tree;
  if (tree.isWithin(point, distance + tolerance_)) return true;
  if (!mirror_) return false;
  glm::dvec3 image = point;
  image[mirror_->axis] = -image[mirror_->axis];
  return tree.isWithin(image, distance + tolerance_ + mirror_->tolerance);
}

double RegionMap::weight(const glm::dvec3& point, double distance) const {
  double largest = 0.0;
  for (std::size_t i = 0; i < regions_.size(); ++i) {
    if (regions_[i].weight > largest && holds(i, point, distance)) largest = regions_[i].weight;
  }
  return largest > 0.0 ? largest : 1.0;
}

std::uint32_t RegionMap::keeperOf(const glm::dvec3& point) const {
  for (std::size_t i = 0; i < regions_.size(); ++i) {
    if (regions_[i].isKept && holds(i, point, 0.0)) return static_cast<std::uint32_t>(i + 1);
  }
  return 0;
}

TriangleRegions regionsOfTriangles(const WorkMesh& mesh, const RegionMap& regions) {
  TriangleRegions result;
  if (regions.isEmpty()) return result;
  result.weights.reserve(mesh.triangles.size());
  result.keepers.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const glm::dvec3 middle = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
    result.weights.push_back(static_cast<float>(regions.weight(middle, 0.0)));
    result.keepers.push_back(regions.keeperOf(middle));
  }
  return result;
}

}  // namespace scatter::levels
