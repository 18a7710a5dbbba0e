#include "boxes.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace scatter::tools {
namespace {

/// Boxes are this much larger than what they hold, so that rounding cannot make anything stick out.
constexpr double kSlack = 0.001;

double snap(double value) {
  return std::round(value * 1e4) / 1e4;
}

}  // namespace

Vec3 snapped(const glm::dvec3& v) {
  return {static_cast<float>(snap(v.x)), static_cast<float>(snap(v.y)), static_cast<float>(snap(v.z))};
}

glm::dmat3 axesAlong(const glm::dvec3& direction, const glm::dvec3& up) {
  const glm::dvec3 x = glm::normalize(direction);
  const glm::dvec3 y = glm::normalize(up - glm::dot(up, x) * x);
  return {x, y, glm::cross(x, y)};
}

ConvexPart boxAround(const std::vector<Vec3>& points, const glm::dmat3& axes, double extra) {
  const glm::dquat exact = glm::normalize(glm::quat_cast(axes));
  const Quat rotation(exact.w < 0.0 ? -exact : exact);
  const glm::dmat3 toLocal = glm::transpose(glm::mat3_cast(glm::normalize(glm::dquat(rotation))));
  glm::dvec3 low(1e9);
  glm::dvec3 high(-1e9);
  for (const Vec3& point : points) {
    low = glm::min(low, toLocal * glm::dvec3(point));
    high = glm::max(high, toLocal * glm::dvec3(point));
  }
  const Vec3 position = snapped(glm::transpose(toLocal) * ((low + high) * 0.5));
  const glm::dvec3 middle = toLocal * glm::dvec3(position);
  const glm::dvec3 needed = glm::max(high - middle, middle - low) + extra + kSlack;
  const glm::dvec3 half = glm::ceil(needed * 1000.0) / 1000.0;
  return {Box{Vec3(half)}, Transform{position, rotation}};
}

void addCorners(const ConvexPart& box, std::vector<Vec3>& points) {
  const Vec3 half = std::get<Box>(box.shape).halfExtents;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 sign((corner & 1) != 0 ? 1.0F : -1.0F, (corner & 2) != 0 ? 1.0F : -1.0F,
                    (corner & 4) != 0 ? 1.0F : -1.0F);
    points.push_back(box.pose(sign * half));
  }
}

}  // namespace scatter::tools
