#pragma once

#include <cstdint>
#include <vector>

#include "pairs/fake_engine.h"
#include "pairs/pair_step.h"

namespace scatter::testing {

/// Two bodies with the same levels, and what the planner of their pair knows of it.
struct LivingPair {
  explicit LivingPair(const std::vector<std::vector<PartDef>>& levels) : engine(levels) {
    plan.view.finest = static_cast<std::uint8_t>(levels.size());
    plan.target = plan.view.finest;
    plan.auditDistance = 0.03F;
    plan.auditsFrom = lod::lateness::kDue;
  }
  LivingPair(const LivingPair&) = delete;
  LivingPair& operator=(const LivingPair&) = delete;
  ~LivingPair() { pair.dropAll(engine); }

  pairs::PairOutcome step(float x) {
    engine.x = x;
    plan.tries = plan.target != plan.view.level;
    const pairs::PairOutcome outcome = stepPair(pair, plan, steps, engine, scratch, work);
    if (outcome.tried) plan.view.level = static_cast<std::uint8_t>(outcome.choice.level);
    plan.view.touching = outcome.touching;
    plan.view.credited = outcome.credited;
    return outcome;
  }

  FakeEngine engine;
  pairs::Pair pair;
  pairs::PairPlan plan;
  PairSteps steps;
  pairs::StepScratch scratch;
  PairWork work;
};

}  // namespace scatter::testing
