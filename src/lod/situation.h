#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "collision/frame.h"

namespace scatter::lod {

/// What policies are told of a body that is in a pair. World axes, SI units.
struct BodyView {
  Vec3 center{0.0F};  ///< Of mass.
  Vec3 velocity{0.0F};
  float radius = 0.0F;     ///< Of a ball around `center` that holds level 1.
  float mass = 0.0F;       ///< 0 if nothing moves it.
  bool held = false;       ///< The user has it in hand.
  bool present = false;    ///< There is such a body; the others of the table are holes.
  std::uint8_t asked = 0;  ///< The level that the program asks for in all its pairs; 0: none.
};

/// Two bodies whose broadphase bounds overlap, at least one of which has levels. The level of a pair counts
/// from 1, the coarsest; a body with fewer levels takes part with its finest.
struct PairView {
  std::uint32_t a = 0;  ///< Indices into Situation::bodies.
  std::uint32_t b = 0;
  std::uint8_t level = 0;   ///< In use; 0 if the pair is new.
  std::uint8_t finest = 1;  ///< The pair's number of levels.
  bool touching = false;
  bool credited = false;           ///< Its shapes overlap on credit.
  std::uint16_t contactSteps = 0;  ///< Steps that it has been touching without a break; stops at the largest.
};

/// Where the viewer looks, if there is one.
struct Focus {
  Vec3 eye{0.0F};
  Vec3 target{0.0F};
  float fieldOfView = 1.0F;  ///< Vertical, radians.
};

/// What the last step cost against what it may cost.
struct Load {
  double units = 0.0;   ///< Of the last step.
  double budget = 0.0;  ///< 0: no budget.
};

/// The world as policies see it before a narrowphase.
struct Situation {
  std::span<const BodyView> bodies{};
  std::span<const PairView> pairs{};
  std::optional<Focus> focus{};
  Load load{};
  std::uint64_t step = 0;
};

}  // namespace scatter::lod
