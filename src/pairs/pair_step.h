#pragma once

#include "pairs/pair.h"
#include "pairs/pair_plan.h"
#include "pairs/step_scratch.h"

namespace scatter::pairs {

/// Whether two bodies at the places where they are placed cannot be in contact, by what the pair's last look
/// has proven: neither has come far, or both together.
[[nodiscard]] bool staysQuiet(Pair& pair, const PlacedBodies& bodies);

/// Finds the contacts of a pair whose level is somebody else's business, with the bodies' shapes of that
/// level. Adds to `work`.
void collidePair(Pair& pair, int level, const PairSteps& steps, PairEngine& engine, StepScratch& scratch,
                 PairWork& work);

/// Whether a pair that has made so many queries about levels in this step keeps the contacts of the step
/// before, as its plan would have it: not if it has been foreseen, or B has come too far, which is at
/// `frameB` in A's frame. What comes upon the pair is found before its parts have moved as far against each
/// other as they may between two audits.
[[nodiscard]] bool keepsContacts(const Pair& pair, const PairPlan& plan, int queries, const Frame& frameB);

/// One step of a pair that switches: chooses its level, finds its contacts, settles its credit, looks at its
/// finest shapes if that is due. The level that is chosen is in the outcome. Adds to `work`.
[[nodiscard]] PairOutcome stepPair(Pair& pair, const PairPlan& plan, const PairSteps& steps,
                                   PairEngine& engine, StepScratch& scratch, PairWork& work);

}  // namespace scatter::pairs
