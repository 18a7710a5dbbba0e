#pragma once

#include <scatter/math.h>

#include <cstddef>
#include <cstdint>
#include <random>

namespace scatter {

/// Seeded randomness whose results are the same on every platform.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  float uniform(float low, float high);
  std::size_t below(std::size_t count);  ///< From 0 to count - 1; count is far below 2^32.
  Vec3 direction();                      ///< Evenly over the unit sphere.
  Quat orientation();                    ///< Evenly over all rotations.
  Vec3 insideUnitBall();

 private:
  std::mt19937_64 engine_;
};

}  // namespace scatter
