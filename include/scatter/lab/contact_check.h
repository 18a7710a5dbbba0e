#pragma once

#include <scatter/world/collision.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace scatter {

struct FrameMiss {
  std::uint64_t frame = 0;  ///< Counts from 1.
  MissedContact contact;
};

/// How contacts compared with the engine's over a run: see CollisionDef::verifyEvery.
struct ContactCheck {
  static constexpr std::size_t kMissesKept = 20;

  std::uint64_t steps = 0;  ///< Verified.
  std::uint64_t childPairs = 0;
  std::uint64_t expected = 0;
  std::uint64_t missed = 0;
  std::uint64_t extra = 0;
  std::uint64_t doubtful = 0;
  std::vector<FrameMiss> firstMissed;  ///< At most kMissesKept.

  /// Takes in the report after the step of `frame`; call it after every step.
  void follow(std::uint64_t frame, const ContactReport& report);
};

}  // namespace scatter
