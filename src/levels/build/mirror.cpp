#include "levels/build/mirror.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

namespace scatter::levels {
namespace {

std::array<double, 3> keyOf(const glm::dvec3& point) {
  return {point.x, point.y, point.z};
}

double mirroredPlace(const ConvexPart& part, int axis, const Vec3& origin) {
  return 2.0 * static_cast<double>(origin[axis]) - static_cast<double>(part.pose.position[axis]);
}

}  // namespace

ConvexPart mirrored(const ConvexPart& part, const Mirror& mirror, const Vec3& origin) {
  ConvexPart image = part;
  image.pose.position[mirror.axis] = static_cast<float>(mirroredPlace(part, mirror.axis, origin));
  // An axis of rotation is a pseudovector: of it, what lies in the plane is turned.
  Quat& turn = image.pose.rotation;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == mirror.axis) continue;
    float& component = axis == 0 ? turn.x : axis == 1 ? turn.y : turn.z;
    component = 0.0F - component;
  }
  // The frame of any other shape is turned as if that were its own image, which they all are.
  if (auto* hull = std::get_if<ConvexHull>(&image.shape)) {
    for (Vec3& vertex : hull->vertices) vertex[mirror.axis] = 0.0F - vertex[mirror.axis];
  }
  return image;
}

bool isMirroredExactly(const ConvexPart& part, const Mirror& mirror, const Vec3& origin) {
  const double place = mirroredPlace(part, mirror.axis, origin);
  return static_cast<double>(static_cast<float>(place)) == place;
}

bool isOwnImage(const ConvexPart& part, const Mirror& mirror, const Vec3& origin) {
  const ConvexPart image = mirrored(part, mirror, origin);
  return image.pose.position == part.pose.position && image.pose.rotation == part.pose.rotation;
}

std::vector<glm::dvec3> withImages(std::span<const glm::dvec3> points, const Mirror& mirror, double epsilon) {
  std::vector<glm::dvec3> result;
  for (const glm::dvec3& point : points) {
    const double place = point[mirror.axis];
    const glm::dvec3 before = place < 0.0 ? mirror(point) : point;
    result.push_back(std::abs(place) <= epsilon ? mirror.flattened(point) : before);
  }
  std::sort(result.begin(), result.end(),
            [](const glm::dvec3& a, const glm::dvec3& b) { return keyOf(a) < keyOf(b); });
  result.erase(std::unique(result.begin(), result.end()), result.end());
  const std::size_t count = result.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (result[i][mirror.axis] > 0.0) result.push_back(mirror(result[i]));
  }
  return result;
}

}  // namespace scatter::levels
