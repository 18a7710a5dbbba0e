#pragma once

#include <scatter/math.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

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

/// Places balls at random in the shell between two radii around a centre, so that no two of them overlap.
class ShellPlacement {
 public:
  ShellPlacement(Random& random, const Vec3& center, float innerRadius, float outerRadius);

  /// The centre of a ball of `radius` that is clear of all balls placed before. The shell widens by a
  /// little whenever it has become too full.
  Vec3 place(float radius);

 private:
  struct Ball {
    Vec3 center;
    float radius;
  };

  [[nodiscard]] bool isClear(const Ball& candidate) const;

  Random& random_;
  Vec3 center_;
  float inner_;
  float outer_;
  std::vector<Ball> balls_;
};

}  // namespace scatter
