#pragma once

#include "pairs/held_contacts.h"

namespace scatter::pairs {

/// Adds to the distances of a manifold's points, and eases them: where credit is at work, a distance below
/// zero is no error to be corrected.
void addCredit(void* manifold, float credit, PairEngine& engine);

/// Ends the ease of a manifold's points. One that is still deep keeps its ease until it is found anew: it may
/// be older than where the parts are now.
void endCredit(void* manifold, PairEngine& engine);

/// How deep the contacts of a manifold press the bodies apart where the bodies are now, metres.
[[nodiscard]] float pressNow(const void* manifold, const PairEngine& engine);

/// The contacts of a pair in one step.
struct ContactTally {
  int manifolds = 0;
  int points = 0;
  float least = HeldContacts::kNone;  ///< Their least distance.
  float press = 0.0F;                 ///< How deep they press the bodies apart, metres.

  void add(const void* manifold, const PairEngine& engine);
};

}  // namespace scatter::pairs
