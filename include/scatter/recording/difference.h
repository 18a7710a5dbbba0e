#pragma once

#include <scatter/recording/recording.h>
#include <scatter/result.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace scatter {

/// A body that is not the same in two runs, and in what.
struct BodyDifference {
  BodyId body{};
  std::string name;

  /// Such as "linear velocity", "level", "sleep", "presence" (only one run has it) or "request" (what
  /// happened to its levels).
  std::vector<std::string> quantities;

  /// By how much its stored positions and orientations differ, metres and radians; zero if that is less than
  /// what recordings keep.
  float metres = 0.0F;
  float radians = 0.0F;
};

/// The first frame in which two runs part.
struct RunDifference {
  std::uint64_t frame = 0;
  std::vector<BodyDifference> bodies;  ///< In the first run's order, then what only the second has.

  /// Quantities whose exact bits differ somewhere, but for which no body is named: its check is the same by
  /// chance, for which the odds are 1 to 255 a body. Such as "orientation".
  std::vector<std::string> unplaced;
};

struct RunComparison {
  std::uint64_t first = 0;  ///< Of the frames that both have,
  std::uint64_t last = 0;   ///< and up to the one in which they part.
  std::optional<RunDifference> difference{};
};

/// Compares two runs frame by frame, bit by bit: bodies, positions, orientations, velocities, levels, sleep
/// and level events, not times. Fails if they have no frame in common, or one is damaged.
[[nodiscard]] Result<RunComparison> compareRecordings(const Recording& a, const Recording& b);

}  // namespace scatter
