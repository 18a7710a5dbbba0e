#pragma once

#include <vector>

#include "pairs/pair.h"

namespace scatter::pairs {

/// Looks for the contacts of the child pairs of two bodies at one level, after PartPair::advance().
class ChildPass {
 public:
  /// `credit`: child pairs on credit have no contacts of their own while those that are held are good; null
  /// at other levels. An audit that is due but cannot be afforded may be late, but not for long. `recycles`:
  /// contacts have been moved along by ContactRecycling, and only those that are stale are found anew.
  /// `foresight`: what is known already, or null. All must outlive it.
  ChildPass(PartPair& parts, const PlacedBodies& bodies, const PairSteps& steps, PairEngine& engine,
            PairWork& work, const CreditState* credit, float auditsFrom, bool recycles,
            const Foresight* foresight = nullptr)
      : parts_(parts),
        bodies_(bodies),
        steps_(steps),
        engine_(engine),
        work_(work),
        credit_(credit),
        auditsFrom_(auditsFrom),
        recycles_(recycles),
        foresight_(foresight),
        bounds_(*bodies.a, *bodies.b) {}

  /// `awake`: the child pairs that it has looked at.
  void run(std::vector<int>& awake);

 private:
  void findAwake(std::vector<int>& awake);
  void collide(ChildPair& child, const ChildLook* seen);
  void keepOrDrop(ChildPair& child);
  void find(ChildPair& child, const ChildLook* seen);
  [[nodiscard]] bool overlap(const ChildPair& child, const ChildLook* seen);
  [[nodiscard]] bool stillTouches(const ChildPair& child) const;
  void drop(ChildPair& child);
  [[nodiscard]] bool isExcused(ChildPair& child) const;
  [[nodiscard]] bool areSpheres(const ChildPair& child) const;

  PartPair& parts_;
  const PlacedBodies& bodies_;
  const PairSteps& steps_;
  PairEngine& engine_;
  PairWork& work_;
  const CreditState* credit_;
  float auditsFrom_;
  bool recycles_;
  const Foresight* foresight_;
  BoundsTest bounds_;
};

}  // namespace scatter::pairs
