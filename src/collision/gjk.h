#pragma once

#include <cstdint>

#include "collision/frame.h"
#include "collision/support.h"

namespace scatter {

/// The vertices that GJK ended with, from which it starts the next time.
struct WarmSimplex {
  std::uint16_t a[3]{};
  std::uint16_t b[3]{};
  std::uint8_t count = 0;
};

/// The vertices, of either polytope, of differences whose hull holds the origin, or all but does.
struct OverlapSimplex {
  std::uint16_t a[4]{};
  std::uint16_t b[4]{};
  std::uint8_t count = 0;
};

struct GjkResult {
  enum class State : std::uint8_t {
    kApart,      ///< Further apart than `enough`; GJK stopped there.
    kConverged,  ///< `distance`, `pointA` and `pointB` are right to the tolerance.
    kOverlap,    ///< The polytopes overlap, or all but touch.
    kUndecided,  ///< Neither proved: nearly degenerate polytopes.
  };
  State state = State::kUndecided;

  /// The largest separation that a plane proved, rounding taken off; negative if none did.
  float provenDistance = 0.0F;
  Vec3 provenAxis{0.0F};  ///< Of that plane, of length 1, from A to B.

  float distance = 0.0F;
  Vec3 axis{0.0F};  ///< From A to B, of length 1.
  Vec3 pointA{0.0F};
  Vec3 pointB{0.0F};
  int iterations = 0;

  OverlapSimplex overlap{};  ///< Of kOverlap.
};

/// The distance of two convex polytopes (Gilbert, Johnson, Keerthi 1988), in A's frame. `b` is given in its
/// own frame, which is `frameB` in A's. Starts from `warm` if that holds vertices, else along `axis`, which
/// has length 1; leaves its last simplex in `warm`. Stops as soon as a plane proves a separation of more
/// than `enough`, or the distance is known to within `tolerance` (metres) and a ten-thousandth of itself.
[[nodiscard]] GjkResult gjkDistance(const PolytopeView& a, const PolytopeView& b, const Frame& frameB,
                                    const Vec3& axis, float enough, float tolerance, WarmSimplex& warm);

}  // namespace scatter
