#pragma once

#include <scatter/math.h>
#include <scatter/world/body.h>
#include <scatter/world/level_event.h>
#include <scatter/world/state_bits.h>

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace scatter {

/// What is stored of a pose: its position to this many metres, the four numbers of its orientation to this
/// much. A point of a body is where it was but for half of the one and its distance from the middle times the
/// other.
/// @{
inline constexpr float kRecordedMetres = 1.0F / 8192.0F;
inline constexpr float kRecordedTurn = 1.0F / 32768.0F;
/// @}

/// What a state is made of, for those who compare two.
enum class StateQuantity : std::uint8_t { kPosition, kOrientation, kLinearVelocity, kAngularVelocity };
inline constexpr std::size_t kStateQuantityCount = 4;

/// The level at which two bodies meet, 1 the coarsest; at most 255.
struct PairLevel {
  BodyId a{};
  BodyId b{};
  std::uint8_t level = 0;
};

/// A contact point, as ObservedContact has it. Lengths are stored to 1/8192 m, the normal to 1/1024.
struct RecordedContact {
  BodyId a{};
  BodyId b{};
  Vec3 pointA{0.0F};
  Vec3 normal{0.0F};  ///< From B to A.
  float distance = 0.0F;
  float credit = 0.0F;
  float impulse = 0.0F;  ///< Exact.
};

/// A body in a frame that is to be stored.
struct SampledBody {
  BodyId body{};
  std::uint8_t level = 1;  ///< At most 127.
  bool asleep = false;
  Transform pose{};
  StateBits bits{};
};

/// A frame that is to be stored.
struct FrameSample {
  std::uint64_t number = 0;         ///< World::frame().
  std::vector<SampledBody> bodies;  ///< All, in the world's order.
  std::vector<LevelEvent> events;
  std::vector<PairLevel> pairs;  ///< On demand, as contacts are.
  std::vector<RecordedContact> contacts;
  std::vector<std::uint64_t> values;  ///< Of the recording's channels: bits of doubles, or hashes.

  /// Bodies that no frame before had, and what they were made from.
  std::vector<std::pair<BodyId, BodyDef>> added;

  /// Keeps the memory.
  void clear();
};

/// A body in a frame that was read.
struct RecordedBody {
  Transform pose{};
  std::uint8_t level = 1;
  bool asleep = false;

  /// By StateQuantity, of its exact bits: states that differ in one bit have different ones, and any two
  /// others in 255 of 256 cases.
  std::array<std::uint8_t, kStateQuantityCount> checks{};
};

/// A frame that was read.
struct RecordedFrame {
  std::uint64_t number = 0;
  std::shared_ptr<const std::vector<BodyId>> roster;  ///< Its bodies; shared by frames with the same.
  std::vector<RecordedBody> bodies;                   ///< One for each of the roster.

  /// By StateQuantity, of the exact bits of all bodies in the roster's order.
  std::array<std::uint64_t, kStateQuantityCount> hashes{};
  std::vector<LevelEvent> events;  ///< Their names live as long as the recording.
  std::vector<PairLevel> pairs;
  std::vector<RecordedContact> contacts;
  std::vector<std::uint64_t> values;

  [[nodiscard]] std::size_t bytes() const;  ///< Of memory, about; without the roster.
};

}  // namespace scatter
