#pragma once

#include <cstddef>
#include <cstdint>

namespace scatter::recording {

/// What frames are parted into, so that alike bytes are compressed together.
enum Stream : std::size_t {
  kStructure,  ///< Which bodies there are, which have moved, their levels and sleep.
  kPositions,
  kRotations,
  kChecks,
  kEvents,
  kContacts,
  kValues,
  kStreamCount,
};

/// The most that the streams of a block may hold together, and its bodies times its frames, for a reader not
/// to run out of memory.
inline constexpr std::size_t kMostBlockBytes = std::size_t{64} << 20U;
inline constexpr std::size_t kMostBodyFrames = std::size_t{4} << 20U;
inline constexpr std::size_t kMostBlockFrames = 65536;

inline constexpr std::uint8_t kAsleep = 0x80;  // beside the level, in one byte
inline constexpr std::uint8_t kLargestLevel = 0x7F;

/// Of what contacts are stored in.
inline constexpr float kContactNormal = 1.0F / 1024.0F;

}  // namespace scatter::recording
