#pragma once

#include "pairs/ground_pair.h"
#include "pairs/pair_plan.h"
#include "pairs/step_scratch.h"

namespace scatter::pairs {

/// The coarsest level that a body takes part with on a ground: the middle one. A coarser shape would make it
/// float by what it is larger all around; with a body of one or two levels, the finest.
[[nodiscard]] constexpr int coarsestOnGround(int finest) {
  return finest / 2 + 1;
}

/// Whether a body and a ground at the places where they are placed cannot be in contact, by what the last
/// look has proven, and will not be before the body has gone `ahead`, metres.
[[nodiscard]] inline bool staysQuiet(const GroundPair& pair, const PlacedBody& placed, const Frame& ground,
                                     int groundVersion, float ahead) {
  return placed.body->travel() + static_cast<double>(ahead) < pair.quietUntil &&
         placed.body->jumps() == pair.jumps && placed.version == pair.versions[0] &&
         groundVersion == pair.versions[1] && ground == pair.ground;
}

/// Finds the contacts of a body, with its shape of a level that is somebody else's business, with its ground.
/// Adds to `work`.
void collideGround(GroundPair& pair, int level, const PairSteps& steps, GroundEngine& engine,
                   StepScratch& scratch, PairWork& work);

/// One step of a body that switches and its ground: takes the level that it should have, with the overlap
/// that this brings as credit of each part, and finds the contacts. The level is in the outcome. Adds to
/// `work`.
[[nodiscard]] PairOutcome stepGround(GroundPair& pair, const PairPlan& plan, const PairSteps& steps,
                                     GroundEngine& engine, StepScratch& scratch, PairWork& work);

}  // namespace scatter::pairs
