#include <scatter/lod/budget_state.h>

#include <gmock/gmock.h>

#include <vector>

#include "lod/governor_pairs.h"
#include "lod/step_budget.h"

namespace scatter::lod {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::knownPairs;

/// Steps of pairs that all cost the same, which stay at their finest level whatever the plan says.
BudgetState after(double budgetUnits, int objects, int steps = 12) {
  StepBudget budget;
  budget.set(UnitBudget::ofUnits(budgetUnits));
  CostModel costs{CostWeights{}};
  std::vector<PlannedPair> pairs = knownPairs(costs, 50, 3);
  PairWorkload work;
  work.counts.rebuilds = 1;
  work.contacts = 50;
  for (int step = 0; step < steps; ++step) {
    budget.begin({.objects = objects, .awake = objects});
    budget.plan(pairs, 2);
    for (PlannedPair& pair : pairs) budget.learn(pair, true, budget.takeWork(pair, work));
    budget.finish(true);
  }
  return budget.state(budget.floorUnits(pairs));
}

TEST(BudgetState, IsKeptWhereThereIsRoom) {
  const BudgetState state = after(5000.0, 10);
  EXPECT_EQ(state.verdict, BudgetVerdict::kKept);
  EXPECT_EQ(state.budget, 5000.0);
  EXPECT_GT(state.taken, 400.0);
  EXPECT_EQ(state.floor, 0.0);
  EXPECT_EQ(describe(state), "the budget of 5000 units is kept, nothing is given up");
}

TEST(BudgetState, IsExceededWhereDetailCouldHaveBeenGivenUp) {
  const BudgetState state = after(500.0, 10);
  EXPECT_EQ(state.verdict, BudgetVerdict::kExceeded);
  EXPECT_LT(state.reachable, 500.0);
  EXPECT_GT(state.taken, 510.0);
}

TEST(BudgetState, SaysThatDetailStaysWhereItIsHardlyAnything) {
  const BudgetState state = after(500.0, 300'000, 40);
  EXPECT_EQ(state.verdict, BudgetVerdict::kImpossible);
  EXPECT_TRUE(state.isVain);
  EXPECT_THAT(describe(state), HasSubstr(", detail is hardly anything of it and stays"));
}

TEST(BudgetState, IsImpossibleWhereNoLevelsHelp) {
  const BudgetState state = after(500.0, 3000);
  EXPECT_EQ(state.verdict, BudgetVerdict::kImpossible);
  EXPECT_GT(state.fixed, 500.0);
  EXPECT_GE(state.reachable, state.fixed);
  EXPECT_LE(state.reachable, state.taken);
  EXPECT_THAT(describe(state), AllOf(HasSubstr("the budget of 500 units cannot be kept in this scene"),
                                     HasSubstr("of which"), HasSubstr("no level changes")));
}

TEST(BudgetState, IsThatOfNoBudgetWithoutOne) {
  const StepBudget budget;
  const BudgetState state = budget.state(0.0);
  EXPECT_EQ(state.verdict, BudgetVerdict::kNone);
  EXPECT_EQ(describe(state), "no budget");
}

TEST(BudgetState, SaysWhatWasGivenUp) {
  BudgetState state;
  state.verdict = BudgetVerdict::kImpossibleNow;
  state.budget = 4000.0;
  state.floor = 5000.0;
  state.millisecondsPerUnit = 0.001;
  state.withheldPairs = 12;
  state.creditedPairs = 8;
  state.overduePairs = 2;
  state.keptPairs = 3;
  state.hiddenContacts = 40;
  state.restingBodies = 7;
  state.iterationsLeftOut = 5;
  EXPECT_EQ(
      describe(state),
      "the budget of 4.00 ms cannot be kept as the bodies lie: what cannot be given up takes 5.00 ms, 40 "
      "contacts are left to others of theirs, 12 pairs coarser for it, 8 on credit, 2 of these not looked "
      "at, which may overlap, 3 keep their contacts for a step, 7 bodies fall asleep sooner, 5 iterations of "
      "the solver less");
}

}  // namespace
}  // namespace scatter::lod
