#include "scenes/placement.h"

namespace scatter {

float Random::uniform(float low, float high) {
  // The top 24 bits fill a float's mantissa exactly; std::uniform_real_distribution differs by platform.
  const auto unit = static_cast<float>(engine_() >> 40) / static_cast<float>(1U << 24);
  return low + (high - low) * unit;
}

std::size_t Random::below(std::size_t count) {
  return static_cast<std::size_t>(engine_() >> 32) % count;
}

Vec3 Random::insideUnitBall() {
  for (;;) {
    const float x = uniform(-1.0F, 1.0F);
    const float y = uniform(-1.0F, 1.0F);
    const float z = uniform(-1.0F, 1.0F);
    const Vec3 point(x, y, z);
    const float square = glm::dot(point, point);
    if (square <= 1.0F && square > 1e-6F) return point;
  }
}

Vec3 Random::direction() {
  return glm::normalize(insideUnitBall());
}

Quat Random::orientation() {
  // A uniform point of the 4-ball, projected to the unit sphere.
  for (;;) {
    const float w = uniform(-1.0F, 1.0F);
    const float x = uniform(-1.0F, 1.0F);
    const float y = uniform(-1.0F, 1.0F);
    const float z = uniform(-1.0F, 1.0F);
    const Quat candidate(w, x, y, z);
    const float square = glm::dot(candidate, candidate);
    if (square <= 1.0F && square > 1e-6F) return glm::normalize(candidate);
  }
}

}  // namespace scatter
