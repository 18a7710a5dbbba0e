#pragma once

#include <scatter/math.h>

#include "collision/simd.h"

namespace scatter {

/// The vertices of a convex polytope, one array a coordinate, each padded by repeating the last vertex to a
/// multiple of simd::kPadding. Not owned.
struct PolytopeView {
  const float* x = nullptr;
  const float* y = nullptr;
  const float* z = nullptr;
  int count = 0;

  [[nodiscard]] Vec3 vertex(int i) const { return {x[i], y[i], z[i]}; }
};

struct Support {
  int vertex = 0;  ///< The first of the furthest.
  float reach = 0.0F;
};

/// The vertex that is furthest along `direction`.
template <class L = simd::Lanes>
[[nodiscard]] inline Support support(const PolytopeView& polytope, const Vec3& direction) {
  const L dx(direction.x);
  const L dy(direction.y);
  const L dz(direction.z);
  const auto reachAt = [&](int i) {
    return simd::load<L>(polytope.x + i) * dx + simd::load<L>(polytope.y + i) * dy +
           simd::load<L>(polytope.z + i) * dz;
  };
  constexpr int kStep = static_cast<int>(L::size());
  L best = reachAt(0);
  L bestBase(0.0F);  // small whole numbers, exact in a float
  for (int i = kStep; i < polytope.count; i += kStep) {
    const L reach = reachAt(i);
    const auto further = reach > best;
    simd::stdx::where(further, best) = reach;
    simd::stdx::where(further, bestBase) = static_cast<float>(i);
  }
  Support found{static_cast<int>(bestBase[0]), best[0]};
  for (int lane = 1; lane < kStep; ++lane) {
    const float reach = best[static_cast<std::size_t>(lane)];
    const int vertex = static_cast<int>(bestBase[static_cast<std::size_t>(lane)]) + lane;
    if (reach > found.reach || (reach == found.reach && vertex < found.vertex)) {
      found = {vertex, reach};
    }
  }
  found.vertex = found.vertex < polytope.count ? found.vertex : polytope.count - 1;
  return found;
}

/// How far the polytope reaches along `direction`.
template <class L = simd::Lanes>
[[nodiscard]] inline float reach(const PolytopeView& polytope, const Vec3& direction) {
  const L dx(direction.x);
  const L dy(direction.y);
  const L dz(direction.z);
  const auto reachAt = [&](int i) {
    return simd::load<L>(polytope.x + i) * dx + simd::load<L>(polytope.y + i) * dy +
           simd::load<L>(polytope.z + i) * dz;
  };
  constexpr int kStep = static_cast<int>(L::size());
  L best = reachAt(0);
  for (int i = kStep; i < polytope.count; i += kStep) {
    best = simd::stdx::max(best, reachAt(i));
  }
  return simd::stdx::hmax(best);
}

}  // namespace scatter
