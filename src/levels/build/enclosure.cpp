#include "levels/build/enclosure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace scatter::levels {
namespace {

/// Shewchuk's bound on the error of orient3d, as a share of the determinant's permanent: (7 + 56 e) e with
/// e = 2^-53.
constexpr double kUnit = 0x1.0p-53;
constexpr double kErrorBound = (7.0 + 56.0 * kUnit) * kUnit;

bool isClosed(const std::vector<Triangle>& triangles) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) edges.emplace_back(t[k], t[(k + 1) % 3]);
  }
  std::sort(edges.begin(), edges.end());
  if (edges.empty() || std::adjacent_find(edges.begin(), edges.end()) != edges.end()) return false;
  return std::all_of(edges.begin(), edges.end(), [&](const auto& edge) {
    return std::binary_search(edges.begin(), edges.end(), std::pair(edge.second, edge.first));
  });
}

/// Whether `p` is certainly on the inner side of the triangle.
bool isInner(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& p) {
  const glm::dvec3 u = a - p;
  const glm::dvec3 v = b - p;
  const glm::dvec3 w = c - p;
  const double vxwy = v.x * w.y;
  const double wxvy = w.x * v.y;
  const double wxuy = w.x * u.y;
  const double uxwy = u.x * w.y;
  const double uxvy = u.x * v.y;
  const double vxuy = v.x * u.y;
  const double determinant = u.z * (vxwy - wxvy) + v.z * (wxuy - uxwy) + w.z * (uxvy - vxuy);
  const double permanent = (std::abs(vxwy) + std::abs(wxvy)) * std::abs(u.z) +
                           (std::abs(wxuy) + std::abs(uxwy)) * std::abs(v.z) +
                           (std::abs(uxvy) + std::abs(vxuy)) * std::abs(w.z);
  return determinant > kErrorBound * permanent;
}

}  // namespace

bool provesInside(const TriangleHull& hull, std::span<const glm::dvec3> points) {
  if (!isClosed(hull.triangles)) return false;
  return std::all_of(points.begin(), points.end(), [&](const glm::dvec3& point) {
    return std::all_of(hull.triangles.begin(), hull.triangles.end(), [&](const Triangle& t) {
      return isInner(hull.vertices[t[0]], hull.vertices[t[1]], hull.vertices[t[2]], point);
    });
  });
}

}  // namespace scatter::levels
