#pragma once

#include <scatter/math.h>

namespace scatter::pairs {

/// One contact of two bodies, as the pair that has it looks at it. World axes, metres.
struct ContactPoint {
  Vec3 position{0.0F};    ///< On B's surface.
  Vec3 normal{0.0F};      ///< On B's surface, of length 1.
  float distance = 0.0F;  ///< From surface to surface, with the credit that was added; negative if deep.
  float impulse = 0.0F;   ///< That it bore along its normal in the last step, newton seconds.
  int partA = 0;
  int partB = 0;

  /// Presses the bodies apart while it is deep. One without error reduction takes their approach away, but
  /// does not.
  bool presses = true;

  /// Has no error reduction because of penetration credit; whoever took it away gives it back.
  bool eased = false;
};

}  // namespace scatter::pairs
