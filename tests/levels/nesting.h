#pragma once

#include <gtest/gtest.h>
#include <scatter/levels/containment.h>
#include <scatter/levels/level_set.h>
#include <scatter/levels/surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include "levels/part_geometry.h"

namespace scatter::testing {

/// How far points are outside a part, its margin not counted; by another way than the builder's: polytopes
/// come from qhull.
class PartOutside {
 public:
  explicit PartOutside(const ConvexPart& part) : part_(part), rounded_(levels::roundedHull(part, 0.0)) {
    auto core = levels::flatSidedCore(part);
    EXPECT_TRUE(core.has_value());
    if (core && *core) core_ = std::move(**core);
  }

  double operator()(const std::vector<glm::dvec3>& points) const {
    double worst = -std::numeric_limits<double>::infinity();
    for (const glm::dvec3& point : points) {
      if (const auto* const cylinder = std::get_if<Cylinder>(&part_.shape)) {
        worst = std::max(worst, outsideCylinder(point, *cylinder));
        continue;
      }
      if (core_.isEmpty()) worst = std::max(worst, outsideRound(point));
      for (const auto& face : core_.faces()) worst = std::max(worst, face.plane.signedDistance(point));
    }
    return worst;
  }

 private:
  /// Less than 0 inside.
  [[nodiscard]] double outsideCylinder(const glm::dvec3& point, const Cylinder& cylinder) const {
    const glm::dvec3 local = levels::DoublePose(part_.pose).toLocal(point);
    return std::max(std::abs(local.y) - static_cast<double>(cylinder.halfHeight),
                    std::hypot(local.x, local.z) - static_cast<double>(cylinder.radius));
  }

  /// From the line that a sphere or capsule is around.
  [[nodiscard]] double outsideRound(const glm::dvec3& point) const {
    const glm::dvec3 start = rounded_.points.front();
    const glm::dvec3 along = rounded_.points.back() - start;
    const double squared = glm::dot(along, along);
    const double t = squared > 0.0 ? std::clamp(glm::dot(point - start, along) / squared, 0.0, 1.0) : 0.0;
    return glm::length(point - start - t * along) - rounded_.radius;
  }

  ConvexPart part_;
  levels::RoundedHull rounded_;
  levels::Polytope core_;
};

/// Expects every triangle in one part of the finest level, and every level inside the next coarser one.
inline void expectNested(const LevelSet& set, const SurfaceMesh& mesh) {
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high = -low;
  for (const Vec3& vertex : mesh.vertices) {
    low = glm::min(low, glm::dvec3(vertex));
    high = glm::max(high, glm::dvec3(vertex));
  }
  const double tolerance = 1e-8 * glm::length(high - low);
  std::vector<PartOutside> parts;
  for (const ConvexPart& part : set.finest().parts) parts.emplace_back(part);
  double worst = -std::numeric_limits<double>::infinity();
  for (const auto& t : mesh.triangles) {
    const std::vector<glm::dvec3> corners{glm::dvec3(mesh.vertices[t[0]]), glm::dvec3(mesh.vertices[t[1]]),
                                          glm::dvec3(mesh.vertices[t[2]])};
    double nearest = std::numeric_limits<double>::infinity();
    for (const PartOutside& part : parts) {
      nearest = std::min(nearest, part(corners));
      if (nearest <= tolerance) break;
    }
    worst = std::max(worst, nearest);
  }
  EXPECT_LE(worst, tolerance) << "a triangle sticks out of the finest level";
  for (int level = 2; level <= set.count(); ++level) {
    const auto slack = static_cast<float>(1e-6 * glm::length(high - low));
    const auto gap = findContainmentGap(set.level(level), set.level(level - 1), set.hullMargin(), slack);
    ASSERT_TRUE(gap.has_value()) << gap.error().message;
    EXPECT_FALSE(gap->has_value()) << "level " << level << " sticks out by " << (*gap)->distance;
  }
}

inline bool haveSameBits(const Level& a, const Level& b) {
  if (a.parts.size() != b.parts.size()) return false;
  for (std::size_t i = 0; i < a.parts.size(); ++i) {
    if (a.parts[i].shape.index() != b.parts[i].shape.index()) return false;
    if (std::memcmp(&a.parts[i].pose, &b.parts[i].pose, sizeof(Transform)) != 0) return false;
    const auto* hullA = std::get_if<ConvexHull>(&a.parts[i].shape);
    const auto* hullB = std::get_if<ConvexHull>(&b.parts[i].shape);
    if (hullA == nullptr) continue;
    if (hullA->vertices != hullB->vertices) return false;
  }
  return true;
}

}  // namespace scatter::testing
