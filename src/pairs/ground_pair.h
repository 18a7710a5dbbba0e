#pragma once

#include <vector>

#include "pairs/pair.h"
#include "pairs/passage.h"
#include "pairs/region.h"

namespace scatter::pairs {

/// The contacts of one part of a body with its ground.
struct GroundContact {
  int part = 0;
  void* manifold = nullptr;
  float credit = 0.0F;  ///< That is added to the distances of its points, metres.
};

/// A body of parts and what it may lie on: a half-space, triangles, or a convex shape that is large beside
/// it. What they know of each other from step to step. Owns its manifolds; they are the engine's to free,
/// which must have happened before its end.
struct GroundPair {
  GroundPair() { parts.followPieces(); }

  /// Nothing can be in contact while the body's travel is less than `quietUntil`, it has not jumped, and the
  /// ground is where it was.
  double quietUntil = Pair::kAwake;
  int jumps = 0;
  Frame ground{};
  int level = 0;  ///< Whose shapes the contacts are of; 0: it has not looked yet.
  int versions[2]{Pair::kNoParts, Pair::kNoParts};  ///< Of the body's parts and of the ground.

  PartPair parts{};  ///< Of the region, as A, and of the body at the pair's level.
  Region region{};
  std::vector<GroundContact> contacts{};  ///< In the order of their parts.
  bool hasFallenBack = false;             ///< The engine's own algorithm collides the two.
  bool isTooFine =
      false;  ///< It does so because there are too many pieces, and is not disturbed while it has contacts.
  bool restarted = false;  ///< It began without contacts in its last step.
  int landing = 0;  ///< Steps in contact, after a switch to a finer level, in which the body may still land.

  /// Where the body was in the ground's frame at the last look for contacts, and whether it found no more of
  /// them than there were.
  Frame looked{};
  bool isSettled = false;
  bool hasRecycled = false;  ///< In its last step it did not look for all contacts (PairSteps::recycling).
  PassageWatch passage{};

  /// Of the step under way, until it has been made use of. Has no contacts.
  Foresight* foresight = nullptr;

  /// Calls `use(manifold)` for all, which may be changed.
  template <class Use>
  void forEachContact(Use&& use) {
    for (GroundContact& contact : contacts) use(contact.manifold);
  }

  /// Gives the manifolds back, and forgets what was known of distances; not what of the ground is near.
  void restart(float threshold, Manifolds& engine);

  /// As new, but with the memory that it has. The manifolds must be gone.
  void renew();
};

}  // namespace scatter::pairs
