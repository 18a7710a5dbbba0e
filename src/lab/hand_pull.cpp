#include "lab/hand_pull.h"

#include <glm/geometric.hpp>

namespace scatter::lab {

namespace {

constexpr float kNewShare = 0.2F;  // of what is new, taken in each step

Vec3 noLongerThan(const Vec3& vector, float most) {
  const float length = glm::length(vector);
  return length > most ? vector * (most / length) : vector;
}

}  // namespace

Vec3 pullAcceleration(const PullDef& def, const Vec3& offset, const Vec3& velocity, float seconds) {
  const float k = def.stiffness * def.stiffness;
  const float d = 2.0F * def.stiffness;
  const Vec3 pull = k * (noLongerThan(offset, def.reach) - seconds * velocity) - d * velocity;
  return noLongerThan(pull / (1.0F + seconds * (d + seconds * k)), def.maxAcceleration);
}

void SteadyLoad::follow(const Vec3& unexplained) {
  acceleration_ += kNewShare * (noLongerThan(unexplained, kLargest) - acceleration_);
}

}  // namespace scatter::lab
