#pragma once

#include "pairs/pair.h"
#include "pairs/step_scratch.h"

namespace scatter::pairs {

/// Whether contacts may move along with the bodies: what is on credit is settled by contacts that have just
/// been found.
[[nodiscard]] bool mayRecycle(const Pair& pair, const PairSteps& steps);

/// One look for the contacts of two bodies with their shapes of one level.
class LevelLook {
 public:
  LevelLook(Pair& pair, const PairSteps& steps, PairEngine& engine, StepScratch& scratch, PairWork& work)
      : pair_(pair), steps_(steps), engine_(engine), scratch_(scratch), work_(work) {}

  /// With the pair's own child pairs, at its level; `returns`: the contacts held are given back to them.
  /// Where a shape is no list of parts, the engine collides the bodies. The child pairs that were looked at
  /// are in StepScratch::looked.
  void atLevel(int level, bool returns, float auditsFrom);

  /// At the finest level of a pair that is at a coarser one, from scratch: the contacts go to those that are
  /// held.
  void atFinest(int level);

 private:
  bool place(int level, PlacedBodies& bodies);
  void restart(PartPair& parts) const;
  bool advance(PartPair& parts, const PlacedBodies& bodies);
  void useForesight(const PlacedBodies& bodies, float auditsFrom);
  [[nodiscard]] const CreditState* coarserCredit() const;
  [[nodiscard]] bool recycle(const PlacedBodies& bodies);
  void endRecycled(const std::vector<int>& touching);

  Pair& pair_;
  const PairSteps& steps_;
  PairEngine& engine_;
  StepScratch& scratch_;
  PairWork& work_;
};

}  // namespace scatter::pairs
