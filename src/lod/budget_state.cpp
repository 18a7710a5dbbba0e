#include <scatter/lod/budget_state.h>

#include <cstdio>

namespace scatter {

namespace {

std::string amount(const BudgetState& state, double units) {
  char text[48];
  const bool hasTime = state.millisecondsPerUnit > 0.0;
  std::snprintf(text, sizeof(text), hasTime ? "%.2f ms" : "%.0f units",
                hasTime ? units * state.millisecondsPerUnit : units);
  return text;
}

std::string verdictOf(const BudgetState& state) {
  const std::string budget = "the budget of " + amount(state, state.budget);
  switch (state.verdict) {
    case BudgetVerdict::kNone:
      return "no budget";
    case BudgetVerdict::kKept:
      return budget + " is kept";
    case BudgetVerdict::kExceeded:
      return budget + " is exceeded: " + amount(state, state.taken);
    case BudgetVerdict::kImpossibleNow:
      return budget + " cannot be kept as the bodies lie: what cannot be given up takes " +
             amount(state, state.floor);
    case BudgetVerdict::kImpossible:
      return budget + " cannot be kept in this scene: with every pair at its coarsest level it takes " +
             amount(state, state.reachable) + ", of which " + amount(state, state.fixed) +
             " no level changes";
  }
  return {};
}

std::string count(int number, const char* what) {
  return number == 0 ? std::string() : ", " + std::to_string(number) + what;
}

}  // namespace

std::string describe(const BudgetState& state) {
  if (state.verdict == BudgetVerdict::kNone) return verdictOf(state);
  const std::string given = count(state.hiddenContacts, " contacts are left to others of theirs") +
                            count(state.withheldPairs, " pairs coarser for it") +
                            count(state.creditedPairs, " on credit") +
                            count(state.overduePairs, " of these not looked at, which may overlap") +
                            count(state.keptPairs, " keep their contacts for a step") +
                            count(state.restingBodies, " bodies fall asleep sooner") +
                            count(state.iterationsLeftOut, " iterations of the solver less");
  const std::string vain = state.isVain ? ", detail is hardly anything of it and stays" : "";
  return verdictOf(state) + vain + (given.empty() ? ", nothing is given up" : given);
}

}  // namespace scatter
