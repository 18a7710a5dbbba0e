#pragma once

#include <scatter/collision/pair_algorithm.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace scatter {

/// What decides how hybrid bodies touch others in a hybrid world. Pairs without a hybrid are always the
/// engine's own.
enum class Narrowphase : std::uint8_t {
  kScatter,  ///< The pair algorithm for two lists of convex parts.
  kEngine,   ///< The engine's own algorithms.
};

/// The narrowphase of hybrid bodies. Has no meaning in a standard world.
struct CollisionDef {
  Narrowphase narrowphase = Narrowphase::kScatter;
  PairSteps pairAlgorithm{};

  /// Compares the contacts of hybrid bodies with those of the engine's own collision world beside this one,
  /// every so many steps; 0: never. Slow, in every step, and its time counts as the step's; changes nothing
  /// else.
  int verifyEvery = 0;
};

/// A child pair that should be in contact and is not.
struct MissedContact {
  std::string bodyA;
  std::string bodyB;
  int childA = -1;  ///< Index of the part at the level in use; -1 for a body of one shape.
  int childB = -1;
  float distance = 0.0F;  ///< Metres, negative if deep.
};

/// How contacts compared with the engine's in all verified steps so far; btHybridContactReport says what
/// exactly.
struct ContactReport {
  std::uint64_t steps = 0;       ///< Verified.
  std::uint64_t childPairs = 0;  ///< That the engine's midphase has let through.
  std::uint64_t expected = 0;    ///< Child pairs in contact in the engine.
  std::uint64_t missed = 0;      ///< Of those, without a contact in the world.
  std::uint64_t extra = 0;       ///< In contact in the world and not in the engine.

  /// Counted in none of these: differences that rounding decides, and those in which the engine is proven
  /// wrong.
  std::uint64_t doubtful = 0;
  std::vector<MissedContact> lastMissed;  ///< Of the last verified step.
};

/// What the pair algorithm holds at the moment, without contact caches.
struct CollisionMemory {
  std::uint64_t pairs = 0;
  std::uint64_t childPairs = 0;
  std::uint64_t pairBytes = 0;       ///< Of all pairs, without their child pairs.
  std::uint64_t childPairBytes = 0;  ///< Of all child pairs, room for growth included.
  std::uint64_t bodyBytes = 0;
  std::uint64_t partBytes = 0;  ///< Of all part lists.
};

}  // namespace scatter
