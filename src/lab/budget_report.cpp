#include "lab/budget_report.h"

#include <scatter/lab/recorded_machine.h>

#include "lab/text.h"

#include <algorithm>
#include <vector>

namespace scatter::lab {

namespace {

/// A budget as one number a frame, and what the frame took, in the same unit.
struct BudgetUse {
  std::vector<double> allowed;
  std::vector<double> taken;
  std::string unit;
};

struct Overrun {
  std::size_t frames = 0;
  std::size_t impossible = 0;  ///< Frames in which it could not have been kept at the coarsest levels.
  std::size_t untouched = 0;   ///< Of these, in which no pair was kept coarser for it.
  std::size_t belowFloor = 0;  ///< Frames in which the budget was less than what could not be given up.
  double most = 0.0;           ///< That a frame took.
  std::vector<double> floors;  ///< Of the frames that have one.
};

bool hasBudget(const PhysicsDef& physics) {
  const BudgetDef& budget = physics.switching.budget;
  return physics.world == WorldKind::kHybrid && physics.switching.switching == Switching::kPair &&
         (budget.milliseconds > 0.0 || budget.units > 0.0);
}

BudgetUse budgetUse(const Run& run) {
  const BudgetDef& budget = run.options.physics.switching.budget;
  const bool isTime = budget.milliseconds > 0.0;
  const bool isGiven = isTime && !budget.machine.empty();
  const std::vector<double>& values = run.table.values(isTime && !isGiven ? "physics_cpu_ms" : "cost_units");
  return {.allowed = std::vector<double>(run.table.frames(), isTime ? budget.milliseconds : budget.units),
          .taken = isGiven ? timeOnMachine(values, budget.machine) : values,
          .unit = isTime ? " ms" : " units"};
}

// What a unit took in the frame is what the floor's units would have taken.
double floorOf(const Run& run, const BudgetUse& use, std::size_t frame) {
  const double units = run.table.values("floor_units")[frame];
  const double cost = run.table.values("cost_units")[frame];
  return cost > 0.0 ? std::min(units / cost, 1.0) * use.taken[frame] : 0.0;
}

BudgetVerdict verdictOf(const Run& run, std::size_t frame) {
  return static_cast<BudgetVerdict>(static_cast<int>(run.table.values("budget_verdict")[frame]));
}

Overrun overrunOf(const Run& run, const BudgetUse& use) {
  Overrun overrun;
  for (std::size_t frame = 0; frame < use.allowed.size(); ++frame) {
    const double taken = use.taken[frame];
    if (taken <= use.allowed[frame]) {
      continue;
    }
    ++overrun.frames;
    const bool isImpossible = verdictOf(run, frame) == BudgetVerdict::kImpossible;
    overrun.impossible += isImpossible ? 1 : 0;
    overrun.untouched += isImpossible && run.table.values("withheld_pairs")[frame] == 0.0 ? 1 : 0;
    overrun.most = std::max(overrun.most, taken);
    const double floor = floorOf(run, use, frame);
    if (floor > 0.0) {
      overrun.floors.push_back(floor);
      overrun.belowFloor += floor > use.allowed[frame] ? 1 : 0;
    }
  }
  return overrun;
}

std::string inHowMany(const Overrun& overrun) {
  if (overrun.belowFloor == 0) {
    return "less than the budget";
  }
  const std::string many = overrun.belowFloor == overrun.frames
                               ? "all"
                               : std::to_string(overrun.belowFloor) + " of " + std::to_string(overrun.frames);
  return "more than the budget in " + many + ", where it could not be kept";
}

std::string floorSentence(const Overrun& overrun, const std::string& unit) {
  if (overrun.floors.empty()) {
    return {};
  }
  const auto [least, most] = std::minmax_element(overrun.floors.begin(), overrun.floors.end());
  return " What could not be given up in them (bodies, broadphase, all pairs as coarse as they may be) took "
         "about " +
         readableNumber(medianOf(overrun.floors)) + unit + " (" + readableNumber(*least) + " to " +
         readableNumber(*most) + unit + "): " + inHowMany(overrun) + '.';
}

// Of all frames, as a budget can be kept by not looking.
std::string overdueSentence(const Run& run) {
  std::size_t frames = 0;
  double most = 0.0;
  for (const double pairs : run.table.values("overdue_pairs")) {
    frames += pairs > 0.0 ? 1 : 0;
    most = std::max(most, pairs);
  }
  if (frames == 0) {
    return {};
  }
  return " In " + std::to_string(frames) + " frames there was no room to look for contacts of up to " +
         std::to_string(static_cast<int>(most)) + " pairs on credit in time: they may overlap.";
}

std::string impossibleSentence(const Overrun& overrun) {
  if (overrun.impossible == 0) {
    return {};
  }
  return " In " + std::to_string(overrun.impossible) +
         " of them it could not have been kept with every pair at its coarsest level: give it more, or the "
         "scene fewer bodies." +
         (overrun.untouched == 0 ? std::string()
                                 : " In " + std::to_string(overrun.untouched) +
                                       " of these no pair was kept coarser for it, which would hardly help.");
}

}  // namespace

std::string budgetSentence(const Run& run, bool isRepeated) {
  if (!hasBudget(run.options.physics) || run.table.frames() == 0) {
    return {};
  }
  const BudgetUse use = budgetUse(run);
  const std::string budget =
      run.options.label + (isRepeated ? ", in the repeat that is kept: the budget of " : ": the budget of ") +
      readableNumber(use.allowed.front()) + use.unit;
  const Overrun overrun = overrunOf(run, use);
  const std::string frames = std::to_string(use.allowed.size());
  if (overrun.frames == 0) {
    return budget + " was kept in all " + frames + " frames." + overdueSentence(run);
  }
  return budget + " was exceeded in " + std::to_string(overrun.frames) + " of " + frames +
         " frames; the dearest took " + readableNumber(overrun.most) + use.unit + "." +
         floorSentence(overrun, use.unit) + impossibleSentence(overrun) + overdueSentence(run);
}

}  // namespace scatter::lab

namespace scatter {

std::string formatBudget(const Run& run) {
  const std::string sentence = lab::budgetSentence(run, false);
  return sentence.empty() ? sentence : lab::fitTerminal(sentence);
}

}  // namespace scatter
