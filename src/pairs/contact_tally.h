#pragma once

#include <algorithm>

namespace scatter::pairs {

/// The contacts of a pair in one step.
struct ContactTally {
  static constexpr float kFar = 1e18F;

  int manifolds = 0;
  int points = 0;
  float least = kFar;  ///< Their least distance, metres.
  float press = 0.0F;  ///< How deep they press the bodies apart, metres.

  void addPoint(float distance, bool presses) {
    ++points;
    least = std::min(least, distance);
    if (presses) press = std::max(press, -distance);
  }
};

}  // namespace scatter::pairs
