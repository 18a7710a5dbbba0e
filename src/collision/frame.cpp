#include "collision/frame.h"

#include <cmath>

namespace scatter {

Frame relativeFrame(const Frame& a, const Frame& b) {
  Frame relative;
  for (int i = 0; i < 3; ++i) {
    relative.row[i] = a.row[0][i] * b.row[0] + a.row[1][i] * b.row[1] + a.row[2][i] * b.row[2];
  }
  relative.origin = a.rotateBack(b.origin - a.origin);
  return relative;
}

namespace {

constexpr float kFrameRounding = 4e-7F;

}  // namespace

float turnBound(const Frame& before, const Frame& after) {
  float squares = 0.0F;
  for (int i = 0; i < 3; ++i) {
    const Vec3 change = after.row[i] - before.row[i];
    squares += glm::dot(change, change);
  }
  return std::sqrt(0.5F * squares) * 1.0001F + kFrameRounding;
}

Displacement displacementBound(const Frame& before, const Frame& after, const Vec3& center, float radius) {
  Vec3 moved = after.origin - before.origin;
  for (int i = 0; i < 3; ++i) moved[i] += glm::dot(after.row[i] - before.row[i], center);
  const float turned = turnBound(before, after);
  const float reach = radius + glm::length(center) + glm::length(before.origin) + glm::length(after.origin);
  return {glm::length(moved) + turned * radius + kFrameRounding * reach, turned};
}

}  // namespace scatter
