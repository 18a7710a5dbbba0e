#include "lab/model_length.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace scatter::lab {

namespace {

using Extents = std::pair<Vec3, Vec3>;  // least and largest coordinates

// How far a shape reaches along each axis of the model, around its own origin; `rotation` takes it there.
Vec3 reachOf(const Box& box, const Mat3& rotation) {
  Vec3 reach(0.0F);
  for (int axis = 0; axis < 3; ++axis) {
    reach += glm::abs(rotation[axis]) * box.halfExtents[axis];
  }
  return reach;
}

Vec3 reachOf(const Sphere& sphere, const Mat3& /*rotation*/) {
  return Vec3(sphere.radius);
}

Vec3 reachOf(const Capsule& capsule, const Mat3& rotation) {
  return glm::abs(rotation[1]) * capsule.halfHeight + capsule.radius;
}

Vec3 reachOf(const Cylinder& cylinder, const Mat3& rotation) {
  const Vec3 across = glm::sqrt(rotation[0] * rotation[0] + rotation[2] * rotation[2]);
  return glm::abs(rotation[1]) * cylinder.halfHeight + across * cylinder.radius;
}

template <class Shape>
Extents extentsOf(const Shape& shape, const Transform& pose) {
  const Vec3 reach = reachOf(shape, glm::mat3_cast(pose.rotation));
  return {pose.position - reach, pose.position + reach};
}

Extents extentsOf(const ConvexHull& hull, const Transform& pose) {
  Extents extents{Vec3(std::numeric_limits<float>::max()), Vec3(std::numeric_limits<float>::lowest())};
  for (const Vec3& vertex : hull.vertices) {
    extents.first = glm::min(extents.first, pose(vertex));
    extents.second = glm::max(extents.second, pose(vertex));
  }
  return extents;
}

}  // namespace

double modelLength(const LevelSet& levels) {
  Vec3 least(std::numeric_limits<float>::max());
  Vec3 largest(std::numeric_limits<float>::lowest());
  for (const ConvexPart& part : levels.finest().parts) {
    const Extents extents =
        std::visit([&part](const auto& shape) { return extentsOf(shape, part.pose); }, part.shape);
    least = glm::min(least, extents.first);
    largest = glm::max(largest, extents.second);
  }
  const Vec3 size = largest - least;
  return std::max({size.x, size.y, size.z});
}

}  // namespace scatter::lab
