#include "scenes/shape_measures.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "levels/part_geometry.h"

namespace scatter {
namespace {

float reach(const Box& box) {
  return glm::length(box.halfExtents);
}
float reach(const Sphere& sphere) {
  return sphere.radius;
}
float reach(const Capsule& capsule) {
  return capsule.radius + capsule.halfHeight;
}
float reach(const Cylinder& cylinder) {
  return std::hypot(cylinder.radius, cylinder.halfHeight);
}
float reach(const ConvexHull& hull) {
  float furthest = 0.0F;
  for (const Vec3& vertex : hull.vertices) furthest = std::max(furthest, glm::length(vertex));
  return furthest;
}

void scale(Box& box, float factor) {
  box.halfExtents *= factor;
}
void scale(Sphere& sphere, float factor) {
  sphere.radius *= factor;
}
void scale(Capsule& capsule, float factor) {
  capsule.radius *= factor;
  capsule.halfHeight *= factor;
}
void scale(Cylinder& cylinder, float factor) {
  cylinder.radius *= factor;
  cylinder.halfHeight *= factor;
}
void scale(ConvexHull& hull, float factor) {
  Vec3 middle(0.0F);
  for (const Vec3& vertex : hull.vertices) middle += vertex / static_cast<float>(hull.vertices.size());
  for (Vec3& vertex : hull.vertices) vertex = middle + factor * (vertex - middle);
}

}  // namespace

float reachOf(const ConvexShape& shape) {
  return std::visit([](const auto& convex) { return reach(convex); }, shape);
}

float boundingRadius(const LevelSet& levels) {
  float radius = 0.0F;
  for (const ConvexPart& part : levels.coarsest().parts) {
    radius = std::max(radius, glm::length(part.pose.position) + reachOf(part.shape));
  }
  return radius + levels.hullMargin();
}

Heights heightsOf(const std::vector<ConvexPart>& parts, float hullMargin, const Quat& turn) {
  const auto margin = static_cast<double>(hullMargin);
  const glm::dvec3 up = glm::conjugate(glm::dquat(turn)) * glm::dvec3(0.0, 1.0, 0.0);
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  for (const ConvexPart& part : parts) {
    high = std::max(high, levels::support(part, margin, up));
    low = std::min(low, -levels::support(part, margin, -up));
  }
  return {static_cast<float>(low), static_cast<float>(high)};
}

ConvexPart scaledPart(const ConvexPart& part, float factor) {
  ConvexPart scaled = part;
  std::visit([factor](auto& shape) { scale(shape, factor); }, scaled.shape);
  return scaled;
}

}  // namespace scatter
