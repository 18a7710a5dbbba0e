#include "levels/part_check.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "levels/text.h"

namespace scatter::levels {
namespace {

/// How far a rotation's length may be from 1: more than rounding, less than a mistake.
constexpr float kUnitTolerance = 1e-3F;

/// Least ratio of a round part's radius and half height.
constexpr float kThinnest = 1e-5F;

bool isPositive(float value) {
  return std::isfinite(value) && value > 0.0F;
}

std::string badValue(const std::string& what, float value) {
  return what + " " + toText(static_cast<double>(value)) + " must be positive and finite";
}

std::optional<std::string> findShapeDefect(const Box& box) {
  const Vec3& half = box.halfExtents;
  if (isPositive(half.x) && isPositive(half.y) && isPositive(half.z)) return std::nullopt;
  return "box: half extents " + toText(half) + " must be positive and finite";
}

std::optional<std::string> findShapeDefect(const Sphere& sphere) {
  if (isPositive(sphere.radius)) return std::nullopt;
  return badValue("sphere: radius", sphere.radius);
}

/// Round parts so thin that the polytopes that stand for them would drown in rounding.
std::optional<std::string> findThinness(const std::string& shape, float radius, float halfHeight) {
  if (radius >= kThinnest * halfHeight && halfHeight >= kThinnest * radius) return std::nullopt;
  return shape + ": radius " + toText(static_cast<double>(radius)) + " and half height " +
         toText(static_cast<double>(halfHeight)) +
         " differ by more than a factor of 100000; use a box or a hull";
}

std::optional<std::string> findShapeDefect(const Capsule& capsule) {
  if (!isPositive(capsule.radius)) return badValue("capsule: radius", capsule.radius);
  // A capsule of no height is a sphere.
  if (!std::isfinite(capsule.halfHeight) || capsule.halfHeight < 0.0F) {
    return "capsule: half height " + toText(static_cast<double>(capsule.halfHeight)) +
           " must be finite and not negative";
  }
  return findThinness("capsule", capsule.radius, std::max(capsule.radius, capsule.halfHeight));
}

std::optional<std::string> findShapeDefect(const Cylinder& cylinder) {
  if (!isPositive(cylinder.radius)) return badValue("cylinder: radius", cylinder.radius);
  if (!isPositive(cylinder.halfHeight)) return badValue("cylinder: half height", cylinder.halfHeight);
  return findThinness("cylinder", cylinder.radius, cylinder.halfHeight);
}

std::optional<std::string> findShapeDefect(const ConvexHull& hull) {
  for (std::size_t i = 0; i < hull.vertices.size(); ++i) {
    if (isFinite(hull.vertices[i])) continue;
    return "convex hull: vertex " + std::to_string(i + 1) + " " + toText(hull.vertices[i]) + " is not finite";
  }
  return std::nullopt;
}

}  // namespace

bool isFinite(const Vec3& value) {
  return std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z);
}

std::optional<std::string> findDefect(const ConvexPart& part) {
  if (!isFinite(part.pose.position)) return "position " + toText(part.pose.position) + " is not finite";
  const float length = glm::length(part.pose.rotation);
  if (!(std::abs(length - 1.0F) <= kUnitTolerance)) {
    return "rotation has length " + toText(static_cast<double>(length)) + " instead of 1";
  }
  return std::visit([](const auto& shape) { return findShapeDefect(shape); }, part.shape);
}

}  // namespace scatter::levels
