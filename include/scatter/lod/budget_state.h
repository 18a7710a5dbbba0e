#pragma once

#include <cstdint>
#include <string>

namespace scatter {

/// How a step's budget was kept.
enum class BudgetVerdict : std::uint8_t {
  kNone,      ///< There is no budget.
  kKept,      ///< The step took no more than 1.02 of it.
  kExceeded,  ///< It took more, of what could have been given up: it was not foreseen, or is on its way out.
  kImpossibleNow,  ///< As the bodies lie, what could not be given up takes more than the budget.
  kImpossible,     ///< With every pair at the coarsest level that it may have the step would take more.
};

/// What has become of the budget in the last step. Units are the governor's, of the whole step.
struct BudgetState {
  BudgetVerdict verdict = BudgetVerdict::kNone;
  int steps = 0;  ///< For so many it has been that, this one included.

  double budget = 0.0;  ///< Units that the step was allowed; 0 for none.
  double taken = 0.0;   ///< That it took.
  double fixed = 0.0;   ///< Of these, what no level changes: bodies, broadphase, joints, contacts of others.
  double floor = 0.0;   ///< About what it would have taken with all given up that can be, as the bodies lie;
                        ///< 0 of a step that kept its budget.
  double reachable = 0.0;  ///< The same with every pair at its coarsest level: once it has got there.
  double millisecondsPerUnit = 0.0;  ///< As a budget of milliseconds has learned it; 0 for others.

  bool isVain = false;  ///< It is impossible, and hardly less so without detail: all of it stays.

  int withheldPairs = 0;  ///< Pairs that the budget keeps below the level that they would have.
  int creditedPairs = 0;  ///< Pairs in contact that hold penetration credit.
  int overduePairs = 0;   ///< Of these, whose finest shapes were due to be looked at, which the budget had no
                          ///< room for: they may overlap.
  int keptPairs = 0;      ///< Pairs that kept their contacts of the step before.
  int hiddenContacts = 0;     ///< Contacts that the solver was not shown, as others stand for them.
  int restingBodies = 0;      ///< Bodies that lie still, and fall asleep sooner.
  int iterationsLeftOut = 0;  ///< Of the solver's: the last that is given up.
};

/// Of a state in one line: whether the budget is kept, what it would take, what was given up. Without a full
/// stop.
[[nodiscard]] std::string describe(const BudgetState& state);

}  // namespace scatter
