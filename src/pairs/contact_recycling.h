#pragma once

#include <limits>
#include <vector>

#include "pairs/pair_engine.h"

namespace scatter::pairs {

/// Contacts that have turned by more than this are found anew, radians: one degree. Normals are wrong by no
/// more than that.
inline constexpr float kMostRecycledTurn = 0.0175F;

/// Memory that recycling uses in turn.
struct RecyclingScratch {
  std::vector<int> touching{};  ///< Child pairs with contacts.
  std::vector<float> slides{};  ///< Of each of them.
};

/// Lets the contacts of two bodies move along with them, in the place of finding them anew, while the bodies
/// move little against each other (PairSteps::recycling). Contacts of parts are let alone only when a look
/// has found no more of them than there were: engines gather the points of a manifold one in a step.
class ContactRecycling {
 public:
  ContactRecycling(PartPair& parts, const PlacedBodies& bodies, float tolerance, RecyclingScratch& scratch)
      : parts_(parts), bodies_(bodies), tolerance_(tolerance), scratch_(scratch) {}

  /// Once the bodies have been placed: whether there is nothing to be looked for in this step, and the pair
  /// is done. `slideOf(contact)` is what Manifolds::carry() returns; `fetch(contact)`: it is going to be
  /// asked.
  template <class SlideOf, class Fetch>
  [[nodiscard]] bool look(SlideOf&& slideOf, Fetch&& fetch) {
    scratch_.touching.clear();
    scratch_.slides.clear();
    for (const WakefulChild& one : parts_.wakeful()) {
      if (!one.touching || !childAt(one.index).touching) continue;
      fetch(childAt(one.index).contact);
      scratch_.touching.push_back(one.index);
    }
    bool isDone = parts_.hasNoNewcomers(*bodies_.a, *bodies_.b);
    for (const int i : scratch_.touching) {
      const float slid = slideOf(childAt(i).contact);
      isDone = isDone && !isStale(childAt(i), slid);
      scratch_.slides.push_back(slid);
    }
    return isDone && !scratch_.touching.empty();
  }

  /// After a look: child pairs whose contacts must be found anew are stale from now on; those that have no
  /// point left have no contact any more, after `drop(contact)`.
  template <class Drop>
  void settle(Drop&& drop) {
    for (std::size_t k = 0; k < scratch_.touching.size(); ++k) {
      ChildPair& child = childAt(scratch_.touching[k]);
      child.stale = isStale(child, scratch_.slides[k]);
      child.touching = scratch_.slides[k] < std::numeric_limits<float>::infinity();
      if (child.touching) continue;
      drop(child.contact);
      child.contact = nullptr;
    }
  }

 private:
  [[nodiscard]] ChildPair& childAt(int index) const {
    return parts_.children()[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] bool isStale(const ChildPair& child, float slid) const {
    return !child.settled || !(slid < tolerance_) || !(parts_.turn() - child.turnAt < kMostRecycledTurn);
  }

  PartPair& parts_;
  const PlacedBodies& bodies_;
  float tolerance_;
  RecyclingScratch& scratch_;
};

}  // namespace scatter::pairs
