#include "scenes/placement.h"

#include <algorithm>

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

ShellPlacement::ShellPlacement(Random& random, const Vec3& center, float innerRadius, float outerRadius)
    : random_(random), center_(center), inner_(innerRadius), outer_(outerRadius) {}

bool ShellPlacement::isClear(const Ball& candidate) const {
  return std::all_of(balls_.begin(), balls_.end(), [&candidate](const Ball& ball) {
    const Vec3 apart = ball.center - candidate.center;
    const float reach = ball.radius + candidate.radius;
    return glm::dot(apart, apart) > reach * reach;
  });
}

Vec3 ShellPlacement::place(float radius) {
  constexpr int kTriesBeforeWidening = 100;
  for (;;) {
    for (int i = 0; i < kTriesBeforeWidening; ++i) {
      const Vec3 direction = random_.direction();
      const Ball ball{center_ + direction * random_.uniform(inner_, outer_), radius};
      if (isClear(ball)) {
        balls_.push_back(ball);
        return ball.center;
      }
    }
    outer_ *= 1.05F;
  }
}

}  // namespace scatter
