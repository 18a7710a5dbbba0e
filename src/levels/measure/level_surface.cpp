#include "levels/measure/level_surface.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <type_traits>
#include <utility>
#include <variant>

#include "levels/mesh/even_points.h"
#include "levels/mesh/triangle.h"

namespace scatter::levels {
namespace {

/// Rings of points on a round part.
constexpr int kRings = 16;
constexpr int kRingPoints = 32;

/// The additive recurrence that spreads points most evenly in three dimensions (Roberts, 2018).
constexpr double kPlastic3[] = {0.8191725133961645, 0.6710436067037893, 0.5497004779019703};

double fraction(double value) {
  return value - std::floor(value);
}

/// Points on the surface of a shape in its own frame; all corners of its hull.
struct SurfacePoints {
  std::vector<glm::dvec3> operator()(const Box& box) const {
    std::vector<glm::dvec3> points;
    for (unsigned corner = 0; corner < 8; ++corner) {
      const glm::dvec3 sign{(corner & 1U) != 0 ? 1.0 : -1.0, (corner & 2U) != 0 ? 1.0 : -1.0,
                            (corner & 4U) != 0 ? 1.0 : -1.0};
      points.push_back(sign * glm::dvec3(box.halfExtents));
    }
    return points;
  }
  std::vector<glm::dvec3> operator()(const Sphere& sphere) const {
    return (*this)(Capsule{sphere.radius, 0.0F});
  }
  std::vector<glm::dvec3> operator()(const Capsule& capsule) const {
    std::vector<glm::dvec3> points;
    for (int ring = 0; ring <= kRings; ++ring) {
      const double polar = std::numbers::pi * ring / kRings;
      const double lift = 2 * ring < kRings ? toDouble(capsule.halfHeight) : -toDouble(capsule.halfHeight);
      const double radius = toDouble(capsule.radius);
      addRing(points, radius * std::sin(polar), lift + radius * std::cos(polar));
    }
    return points;
  }
  std::vector<glm::dvec3> operator()(const Cylinder& cylinder) const {
    std::vector<glm::dvec3> points;
    addRing(points, toDouble(cylinder.radius), toDouble(cylinder.halfHeight));
    addRing(points, toDouble(cylinder.radius), -toDouble(cylinder.halfHeight));
    return points;
  }
  std::vector<glm::dvec3> operator()(const ConvexHull& hull) const {
    return {hull.vertices.begin(), hull.vertices.end()};
  }

 private:
  static void addRing(std::vector<glm::dvec3>& points, double radius, double height) {
    for (int i = 0; i < kRingPoints; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kRingPoints;
      points.emplace_back(radius * std::cos(angle), height, radius * std::sin(angle));
    }
  }
};

/// How far a point in the shape's frame is outside; negative inside. Only of round shapes.
struct RoundDistance {
  glm::dvec3 point;

  double operator()(const Sphere& sphere) const { return glm::length(point) - toDouble(sphere.radius); }
  double operator()(const Capsule& capsule) const {
    const double h = toDouble(capsule.halfHeight);
    return glm::length(point - glm::dvec3(0.0, std::clamp(point.y, -h, h), 0.0)) - toDouble(capsule.radius);
  }
  double operator()(const Cylinder& cylinder) const {
    return std::max(std::hypot(point.x, point.z) - toDouble(cylinder.radius),
                    std::abs(point.y) - toDouble(cylinder.halfHeight));
  }
  double operator()(const Box&) const { return 0.0; }
  double operator()(const ConvexHull&) const { return 0.0; }
};

bool isRound(const ConvexPart& part) {
  return !std::holds_alternative<Box>(part.shape) && !std::holds_alternative<ConvexHull>(part.shape);
}

}  // namespace

LevelSurface::LevelSurface(const Level& level, const glm::dvec3& origin) {
  HullBuilder builder;
  for (const ConvexPart& part : level.parts) {
    PartSurface surface{part, DoublePose(part.pose), {}};
    surface.pose.position -= origin;
    std::vector<glm::dvec3> points = std::visit(SurfacePoints{}, part.shape);
    for (glm::dvec3& point : points) point = surface.pose(point);
    if (builder.build(points, {}, surface.hull)) parts_.push_back(std::move(surface));
  }
}

std::vector<LevelSurface::Sample> LevelSurface::samples(std::size_t count) const {
  double total = 0.0;
  for (const PartSurface& part : parts_) total += part.hull.area;
  std::vector<Sample> result;
  result.reserve(count);
  double passed = 0.0;
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const TriangleHull& hull = parts_[p].hull;
    for (std::size_t face = 0; face < hull.triangles.size(); ++face) {
      const Triangle& t = hull.triangles[face];
      const glm::dvec3& a = hull.vertices[t[0]];
      const glm::dvec3 u = hull.vertices[t[1]] - a;
      const glm::dvec3 v = hull.vertices[t[2]] - a;
      passed += 0.5 * glm::length(glm::cross(u, v));
      // As many samples as the area so far deserves.
      const double deserved = std::floor(passed / total * static_cast<double>(count) + 0.5);
      while (static_cast<double>(result.size()) < deserved && result.size() < count) {
        const glm::dvec2 at = evenInTriangle(result.size());
        result.push_back({a + at.x * u + at.y * v, p, hull.planes[face].normal});
      }
    }
  }
  return result;
}

std::vector<LevelSurface::Sample> LevelSurface::corners() const {
  std::vector<Sample> result;
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    if (isRound(parts_[p].part)) continue;
    for (const glm::dvec3& vertex : parts_[p].hull.vertices) result.push_back({vertex, p, glm::dvec3(0.0)});
  }
  return result;
}

bool LevelSurface::isCovered(const glm::dvec3& point, double depth, std::size_t except) const {
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    if (p != except && holds(parts_[p], point, depth)) return true;
  }
  return false;
}

LevelSurface::Filling LevelSurface::filling(std::size_t sampleCount) const {
  DoubleBounds bounds;
  for (const PartSurface& part : parts_) {
    bounds.add(part.hull.bounds.min);
    bounds.add(part.hull.bounds.max);
  }
  const glm::dvec3 size = bounds.max - bounds.min;
  Filling result;
  for (std::size_t i = 0; i < sampleCount; ++i) {
    const auto n = static_cast<double>(i);
    const glm::dvec3 place{fraction(0.5 + kPlastic3[0] * n), fraction(0.5 + kPlastic3[1] * n),
                           fraction(0.5 + kPlastic3[2] * n)};
    const glm::dvec3 point = bounds.min + place * size;
    if (isCovered(point, 0.0, parts_.size())) result.points.push_back(point);
  }
  result.volume =
      size.x * size.y * size.z * static_cast<double>(result.points.size()) / static_cast<double>(sampleCount);
  return result;
}

bool LevelSurface::holds(const PartSurface& surface, const glm::dvec3& point, double depth) {
  const DoubleBounds& bounds = surface.hull.bounds;
  if (isRound(surface.part)) {
    return std::visit(RoundDistance{surface.pose.toLocal(point)}, surface.part.shape) <= -depth;
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (point[axis] < bounds.min[axis] || point[axis] > bounds.max[axis]) return false;
  }
  return std::all_of(surface.hull.planes.begin(), surface.hull.planes.end(),
                     [&](const HalfSpace& plane) { return plane.signedDistance(point) <= -depth; });
}

}  // namespace scatter::levels
