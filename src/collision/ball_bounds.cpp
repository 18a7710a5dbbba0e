#include "collision/ball_bounds.h"

#include <cstddef>
#include <limits>

#include "collision/simd.h"

namespace scatter {

void boundBalls(const BallsView& balls, const Frame& frame, Vec3& low, Vec3& high) {
  using simd::Lanes;
  constexpr int kStep = static_cast<int>(Lanes::size());
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3& row = frame.row[axis];
    Lanes least(std::numeric_limits<float>::max());
    Lanes most(std::numeric_limits<float>::lowest());
    for (int i = 0; i < balls.padded; i += kStep) {
      const auto radius = simd::load<Lanes>(balls.radius + i);
      const Lanes along = simd::load<Lanes>(balls.x + i) * row.x + simd::load<Lanes>(balls.y + i) * row.y +
                          simd::load<Lanes>(balls.z + i) * row.z;
      least = simd::stdx::min(least, along - radius);
      most = simd::stdx::max(most, along + radius);
    }
    low[axis] = simd::stdx::hmin(least) + frame.origin[axis];
    high[axis] = simd::stdx::hmax(most) + frame.origin[axis];
  }
}

}  // namespace scatter
