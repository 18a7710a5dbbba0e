#pragma once

#include "lod/situation.h"

namespace scatter::lod {

/// Metres a second at which the centres come nearer; negative if they part. Where the centre of a floor or a
/// wall is says nothing: to what nothing moves, any motion is an approach.
[[nodiscard]] inline float approachSpeed(const BodyView& a, const BodyView& b) {
  if (!(a.mass > 0.0F && b.mass > 0.0F)) return glm::length(a.velocity - b.velocity);
  const Vec3 offset = b.center - a.center;
  const float distance = glm::length(offset);
  return distance > 0.0F ? glm::dot(a.velocity - b.velocity, offset) / distance : 0.0F;
}

}  // namespace scatter::lod
