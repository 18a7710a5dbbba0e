#pragma once

#include <scatter/math.h>

#include <optional>
#include <span>
#include <vector>

namespace scatter::viewer {

/// A part of the world, metres.
struct Ball {
  Vec3 center{0.0F};
  float radius = 10.0F;
};

/// A body that can move, as a camera sees it.
struct Actor {
  Vec3 position{0.0F};
  float radius = 0.0F;  ///< Around the position, metres.
  float moved = 0.0F;   ///< In the last frame, metres.
  bool asleep = false;
  bool meeting = false;  ///< Its ball and that of another body overlap.
};

/// Fills in which of the bodies of one world meet.
void markMeetings(std::span<Actor> actors);

/// What is worth looking at: where bodies meet, if a good part of them does, else all; what rests counts
/// little, the few that move among many that do not count much, and stragglers do not count at all. Never so
/// large that a typical body would be a speck in the picture. Nothing without actors.
[[nodiscard]] std::optional<Ball> findAction(std::span<const Actor> actors);

/// How much of what is worth looking at is a crowd: 0 if bodies meet by chance, 1 if a good part of them
/// does.
[[nodiscard]] float crowding(std::span<const Actor> actors);

/// The median of all places, which a few bodies that are far away do not move.
[[nodiscard]] Vec3 middleOf(std::span<const Actor> actors);

/// All bodies, without the tenth that is furthest out.
[[nodiscard]] std::optional<Ball> extentOf(std::span<const Actor> actors);

}  // namespace scatter::viewer
