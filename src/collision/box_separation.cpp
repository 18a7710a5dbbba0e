#include "collision/box_separation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scatter {

float boxSeparation(const Vec3& centerA, const Vec3& halfA, const Vec3& centerB, const Vec3& halfB,
                    const Frame& frameB, float enough) {
  constexpr float kRounding = 4e-7F;  // what the axes lack of being orthonormal
  const Vec3 between = frameB(centerB) - centerA;
  const Vec3 axesB[3]{{frameB.row[0].x, frameB.row[1].x, frameB.row[2].x},
                      {frameB.row[0].y, frameB.row[1].y, frameB.row[2].y},
                      {frameB.row[0].z, frameB.row[1].z, frameB.row[2].z}};
  float best = std::numeric_limits<float>::lowest();
  for (int i = 0; i < 3; ++i) {
    const float alongA = std::abs(between[i]) - halfA[i] - glm::dot(glm::abs(frameB.row[i]), halfB);
    const float alongB =
        std::abs(glm::dot(between, axesB[i])) - halfB[i] - glm::dot(glm::abs(axesB[i]), halfA);
    best = std::max(best, std::max(alongA, alongB));
  }
  if (best > enough) return best;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    for (int m = 0; m < 3; ++m) {
      // The axis is A's i-th across B's m-th.
      const float length = std::sqrt(axesB[m][j] * axesB[m][j] + axesB[m][k] * axesB[m][k]);
      // Of edges nearly parallel the axis is nearly a face's, and too inexact.
      if (length < 0.03F) continue;
      const int n = (m + 1) % 3;
      const int o = (m + 2) % 3;
      const float reachA = halfA[j] * std::abs(axesB[m][k]) + halfA[k] * std::abs(axesB[m][j]);
      const float reachB = halfB[n] * std::abs(axesB[o][i]) + halfB[o] * std::abs(axesB[n][i]);
      const float apart = std::abs(between[k] * axesB[m][j] - between[j] * axesB[m][k]);
      const float rounding = kRounding * (halfA[j] + halfA[k] + halfB[n] + halfB[o]);
      best = std::max(best, (apart - reachA - reachB - rounding) / length);
    }
  }
  return best;
}

}  // namespace scatter
