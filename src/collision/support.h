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

/// How far the vertices of a polytope reach along a direction, some of them at once.
template <class L>
class Reaches {
 public:
  Reaches(const PolytopeView& polytope, const Vec3& direction)
      : polytope_(polytope), x_(direction.x), y_(direction.y), z_(direction.z) {}

  /// Of as many vertices as there are lanes, from the i-th on.
  [[nodiscard]] L at(int i) const {
    return simd::load<L>(polytope_.x + i) * x_ + simd::load<L>(polytope_.y + i) * y_ +
           simd::load<L>(polytope_.z + i) * z_;
  }

 private:
  const PolytopeView& polytope_;
  L x_;
  L y_;
  L z_;
};

/// The vertex that is furthest along `direction`.
template <class L = simd::Lanes>
[[nodiscard]] inline Support support(const PolytopeView& polytope, const Vec3& direction) {
  const Reaches<L> reaches(polytope, direction);
  constexpr int kStep = static_cast<int>(L::size());
  L best = reaches.at(0);
  L bestBase(0.0F);  // small whole numbers, exact in a float
  for (int i = kStep; i < polytope.count; i += kStep) {
    const L reach = reaches.at(i);
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
  const Reaches<L> reaches(polytope, direction);
  constexpr int kStep = static_cast<int>(L::size());
  L best = reaches.at(0);
  for (int i = kStep; i < polytope.count; i += kStep) {
    best = simd::stdx::max(best, reaches.at(i));
  }
  return simd::stdx::hmax(best);
}

}  // namespace scatter
