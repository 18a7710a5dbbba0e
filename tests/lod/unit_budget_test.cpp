#include "lod/unit_budget.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace scatter::lod {
namespace {

TEST(UnitBudget, NoneIsInfinite) {
  UnitBudget budget;
  EXPECT_FALSE(budget.isLimited());
  EXPECT_TRUE(std::isinf(budget.next()));
  budget.learn(1000.0, 5.0);
  EXPECT_TRUE(std::isinf(budget.next()));
}

TEST(UnitBudget, UnitsStayWhateverTheClockSays) {
  UnitBudget budget = UnitBudget::ofUnits(1234.5);
  EXPECT_TRUE(budget.isLimited());
  for (int i = 0; i < 30; ++i) {
    EXPECT_EQ(budget.next(), 1234.5);
    budget.learn(1000.0, 1.0 + i);
  }
}

TEST(UnitBudget, StepsOfOneCallShareWhatItMayCost) {
  UnitBudget budget = UnitBudget::ofUnits(1200.0);
  budget.share(3);
  EXPECT_EQ(budget.next(), 400.0);
  budget.take(600.0);
  EXPECT_EQ(budget.next(), 300.0);
  budget.take(100.0);
  EXPECT_EQ(budget.next(), 500.0);
  budget.take(500.0);
  // The next call has its own.
  budget.share(1);
  EXPECT_EQ(budget.next(), 1200.0);
  // Where nothing is left, a tenth of a step's share is.
  budget.share(2);
  EXPECT_EQ(budget.next(), 600.0);
  budget.take(5000.0);
  EXPECT_EQ(budget.next(), 60.0);
}

TEST(UnitBudget, MillisecondsAreSharedToo) {
  UnitBudget budget = UnitBudget::ofMilliseconds(5.0);
  for (int i = 0; i < 20; ++i) budget.learn(2000.0, 4.0);
  budget.share(2);
  EXPECT_DOUBLE_EQ(budget.next(), 1250.0);
  EXPECT_TRUE(budget.isExceededBy(2.6));
  EXPECT_FALSE(budget.isExceededBy(2.4));
}

TEST(UnitBudget, WhatIsRecordedIsNotShared) {
  UnitBudget budget = UnitBudget::replay({{.given = 100.0}, {.given = 200.0}});
  budget.share(2);
  EXPECT_EQ(budget.next(), 100.0);
  budget.take(1000.0);
  EXPECT_EQ(budget.next(), 200.0);
}

TEST(UnitBudget, MillisecondsStartWithAMicrosecondForAUnit) {
  UnitBudget budget = UnitBudget::ofMilliseconds(5.0);
  EXPECT_TRUE(budget.isLimited());
  EXPECT_DOUBLE_EQ(budget.next(), 5000.0);
}

TEST(UnitBudget, MillisecondsFollowTheMachine) {
  UnitBudget budget = UnitBudget::ofMilliseconds(5.0);
  for (int i = 0; i < 20; ++i) budget.learn(2000.0, 4.0);
  EXPECT_DOUBLE_EQ(budget.next(), 2500.0);
}

TEST(UnitBudget, LightStepsSayNothingAboutHeavyOnes) {
  UnitBudget budget = UnitBudget::ofMilliseconds(5.0);
  for (int i = 0; i < 20; ++i) budget.learn(4000.0, 4.0);
  for (int i = 0; i < 20; ++i) budget.learn(100.0, 0.5);
  EXPECT_DOUBLE_EQ(budget.next(), 5000.0);
}

TEST(UnitBudget, FindsOutHowFastAVeryFastMachineIs) {
  UnitBudget budget = UnitBudget::ofMilliseconds(5.0);
  for (int i = 0; i < 20; ++i) budget.learn(5000.0, 0.1);
  EXPECT_DOUBLE_EQ(budget.next(), 250000.0);
}

TEST(UnitBudget, FindsOutHowSlowAVerySlowMachineIs) {
  UnitBudget budget = UnitBudget::ofMilliseconds(5.0);
  for (int i = 0; i < 20; ++i) budget.learn(100.0, 5.0);
  EXPECT_DOUBLE_EQ(budget.next(), 100.0);
}

TEST(UnitBudget, OneThatReplacesAnotherKnowsTheMachine) {
  UnitBudget before = UnitBudget::ofMilliseconds(5.0);
  for (int i = 0; i < 20; ++i) before.learn(2000.0, 4.0);
  UnitBudget budget = UnitBudget::ofMilliseconds(3.0);
  budget.takeOver(before);
  EXPECT_DOUBLE_EQ(budget.next(), 1500.0);
  UnitBudget elsewhere = UnitBudget::ofMilliseconds(3.0, {0.001});
  elsewhere.takeOver(before);
  EXPECT_DOUBLE_EQ(elsewhere.next(), 3000.0) << "that is another machine";
}

TEST(UnitBudget, OneThatReplacesAnotherHasWhatItsStepsHaveLeft) {
  UnitBudget before = UnitBudget::ofUnits(3000.0);
  before.share(3);
  EXPECT_EQ(before.next(), 1000.0);
  before.take(600.0);
  UnitBudget budget = UnitBudget::ofUnits(2000.0);
  budget.takeOver(before);
  EXPECT_EQ(budget.next(), 700.0);
}

TEST(UnitBudget, ReplaysExactlyAndStaysAtTheLast) {
  UnitBudget budget = UnitBudget::replay({{.given = 1000.1}, {}, {.given = 997.3}});
  EXPECT_EQ(budget.next(), 1000.1);
  budget.learn(1000.0, 50.0);
  EXPECT_TRUE(std::isinf(budget.next()));
  EXPECT_EQ(budget.next(), 997.3);
  EXPECT_EQ(budget.next(), 997.3);
  EXPECT_EQ(budget.next(), 997.3);
}

TEST(UnitBudget, ARecordingRepeatsARunThatDependedOnTheClock) {
  UnitBudget first = UnitBudget::ofMilliseconds(3.0);
  std::vector<BudgetUnits> recorded;
  for (int i = 0; i < 50; ++i) {
    recorded.push_back({.given = first.next()});
    first.learn(1000.0 + i, 1.0 + 0.1 * (i % 7));
  }
  UnitBudget second = UnitBudget::replay(recorded);
  for (const BudgetUnits& units : recorded) EXPECT_EQ(second.next(), units.given);
}

/// Of milliseconds, on a machine that takes two microseconds for a unit: 2500 of them in 5 ms.
UnitBudget onASlowMachine() {
  UnitBudget budget = UnitBudget::ofMilliseconds(5.0);
  for (int i = 0; i < 20; ++i) budget.learn(2000.0, 4.0);
  EXPECT_DOUBLE_EQ(budget.next(), 2500.0);
  return budget;
}

TEST(UnitBudget, HasWhatTheClockHasLeft) {
  UnitBudget budget = onASlowMachine();
  EXPECT_DOUBLE_EQ(budget.settle(2000.0, 4.0), 2500.0);
  EXPECT_DOUBLE_EQ(budget.settle(2000.0, 4.4), 2000.0 + 0.6 / 0.0022) << "the rest is as slow";
  EXPECT_DOUBLE_EQ(budget.settle(2000.0, 6.0), 2000.0);
  // A step that has been quick does not get more.
  EXPECT_DOUBLE_EQ(budget.settle(1900.0, 3.0), 2500.0);
  EXPECT_DOUBLE_EQ(budget.settle(100.0, 9.0), 250.0) << "a tenth there is in any case";
  EXPECT_DOUBLE_EQ(budget.revise(1000.0, 2.0), 2500.0);
  EXPECT_DOUBLE_EQ(budget.revise(1000.0, 4.0), 1250.0) << "twice as slow";
}

TEST(UnitBudget, LearnsApartWhatTheRestOfAStepTakes) {
  UnitBudget budget = onASlowMachine();
  for (int i = 0; i < 20; ++i) {
    static_cast<void>(budget.next());
    static_cast<void>(budget.settle(1000.0, 1.0));
    budget.learn(2000.0, 4.0);
  }
  EXPECT_DOUBLE_EQ(budget.next(), 2500.0);
  EXPECT_DOUBLE_EQ(budget.settle(1500.0, 1.5), 2500.0);
  EXPECT_DOUBLE_EQ(budget.settle(1500.0, 3.0), 1500.0 + 2.0 / (2.0 * 0.003));
  EXPECT_DOUBLE_EQ(budget.revise(1000.0, 2.0), 2500.0) << "another point";
}

TEST(UnitBudget, OfUnitsHasNoClock) {
  UnitBudget budget = UnitBudget::ofUnits(100.0);
  EXPECT_EQ(budget.next(), 100.0);
  EXPECT_EQ(budget.revise(40.0, 1e6), 100.0);
  EXPECT_EQ(budget.settle(40.0, 1e6), 100.0);
}

TEST(UnitBudget, ReplaysWhatTheClockHadLeft) {
  UnitBudget budget = UnitBudget::replay({{100.0, 90.0, 80.0}, {}, {200.0, 150.0, 200.0}});
  EXPECT_EQ(budget.next(), 100.0);
  EXPECT_EQ(budget.revise(40.0, 1e6), 90.0);
  EXPECT_EQ(budget.settle(40.0, 1e6), 80.0);
  EXPECT_TRUE(std::isinf(budget.next()));
  EXPECT_TRUE(std::isinf(budget.revise(40.0, 1e6)));
  EXPECT_TRUE(std::isinf(budget.settle(40.0, 1e6)));
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(budget.next(), 200.0);
    EXPECT_EQ(budget.revise(40.0, 1e6), 150.0);
    EXPECT_EQ(budget.settle(40.0, 1e6), 200.0);
  }
  UnitBudget ofUnits = UnitBudget::replay({{.given = 100.0}});
  EXPECT_EQ(ofUnits.next(), 100.0);
  EXPECT_EQ(ofUnits.revise(40.0, 1e6), 100.0);
  EXPECT_EQ(ofUnits.settle(40.0, 1e6), 100.0);
}

TEST(UnitBudget, FollowsAMachineThatBecomesSlower) {
  UnitBudget budget = onASlowMachine();
  for (int i = 0; i < 40; ++i) budget.learn(2000.0, 4.0);
  int steps = 0;
  for (; budget.next() > 1300.0 && steps < 40; ++steps) budget.learn(2000.0, 8.0);
  EXPECT_LE(steps, 6);
  // A slow step now and then is none.
  budget = onASlowMachine();
  for (int i = 0; i < 40; ++i) budget.learn(2000.0, i % 10 == 0 ? 8.0 : 4.0);
  EXPECT_GT(budget.next(), 2300.0);
}

TEST(UnitBudget, AMachineThatIsGivenStandsInForTheClock) {
  UnitBudget measured = UnitBudget::ofMilliseconds(5.0);
  UnitBudget given = UnitBudget::ofMilliseconds(5.0, {0.002, 0.003, 0.001});
  EXPECT_TRUE(given.needsTime()) << "its steps are told apart as those of the clock are";
  for (int i = 0; i < 50; ++i) {
    const double perUnit = i % 3 == 0 ? 0.002 : i % 3 == 1 ? 0.003 : 0.001;
    EXPECT_EQ(given.next(), measured.next()) << i;
    EXPECT_EQ(given.revise(700.0, 1e6), measured.revise(700.0, 700.0 * perUnit)) << i;
    EXPECT_EQ(given.settle(1200.0, 1e6), measured.settle(1200.0, 1200.0 * perUnit)) << i;
    EXPECT_EQ(given.timeOf(2000.0, 1e6), 2000.0 * perUnit);
    measured.learn(2000.0, 2000.0 * perUnit);
    given.learn(2000.0, given.timeOf(2000.0, 1e6));
  }
}

TEST(UnitBudget, AnEmptyRecordingIsNoBudget) {
  UnitBudget budget = UnitBudget::replay({});
  EXPECT_FALSE(budget.isLimited());
  EXPECT_TRUE(std::isinf(budget.next()));
}

}  // namespace
}  // namespace scatter::lod
