#pragma once

#include <scatter/lab/hands.h>
#include <scatter/math.h>

namespace scatter::lab {

/// What a pull gives a point in one step, metres per second squared. `offset` leads from the point to its
/// target. By the implicit Euler method, so that no step is too long for the stiffness.
[[nodiscard]] Vec3 pullAcceleration(const PullDef& def, const Vec3& offset, const Vec3& velocity,
                                    float seconds);

/// Learns the acceleration that something has beside the one that it is given: gravity, fields, what rests
/// on it. Follows in about five steps, so that a bump hardly counts.
class SteadyLoad {
 public:
  /// Metres per second squared; what is beyond is not carried.
  static constexpr float kLargest = 30.0F;

  /// Takes in what the last step has done beyond what was given to it.
  void follow(const Vec3& unexplained);

  [[nodiscard]] const Vec3& acceleration() const { return acceleration_; }

 private:
  Vec3 acceleration_{0.0F};
};

}  // namespace scatter::lab
