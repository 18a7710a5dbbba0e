#include "collision/box_separation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scatter {

float boxSeparation(const Vec3& centerA, const Vec3& halfA, const Vec3& centerB, const Vec3& halfB,
                    const Frame& frameB, float enough) {
  const Vec3 between = frameB(centerB) - centerA;
  const Vec3 axesB[3]{{frameB.row[0].x, frameB.row[1].x, frameB.row[2].x},
                      {frameB.row[0].y, frameB.row[1].y, frameB.row[2].y},
                      {frameB.row[0].z, frameB.row[1].z, frameB.row[2].z}};
  float best = std::numeric_limits<float>::lowest();
  const auto tryAxis = [&](const Vec3& unit) {
    const Vec3 inB(glm::dot(unit, axesB[0]), glm::dot(unit, axesB[1]), glm::dot(unit, axesB[2]));
    const float reach = glm::dot(glm::abs(unit), halfA) + glm::dot(glm::abs(inB), halfB);
    best = std::max(best, std::abs(glm::dot(unit, between)) - reach);
  };
  for (int i = 0; i < 3; ++i) {
    Vec3 axisA(0.0F);
    axisA[i] = 1.0F;
    tryAxis(axisA);
    tryAxis(axesB[i]);
  }
  if (best > enough) return best;
  for (int i = 0; i < 3; ++i) {
    Vec3 axisA(0.0F);
    axisA[i] = 1.0F;
    for (const Vec3& axisB : axesB) {
      const Vec3 across = glm::cross(axisA, axisB);
      const float length = glm::length(across);
      if (length > 1e-3F) tryAxis(across / length);
    }
  }
  return best;
}

}  // namespace scatter
