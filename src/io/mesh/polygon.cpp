#include "io/mesh/polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numeric>
#include <optional>
#include <utility>

namespace scatter::io {
namespace {

constexpr std::size_t kMostCorners = 256;

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Triangles fan(std::size_t count) {
  Triangles triangles;
  for (std::uint32_t i = 1; i + 1 < count; ++i) triangles.push_back({0, i, i + 1});
  return triangles;
}

/// Twice the polygon's area along its mean normal (Newell).
glm::dvec3 areaVector(std::span<const glm::dvec3> corners) {
  glm::dvec3 sum{0.0};
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  }
  return sum;
}

/// Seen against the mean normal: a simple polygon is counter-clockwise.
std::vector<glm::dvec2> project(std::span<const glm::dvec3> corners, const glm::dvec3& area) {
  const glm::dvec3 normal = glm::normalize(area);
  const glm::dvec3 other = std::abs(normal.x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 u = glm::normalize(glm::cross(other, normal));
  const glm::dvec3 v = glm::cross(normal, u);
  std::vector<glm::dvec2> flat;
  flat.reserve(corners.size());
  for (const glm::dvec3& corner : corners) {
    flat.emplace_back(glm::dot(corner - corners[0], u), glm::dot(corner - corners[0], v));
  }
  return flat;
}

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Cuts off ears: corners whose triangle holds no other corner (Meisters 1975).
class EarClipping {
 public:
  explicit EarClipping(std::vector<glm::dvec2> corners)
      : corners_(std::move(corners)), left_(corners_.size()) {
    std::iota(left_.begin(), left_.end(), 0U);
  }

  /// Nothing if it runs out of ears, as it does where the polygon crosses itself.
  std::optional<Triangles> run() {
    Triangles triangles;
    while (left_.size() > 3) {
      const std::optional<std::size_t> ear = findEar();
      if (!ear) return std::nullopt;
      triangles.push_back(triangleAt(*ear));
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(*ear));
    }
    triangles.push_back({left_[0], left_[1], left_[2]});
    return triangles;
  }

 private:
  [[nodiscard]] std::array<std::uint32_t, 3> triangleAt(std::size_t i) const {
    const std::size_t count = left_.size();
    return {left_[(i + count - 1) % count], left_[i], left_[(i + 1) % count]};
  }

  /// The best shaped one, so that few slivers arise.
  [[nodiscard]] std::optional<std::size_t> findEar() const {
    std::optional<std::size_t> best;
    double bestShape = -1.0;
    for (std::size_t i = 0; i < left_.size(); ++i) {
      const auto triangle = triangleAt(i);
      const double shape = shapeOf(triangle);
      if (shape <= bestShape || !isEar(triangle)) continue;
      best = i;
      bestShape = shape;
    }
    return best;
  }

  /// Area over squared longest side; 0 for a straight corner, negative for a reflex one.
  [[nodiscard]] double shapeOf(const std::array<std::uint32_t, 3>& t) const {
    const glm::dvec2 ab = corners_[t[1]] - corners_[t[0]];
    const glm::dvec2 bc = corners_[t[2]] - corners_[t[1]];
    const glm::dvec2 ca = corners_[t[0]] - corners_[t[2]];
    const double longest = std::max({glm::dot(ab, ab), glm::dot(bc, bc), glm::dot(ca, ca)});
    return longest > 0.0 ? turn(corners_[t[0]], corners_[t[1]], corners_[t[2]]) / longest : 0.0;
  }

  [[nodiscard]] bool isEar(const std::array<std::uint32_t, 3>& t) const {
    const glm::dvec2& a = corners_[t[0]];
    const glm::dvec2& b = corners_[t[1]];
    const glm::dvec2& c = corners_[t[2]];
    if (turn(a, b, c) < 0.0) return false;
    for (const std::uint32_t other : left_) {
      const glm::dvec2& p = corners_[other];
      if (other == t[0] || other == t[1] || other == t[2] || p == a || p == b || p == c) continue;
      if (turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0) return false;
    }
    return true;
  }

  std::vector<glm::dvec2> corners_;
  std::vector<std::uint32_t> left_;
};

}  // namespace

Triangles triangulate(std::span<const glm::dvec3> corners) {
  if (corners.size() <= 3 || corners.size() > kMostCorners) return fan(corners.size());
  const glm::dvec3 area = areaVector(corners);
  if (!(glm::length(area) > 0.0)) return fan(corners.size());
  std::optional<Triangles> ears = EarClipping(project(corners, area)).run();
  return ears ? std::move(*ears) : fan(corners.size());
}

}  // namespace scatter::io
