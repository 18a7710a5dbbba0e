#pragma once

#include <scatter/lod/budget_units.h>

namespace scatter {

/// What became of the pairs that switch, in one step. Exact counts: the same run after run.
struct PairStepCounts {
  int pairs = 0;           ///< That switch.
  int finestPairs = 0;     ///< Of those, at their finest level.
  int creditedPairs = 0;   ///< Of those, with penetration credit.
  int overduePairs = 0;    ///< Of these, whose finest shapes have not been looked at for longer than may be.
  int touchingPairs = 0;   ///< Closer than 1 cm.
  int touchingFinest = 0;  ///< Of those, at their finest level.
  int requests = 0;        ///< Standing after the step.
  int switchesCoarser = 0;
  int switchesFiner = 0;
  int creditSwitches = 0;  ///< Of both, on credit.
  int retractions = 0;
  int reusedPairs = 0;  ///< In contact, kept their contacts for the step, because the budget was about to be
                        ///< exceeded.
  int hiddenContacts = 0;     ///< That others of the same two bodies stand for, for the budget.
  int iterationsLeftOut = 0;  ///< Of the solver's, for the budget.
  int restingBodies = 0;      ///< That come to rest sooner, for the budget.
  int wokenBodies = 0;        ///< That were asleep, for detail that the budget has room for again.
  int blockedTries = 0;
  int separationQueries = 0;
  int audits = 0;

  /// Switches after which the pair's contacts press the bodies apart deeper, by more than 2 mm, than those of
  /// the level before would where the bodies are now. A contact presses by its depth, and one without error
  /// reduction not at all. 0 unless the safety conditions are off.
  int unsafeSwitches = 0;

  double units = 0.0;  ///< What the step cost.
  double plannedUnits = 0.0;
  BudgetUnits budgetUnits{};

  /// Of a step that took more than its budget, about: what it would have cost if every pair had been as
  /// coarse as it may be where the bodies were. 0 of other steps.
  double floorUnits = 0.0;
};

}  // namespace scatter
