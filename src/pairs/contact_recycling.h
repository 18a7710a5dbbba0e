#pragma once

#include <vector>

#include "pairs/pair.h"

namespace scatter::pairs {

/// Contacts that have turned by more than this are found anew, radians: one degree. Normals are wrong by no
/// more than that.
inline constexpr float kMostRecycledTurn = 0.0175F;

/// Lets the contacts of two bodies move along with them, in the place of finding them anew, while the bodies
/// move little against each other (PairSteps::recycling). Contacts of parts are let alone only when a look
/// has found no more of them than there were: engines gather the points of a manifold one in a step.
class ContactRecycling {
 public:
  ContactRecycling(PartPair& parts, const PlacedBodies& bodies, PairEngine& engine, float tolerance)
      : parts_(parts), bodies_(bodies), engine_(engine), tolerance_(tolerance) {}

  /// Once the bodies have been placed: takes in where they are. Child pairs whose contacts must be found anew
  /// are stale from now on. Whether there is nothing to be looked for in this step; then `touching` has the
  /// child pairs with contacts, and the pair is done.
  [[nodiscard]] bool run(std::vector<int>& touching);

 private:
  [[nodiscard]] bool isStale(const ChildPair& child, float slid) const;

  PartPair& parts_;
  const PlacedBodies& bodies_;
  PairEngine& engine_;
  float tolerance_;
};

}  // namespace scatter::pairs
