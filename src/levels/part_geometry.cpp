#include "levels/part_geometry.h"

#include <glm/gtc/quaternion.hpp>

namespace scatter::levels {

DoublePose::DoublePose(const Transform& pose)
    : position(pose.position), rotation(glm::mat3_cast(glm::normalize(glm::dquat(pose.rotation)))) {}

std::vector<glm::dvec3> placedVertices(const ConvexHull& hull, const Transform& pose) {
  const DoublePose placed(pose);
  std::vector<glm::dvec3> points;
  points.reserve(hull.vertices.size());
  for (const Vec3& vertex : hull.vertices) points.push_back(placed(glm::dvec3(vertex)));
  return points;
}

}  // namespace scatter::levels
