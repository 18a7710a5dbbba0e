#include "lod/step_budget.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace scatter::lod {
namespace {

PairWorkload work(int queries) {
  PairWorkload load;
  load.counts.gjkRuns = queries;
  return load;
}

TEST(StepBudget, CountsWhatAStepCostsWithoutLimit) {
  StepBudget budget;
  PlannedPair pair;
  budget.begin(10, 5);
  const double fixed = budget.units();
  EXPECT_GT(fixed, 0.0);
  EXPECT_GT(budget.takeWork(pair, work(10)), 0.0);
  budget.spendSwitch();
  budget.spendQueries(3);
  EXPECT_GT(budget.units(), fixed);
  budget.finish(false);
  EXPECT_EQ(budget.lastUnits(), budget.units());
  EXPECT_FALSE(budget.isExceeded());
  EXPECT_TRUE(std::isinf(budget.budgetUnits()));
  EXPECT_TRUE(budget.mayAudit());
}

TEST(StepBudget, IsShortOnceItIsSpent) {
  StepBudget budget;
  budget.set(UnitBudget::ofUnits(1000.0));
  std::vector<PlannedPair> pairs(1);
  pairs[0].view = {.level = 2, .finest = 2};
  pairs[0].target = 2;
  budget.begin(2, 1);
  budget.plan(pairs, 1, 2);
  EXPECT_FALSE(budget.isShort());
  EXPECT_TRUE(budget.mayAudit());
  EXPECT_TRUE(budget.isShort(2000.0));
  budget.takeWork(pairs[0], work(100000));
  EXPECT_TRUE(budget.isShort());
  EXPECT_FALSE(budget.mayAudit());
  EXPECT_TRUE(budget.isExceeded());
}

TEST(StepBudget, HasAShareForAudits) {
  StepBudget budget;
  budget.set(UnitBudget::ofUnits(1e6));
  std::vector<PlannedPair> none;
  budget.begin(0, 0);
  budget.plan(none, 1, 0);
  int audits = 0;
  while (budget.mayAudit() && audits < 1'000'000) {
    budget.countAudit(work(10));
    ++audits;
  }
  EXPECT_GT(audits, 10);
  EXPECT_LT(audits, 1'000'000);
  budget.begin(0, 0);
  EXPECT_TRUE(budget.mayAudit()) << "the next step has its own";
}

TEST(StepBudget, OfMillisecondsNeedsTheClock) {
  StepBudget budget;
  EXPECT_FALSE(budget.needsTime());
  budget.set(UnitBudget::ofMilliseconds(5.0));
  EXPECT_TRUE(budget.needsTime());
  EXPECT_TRUE(budget.isExceededBy(5.1));
  EXPECT_FALSE(budget.isExceededBy(4.9));
}

}  // namespace
}  // namespace scatter::lod
