#include <scatter/world/field.h>

#include <glm/geometric.hpp>

namespace scatter {

PointField::PointField(const Vec3& center, float acceleration, float radius)
    : center_(center), acceleration_(acceleration), radius_(radius) {}

Vec3 PointField::acceleration(const Vec3& position) const {
  const Vec3 toCenter = center_ - position;
  const float distance = glm::length(toCenter);
  // At the centre itself there is no direction to pull in.
  if (distance > radius_ || distance == 0.0F) return Vec3(0.0F);
  return toCenter * (acceleration_ / distance);
}

}  // namespace scatter
