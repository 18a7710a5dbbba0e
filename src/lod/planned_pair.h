#pragma once

#include <cstdint>

#include "lod/cost_model.h"
#include "lod/policy.h"

namespace scatter::lod {

/// A pair as the governor plans it. Kept from step to step by the pair's owner; dense, in an order that is
/// the same run after run.
struct PlannedPair {
  PairView view{};
  Wish wish{};
  PairCost cost{};

  /// Pairs whose detail costs alike: the logarithm of how many child pairs there are at the finest level.
  static constexpr int kKinds = 32;
  std::uint8_t kind = 0;

  std::uint32_t identity = 0;  ///< Tells it from others, the same run after run.

  /// A switch was not safe: not to be tried again for so many steps.
  std::uint8_t blockedSteps = 0;

  float relieved = 0.0F;     ///< Units a step that it did cost when it was last relieved of its detail.
  float expected = 0.0F;     ///< Units that the step under way is expected to take for it, not corrected.
  float taken = 0.0F;        ///< Units that the step under way, or made last, took for it.
  float bound = 0.0F;        ///< Of these, what it would have taken at any level that it may have had.
  std::uint8_t target = 0;   ///< The plan: the level that the pair should have; 0: not planned yet.
  bool mustSave = false;     ///< The finer target is the cheaper one: not to be put off for want of budget.
  bool hasContacts = false;  ///< In its last step, however far apart their points are.
  bool rests = false;  ///< The last step left it out, as it is asleep or does not collide: it cannot switch.
  bool byBudget = false;  ///< The governor, not a policy, took detail away.
};

}  // namespace scatter::lod
