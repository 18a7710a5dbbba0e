#pragma once

#include <LinearMath/btTransform.h>

#include <cmath>
#include <cstdint>

namespace scatter::bench {

/// SplitMix64 (Steele, Lea, Flood 2014): the same numbers on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  /// From `least` to `most`, evenly.
  float in(float least, float most) { return least + (most - least) * unit(); }
  int in(int least, int most) {
    return least + static_cast<int>(next() % static_cast<std::uint64_t>(most - least + 1));
  }

  btVector3 inCube(float half) {
    const float x = in(-half, half);
    const float y = in(-half, half);
    return {x, y, in(-half, half)};
  }

  btQuaternion rotation() {
    btVector3 axis(0, 0, 0);
    while (axis.length2() < btScalar(0.01)) axis = inCube(1);
    return {axis.normalized(), in(0.0F, 2 * SIMD_PI)};
  }

 private:
  float unit() { return static_cast<float>(next() >> 40) * 0x1p-24F; }

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15U);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

}  // namespace scatter::bench
