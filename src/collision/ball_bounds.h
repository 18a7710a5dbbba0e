#pragma once

#include <scatter/math.h>

#include "collision/frame.h"

namespace scatter {

/// Balls of which a convex body is the hull, in its frame: one array a coordinate and one of the radii, each
/// padded by repeating the last one to a multiple of simd::kPadding. Not owned.
struct BallsView {
  const float* x = nullptr;
  const float* y = nullptr;
  const float* z = nullptr;
  const float* radius = nullptr;
  int padded = 0;
};

/// World bounds of the hull of at least one ball, with its body at `frame`: as close as they may be, but for
/// rounding, however the body is turned.
void boundBalls(const BallsView& balls, const Frame& frame, Vec3& low, Vec3& high);

}  // namespace scatter
