#include "io/collada/round.h"

#include <cmath>
#include <glm/gtc/constants.hpp>

namespace scatter::io {
namespace {

constexpr int kSides = 20;
constexpr int kRings = 4;

void addRing(const RoundEnd& end, float height, float share, std::vector<Vec3>& vertices) {
  if (end.radii[0] == 0.0F && end.radii[1] == 0.0F) {
    vertices.emplace_back(0.0F, height, 0.0F);
    return;
  }
  for (int side = 0; side < kSides; ++side) {
    const float angle = glm::two_pi<float>() * static_cast<float>(side) / static_cast<float>(kSides);
    vertices.emplace_back(end.radii[0] * share * std::cos(angle), height,
                          end.radii[1] * share * std::sin(angle));
  }
}

/// `outward` is 1 for the top and -1 for the bottom.
void addEnd(const RoundEnd& end, float outward, std::vector<Vec3>& vertices) {
  addRing(end, end.height, 1.0F, vertices);
  if (end.cap == 0.0F) {
    return;
  }
  for (int ring = 1; ring < kRings; ++ring) {
    const float angle = glm::half_pi<float>() * static_cast<float>(ring) / static_cast<float>(kRings);
    addRing(end, end.height + outward * end.cap * std::sin(angle), std::cos(angle), vertices);
  }
  vertices.emplace_back(0.0F, end.height + outward * end.cap, 0.0F);
}

}  // namespace

ConvexHull roundHull(const RoundEnd& bottom, const RoundEnd& top) {
  ConvexHull hull;
  addEnd(bottom, -1.0F, hull.vertices);
  addEnd(top, 1.0F, hull.vertices);
  return hull;
}

}  // namespace scatter::io
