#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

namespace scatter::solver {

/// Four floats that are worked on at once: SSE2, NEON, or what the compiler makes of it. Compares to masks of
/// integers, which choose as `mask ? a : b`.
using Lanes = float __attribute__((vector_size(16)));
using LaneMask = int __attribute__((vector_size(16)));
inline constexpr int kLanes = 4;

/// Four numbers of one thing, as they lie in memory.
struct alignas(16) Quad {
  float x;
  float y;
  float z;
  float w;
};

[[nodiscard]] inline Lanes lanes(float value) {
  return Lanes{value, value, value, value};
}

[[nodiscard]] inline Lanes lanes(const Quad& quad) {
  Lanes result;
  std::memcpy(&result, &quad, sizeof result);
  return result;
}

[[nodiscard]] inline Lanes atLeast(const Lanes& a, const Lanes& b) {
  return a > b ? a : b;
}

[[nodiscard]] inline Lanes atMost(const Lanes& a, const Lanes& b) {
  return a < b ? a : b;
}

[[nodiscard]] inline Lanes magnitude(const Lanes& a) {
  return atLeast(a, -a);
}

[[nodiscard]] inline Lanes root(const Lanes& a) {
  return Lanes{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
}

inline void store(const Lanes& from, Quad& to) {
  std::memcpy(&to, &from, sizeof to);
}

/// A quad with another w. In a register: to read all of what a part was just written of makes a processor
/// wait.
[[nodiscard]] inline Lanes withW(const Quad& quad, float w) {
  Lanes result = lanes(quad);
  result[3] = w;
  return result;
}

/// The first lane whose mask is set; kLanes if none is.
[[nodiscard]] inline int firstOf(const LaneMask& mask) {
  std::uint64_t halves[2]{};
  std::memcpy(halves, &mask, sizeof halves);
  if ((halves[0] | halves[1]) == 0) return kLanes;
  return halves[0] != 0 ? (mask[0] != 0 ? 0 : 1) : mask[2] != 0 ? 2 : 3;
}

/// A vector in each lane.
struct LaneVector {
  Lanes x;
  Lanes y;
  Lanes z;
};

[[nodiscard]] inline LaneVector operator+(const LaneVector& a, const LaneVector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

[[nodiscard]] inline LaneVector operator-(const LaneVector& a, const LaneVector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

[[nodiscard]] inline LaneVector operator-(const LaneVector& a) {
  return {-a.x, -a.y, -a.z};
}

/// Component by component.
[[nodiscard]] inline LaneVector operator*(const LaneVector& a, const LaneVector& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

[[nodiscard]] inline LaneVector operator*(const LaneVector& a, const Lanes& s) {
  return {a.x * s, a.y * s, a.z * s};
}

[[nodiscard]] inline Lanes dot(const LaneVector& a, const LaneVector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

[[nodiscard]] inline LaneVector cross(const LaneVector& a, const LaneVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

[[nodiscard]] inline LaneVector choose(const LaneMask& mask, const LaneVector& a, const LaneVector& b) {
  return {mask ? a.x : b.x, mask ? a.y : b.y, mask ? a.z : b.z};
}

/// Four quads' x, y, z and w.
struct LaneQuad {
  LaneVector v;
  Lanes w;
};

#ifdef __clang__
#define SCATTER_SHUFFLE(a, b, i, j, k, l) __builtin_shufflevector(a, b, i, j, k, l)
#else
#define SCATTER_SHUFFLE(a, b, i, j, k, l) __builtin_shuffle(a, b, LaneMask{i, j, k, l})
#endif

/// From one quad a lane to one component a register, and back: it is its own inverse.
[[nodiscard]] inline LaneQuad transposed(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) {
  const Lanes abLow = SCATTER_SHUFFLE(a, b, 0, 4, 1, 5);
  const Lanes cdLow = SCATTER_SHUFFLE(c, d, 0, 4, 1, 5);
  const Lanes abHigh = SCATTER_SHUFFLE(a, b, 2, 6, 3, 7);
  const Lanes cdHigh = SCATTER_SHUFFLE(c, d, 2, 6, 3, 7);
  return {{SCATTER_SHUFFLE(abLow, cdLow, 0, 1, 4, 5), SCATTER_SHUFFLE(abLow, cdLow, 2, 3, 6, 7),
           SCATTER_SHUFFLE(abHigh, cdHigh, 0, 1, 4, 5)},
          SCATTER_SHUFFLE(abHigh, cdHigh, 2, 3, 6, 7)};
}

#undef SCATTER_SHUFFLE

}  // namespace scatter::solver
