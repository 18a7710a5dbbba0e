#pragma once

#include <experimental/simd>

namespace scatter::simd {

namespace stdx = std::experimental;

/// As many floats as the machine that is compiled for takes at once: four with SSE2, eight with AVX.
using Lanes = stdx::native_simd<float>;

/// One float, for tests: kernels are templates over the lanes and give the same bits for any of them.
using OneLane = stdx::simd<float, stdx::simd_abi::scalar>;

/// Arrays that kernels read are padded to a multiple of this. Parts have few vertices: more would be mostly
/// padding.
inline constexpr int kPadding = static_cast<int>(Lanes::size());

[[nodiscard]] constexpr int padded(int count) {
  return (count + kPadding - 1) / kPadding * kPadding;
}

template <class L>
[[nodiscard]] inline L load(const float* from) {
  return L(from, stdx::element_aligned);
}

/// Calls `visit(lane)` for every lane that is set, in ascending order.
template <class Mask, class Visit>
inline void forEachSet(const Mask& mask, Visit visit) {
  if (stdx::none_of(mask)) {
    return;
  }
  for (std::size_t lane = 0; lane < mask.size(); ++lane) {
    if (mask[lane]) {
      visit(static_cast<int>(lane));
    }
  }
}

}  // namespace scatter::simd
