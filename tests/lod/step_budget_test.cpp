#include "lod/step_budget.h"

#include <gtest/gtest.h>

#include <vector>

namespace scatter::lod {
namespace {

PairWorkload work(int iterations) {
  PairWorkload load;
  load.counts.gjkIterations = iterations;
  return load;
}

TEST(StepBudget, CountsWhatAStepCostsWithoutLimit) {
  StepBudget budget;
  PlannedPair pair;
  budget.begin({.objects = 10, .awake = 8, .broadphasePairs = 5, .joints = 1});
  const double fixed = budget.units();
  EXPECT_GT(fixed, 0.0);
  const PairUnits units = budget.takeWork(pair, work(10));
  EXPECT_GT(units.common, 0.0);
  EXPECT_GT(units.all, units.common);
  budget.spendSwitch();
  budget.spendQueries(3);
  EXPECT_GT(budget.units(), fixed);
  budget.finish(false);
  EXPECT_EQ(budget.lastUnits(), budget.units());
  EXPECT_FALSE(budget.isExceeded());
  EXPECT_EQ(budget.budgetUnits(), BudgetUnits());
  EXPECT_EQ(budget.auditsFrom(), lateness::kDue);
}

TEST(StepBudget, IsShortOnceItIsSpent) {
  StepBudget budget;
  budget.set(UnitBudget::ofUnits(1000.0));
  std::vector<PlannedPair> pairs(1);
  pairs[0].view = {.level = 2, .finest = 2};
  pairs[0].target = 2;
  budget.begin({.objects = 2, .awake = 2, .broadphasePairs = 1});
  budget.plan(pairs, 1);
  EXPECT_FALSE(budget.isShort());
  EXPECT_EQ(budget.auditsFrom(), lateness::kDue);
  EXPECT_TRUE(budget.isShort(2000.0));
  budget.takeWork(pairs[0], work(100000));
  EXPECT_TRUE(budget.isShort());
  EXPECT_EQ(budget.auditsFrom(), lateness::kDue) << "a little of any step is for audits";
  for (int i = 0; i < 1000; ++i) budget.countAudit(work(10));
  EXPECT_EQ(budget.auditsFrom(), lateness::kNever);
  EXPECT_TRUE(budget.isExceeded());
}

TEST(StepBudget, HasAShareForAudits) {
  StepBudget budget;
  budget.set(UnitBudget::ofUnits(1e6));
  std::vector<PlannedPair> none;
  budget.begin({});
  budget.plan(none, 1);
  int audits = 0;
  while (budget.auditsFrom() == lateness::kDue && audits < 1'000'000) {
    budget.countAudit(work(10));
    ++audits;
  }
  EXPECT_GT(audits, 10);
  EXPECT_LT(audits, 1'000'000);
  EXPECT_EQ(budget.auditsFrom(), lateness::kLate) << "up to the budget itself";
  budget.begin({});
  EXPECT_EQ(budget.auditsFrom(), lateness::kDue) << "the next step has its own";
}

TEST(StepBudget, CountsContactsOfNoPairOfItsOwn) {
  StepBudget budget;
  budget.begin({});
  const double before = budget.units();
  budget.takeLoose({.manifolds = 10, .points = 30});
  const double loose = budget.units() - before;
  EXPECT_GT(loose, 0.0);
  budget.finish(false);
  // Until they are counted again they are taken to be the same.
  budget.begin({});
  EXPECT_EQ(budget.units(), before + loose);
  budget.takeLoose({});
  EXPECT_NEAR(budget.units(), before, 1e-9);
}

/// A step of one pair with so many contacts, of which the solver is shown a quarter where a rung says so.
double stepUnits(StepBudget& budget, PlannedPair& pair, int contacts, const SolverWork& solver = {},
                 const StepClock& clock = {}) {
  budget.begin({}, clock);
  budget.plan({&pair, 1}, 1);
  PairWorkload load;
  load.contacts = contacts;
  budget.takeWork(pair, load);
  budget.takeLoose({});
  budget.settle(solver, [contacts](const ThinningRule&) {
    return SpareContacts{contacts, contacts - contacts / 4};
  });
  budget.finish(true);
  return budget.units();
}

/// A pair at its finest level with many contacts, and what its step costs if all are shown.
class StepBudgetOfContacts : public ::testing::Test {
 protected:
  static constexpr int kContacts = 1000;

  StepBudgetOfContacts() {
    pair.view = {.level = 2, .finest = 2, .touching = true};
    pair.target = 2;
    roomy.set(UnitBudget::ofUnits(1e6));
    full = stepUnits(roomy, pair, kContacts);
  }

  PlannedPair pair{};
  StepBudget roomy{};
  double full = 0.0;
};

TEST_F(StepBudgetOfContacts, AreLeftToOthersBeforeItIsExceeded) {
  EXPECT_EQ(roomy.hiddenContacts(), 0);
  StepBudget tight;
  tight.set(UnitBudget::ofUnits(0.3 * full));
  const double saved = full - stepUnits(tight, pair, kContacts);
  EXPECT_EQ(tight.hiddenContacts(), 750);
  EXPECT_NEAR(saved, 750 * CostWeights().hiddenContact, 1e-9);
  // The next step expects it from the beginning, and costs the same.
  EXPECT_NEAR(stepUnits(tight, pair, kContacts), full - saved, 1e-9);
  // When they are gone nothing is left of it.
  EXPECT_NEAR(stepUnits(tight, pair, 0), stepUnits(roomy, pair, 0), 1e-9);
}

TEST_F(StepBudgetOfContacts, AreLeftToOthersNoMoreThanItNeeds) {
  StepBudget tight;
  tight.set(UnitBudget::ofUnits(full));
  for (int i = 0; i < 5; ++i) {
    const double units = stepUnits(tight, pair, kContacts);
    EXPECT_GT(units, 0.8 * full);
    EXPECT_LT(units, 0.88 * full);
    EXPECT_GT(tight.hiddenContacts(), 0);
    EXPECT_LT(tight.hiddenContacts(), 250);
    EXPECT_NEAR(full - units, tight.hiddenContacts() * CostWeights().hiddenContact, 1e-9);
    EXPECT_EQ(pair.target, 2) << "no detail is taken while contacts can be spared";
  }
}

TEST_F(StepBudgetOfContacts, AreSolvedWithFewerIterationsIfNothingElseIsLeft) {
  const SolverWork ten{.iterations = 10};
  const double each = CostWeights().contactIteration * kContacts / 4;
  const double least = full - 750 * CostWeights().hiddenContact;
  StepBudget tight;
  tight.set(UnitBudget::ofUnits(least - 2.5 * each));
  EXPECT_NEAR(stepUnits(tight, pair, kContacts, ten), least - 3 * each, 1e-9);
  EXPECT_EQ(tight.iterationsLeftOut(), 3);
  EXPECT_EQ(tight.state(0.0).verdict, BudgetVerdict::kKept);
  tight.set(UnitBudget::ofUnits((least - 6 * each) / 1.1));
  EXPECT_NEAR(stepUnits(tight, pair, kContacts, ten), least - 6 * each, 1e-9);
  EXPECT_LE(tight.state(tight.floorUnits({&pair, 1})).reachable, tight.units());
  tight.set(UnitBudget::ofUnits(least));
  EXPECT_NEAR(stepUnits(tight, pair, kContacts, ten), least, 1e-9);
  EXPECT_EQ(tight.iterationsLeftOut(), 0) << "they are the last that is given up";
}

// A stack that stands would tremble.
TEST_F(StepBudgetOfContacts, AreSolvedWithAllIterationsWhileBodiesLieStill) {
  const double least = full - 750 * CostWeights().hiddenContact;
  StepBudget tight;
  tight.set(UnitBudget::ofUnits(0.97 * least));
  int asked = 0;
  SolverWork solver{.iterations = 10, .isCalm = [&asked] { return ++asked > 0; }};
  EXPECT_NEAR(stepUnits(tight, pair, kContacts, solver), least, 1e-9);
  EXPECT_EQ(tight.iterationsLeftOut(), 0);
  EXPECT_EQ(asked, 1);
  tight.set(UnitBudget::ofUnits(1.1 * least));
  stepUnits(tight, pair, kContacts, solver);
  EXPECT_EQ(asked, 1) << "there is room";
}

TEST_F(StepBudgetOfContacts, JointsHaveIterationsToo) {
  StepBudget tight;
  tight.begin({.joints = 100});
  const double all = tight.units();
  tight.set(UnitBudget::ofUnits(all - 1.5 * 100 * CostWeights().jointIteration));
  tight.begin({.joints = 100});
  tight.plan({}, 1);
  tight.settle({.iterations = 10}, [](const ThinningRule&) { return SpareContacts{}; });
  EXPECT_EQ(tight.iterationsLeftOut(), 2);
  EXPECT_NEAR(all - tight.units(), 200 * CostWeights().jointIteration, 1e-9);
}

// Of milliseconds, at a microsecond for a unit.
TEST_F(StepBudgetOfContacts, HaveWhatTheClockHasLeft) {
  StepBudget late;
  late.set(UnitBudget::ofMilliseconds(full / 500.0));
  const double found = full - kContacts * CostWeights().contact;
  double milliseconds = found / 1000.0;
  const SolverWork solver{.iterations = 10};
  const StepClock clock = [&milliseconds] { return milliseconds; };
  EXPECT_NEAR(stepUnits(late, pair, kContacts, solver, clock), full, 1e-9);
  EXPECT_EQ(late.budgetUnits().settled, late.budgetUnits().given);
  milliseconds = full / 500.0;
  stepUnits(late, pair, kContacts, solver, clock);
  EXPECT_LT(late.budgetUnits().settled, late.budgetUnits().given);
  EXPECT_EQ(late.hiddenContacts(), 750);
}

// As soon as enough of the step has been made, which is when the first of two equal pairs has.
TEST(StepBudget, LooksOnceAtTheClockAmongThePairs) {
  std::vector<PlannedPair> pairs(2);
  PairWorkload load;
  load.contacts = 5000;
  StepBudget budget;
  budget.set(UnitBudget::ofMilliseconds(4.0));
  int looks = 0;
  const auto step = [&](double slowness) {
    looks = 0;
    budget.begin({}, [&] { return (++looks, slowness * (budget.units() - 1000.0) / 1000.0); });
    for (PlannedPair& pair : pairs) {
      pair.view.level = pair.view.finest = pair.target = 1;
      pair.expected = 1000.0F;
    }
    budget.plan(pairs, 1);
    budget.revise();
    EXPECT_EQ(looks, 0) << "nothing has been made";
    budget.takeWork(pairs[0], load);
    budget.revise();
    budget.revise();
    EXPECT_EQ(looks, 1);
    const bool isShort = budget.isShort();
    budget.takeWork(pairs[1], load);
    budget.finish(true);
    return isShort;
  };
  for (int i = 0; i < 10; ++i) step(1.0);
  EXPECT_FALSE(step(1.0));
  EXPECT_EQ(budget.budgetUnits().revised, budget.budgetUnits().given);
  EXPECT_TRUE(step(1e6));
  EXPECT_LT(budget.budgetUnits().revised, budget.budgetUnits().given);
}

TEST(StepBudget, OfMillisecondsNeedsTheClock) {
  StepBudget budget;
  EXPECT_FALSE(budget.needsTime());
  budget.set(UnitBudget::ofMilliseconds(5.0));
  EXPECT_TRUE(budget.needsTime());
  for (const double milliseconds : {5.1, 4.9}) {
    budget.begin({}, [milliseconds] { return milliseconds; });
    budget.finish(false);
    EXPECT_EQ(budget.takeTime(), milliseconds > 5.0);
  }
}

}  // namespace
}  // namespace scatter::lod
