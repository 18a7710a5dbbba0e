#include "collision/ball_bounds.h"

#include <limits>

namespace scatter {

void boundBalls(const PolytopeView& centers, const float* radii, const Frame& frame, Vec3& low, Vec3& high) {
  using simd::Lanes;
  constexpr int kStep = static_cast<int>(Lanes::size());
  for (int axis = 0; axis < 3; ++axis) {
    const Reaches<Lanes> reaches(centers, frame.row[axis]);
    Lanes least(std::numeric_limits<float>::max());
    Lanes most(std::numeric_limits<float>::lowest());
    for (int i = 0; i < centers.count; i += kStep) {
      const auto radius = simd::load<Lanes>(radii + i);
      const Lanes along = reaches.at(i);
      least = simd::stdx::min(least, along - radius);
      most = simd::stdx::max(most, along + radius);
    }
    low[axis] = simd::stdx::hmin(least) + frame.origin[axis];
    high[axis] = simd::stdx::hmax(most) + frame.origin[axis];
  }
}

}  // namespace scatter
