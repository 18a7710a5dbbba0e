#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <vector>

#include "lod/fake_engine.h"
#include "lod/governor.h"
#include "lod/governor_pairs.h"

/// Pairs in contact: how they lose detail, and how they get it back.
namespace scatter::lod {
namespace {

using testing::countAt;
using testing::followPlan;
using testing::knownPair;
using testing::knownPairs;
using testing::Random;

/// Touching pairs at their finest level that cost from 7 to 40 units, 23.5 in the mean.
std::vector<PlannedPair> variousPairs(CostModel& costs, int count) {
  Random random(3);
  std::vector<PlannedPair> pairs;
  for (int i = 0; i < count; ++i) pairs.push_back(knownPair(costs, 3, random.uniform(7.0, 40.0)));
  return pairs;
}

double onCredit(const PlannedPair& pair) {
  return std::min(static_cast<double>(pair.cost.units[0]),
                  3.0 + 0.3 * static_cast<double>(pair.cost.units[0]));
}

/// So many steps in which all switches are safe that no more are to come.
void planUntilRest(Governor& governor, CostModel& costs, std::vector<PlannedPair>& pairs, double budget) {
  constexpr int kSteps = 100;
  for (int i = 0; i < kSteps; ++i) {
    governor.plan(pairs, costs, 0.0, budget);
    followPlan(pairs);
    double units = 0.0;
    for (PlannedPair& pair : pairs) {
      const double own = pair.view.credited ? onCredit(pair) : static_cast<double>(pair.cost.units[0]);
      const PairUnits learned{.all = own, .onCredit = true};
      if (pair.view.credited) costs.learn(pair.cost, pair.view.level, pair.view.finest, true, learned);
      governor.spend(pair, own, own);
      units += own;
    }
    governor.learn(units);
  }
}

double predictNow(const CostModel& costs, const PlannedPair& pair) {
  return costs.predict(pair.cost, pair.view.level, pair.view.level, pair.view.finest, pair.view.touching);
}

TEST(GovernorRelief, NothingIsTakenWithinTheBudget) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 100, 3);
  governor.plan(pairs, costs, 0.0, 1500.0);
  EXPECT_EQ(countAt(pairs, 3), 100);
}

TEST(GovernorRelief, TakesAboutAsMuchAsIsNeeded) {
  CostModel costs{CostWeights{}};
  for (const double share : {0.7, 0.8, 0.9, 1.0}) {
    Governor governor({});
    std::vector<PlannedPair> pairs = variousPairs(costs, 200);
    double all = 0.0;
    for (const PlannedPair& pair : pairs) all += predictNow(costs, pair);
    planUntilRest(governor, costs, pairs, share * all);
    double left = 0.0;
    for (const PlannedPair& pair : pairs) left += pair.target < 3 ? onCredit(pair) : pair.cost.units[0];
    EXPECT_GT(countAt(pairs, 2), 0);
    EXPECT_LE(left, share * all);
    EXPECT_GE(left, 0.75 * share * all);
  }
}

TEST(GovernorRelief, WhatCannotFitLosesAllItCan) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = variousPairs(costs, 100);
  planUntilRest(governor, costs, pairs, 50.0);
  EXPECT_EQ(countAt(pairs, 2), 100);
}

TEST(GovernorRelief, SwitchesAreSpreadOverSteps) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 300, 3, 20.0);
  // Three quarters of the budget too much.
  governor.plan(pairs, costs, 0.0, 3500.0);
  EXPECT_GT(countAt(pairs, 2), 0);
  EXPECT_LE(countAt(pairs, 2) * 20.0, 0.2 * 3500.0);
  // They are looked at at both levels in the step of the switch.
  EXPECT_GT(governor.planned(), 6000.0);
}

TEST(GovernorRelief, TheDearestGoFirst) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = variousPairs(costs, 200);
  governor.plan(pairs, costs, 0.0, 0.85 * 200 * 23.5);
  double cheapestTaken = 1e9;
  double dearestLeft = 0.0;
  for (const PlannedPair& pair : pairs) {
    const double units = predictNow(costs, pair);
    if (pair.target < 3) {
      cheapestTaken = std::min(cheapestTaken, units);
    } else {
      dearestLeft = std::max(dearestLeft, units);
    }
  }
  EXPECT_GT(dearestLeft, 7.0);
  EXPECT_LE(dearestLeft, 1.01 * cheapestTaken);
}

TEST(GovernorRelief, OfEqualsTheLeastImportantGoFirst) {
  CostModel costs{CostWeights{}};
  Random random(6);
  for (int run = 0; run < 20; ++run) {
    Governor governor({});
    std::vector<PlannedPair> pairs = knownPairs(costs, 300, 3, 20.0);
    for (PlannedPair& pair : pairs) pair.wish.importance = static_cast<float>(random.uniform(0.1, 10.0));
    governor.plan(pairs, costs, 0.0, 6000.0 * random.uniform(0.6, 1.0));
    ASSERT_GT(countAt(pairs, 2), 0);
    for (const PlannedPair& a : pairs) {
      for (const PlannedPair& b : pairs) {
        const bool matters = a.wish.importance > 1.01F * b.wish.importance;
        ASSERT_TRUE(!matters || a.target >= b.target);
      }
    }
  }
}

TEST(GovernorRelief, TakesOnlyFromPairsThatItMakesCheaper) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 5, 3, 20.0);
  pairs[0].view.credited = true;
  pairs[1].blockedSteps = 3;
  pairs[2].wish.atLeast = 3;
  pairs[3] = knownPair(costs, 3, 1.0);  // Not worth a switch.
  governor.plan(pairs, costs, 0.0, 10.0);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(pairs[i].target, 3) << i;
  EXPECT_EQ(pairs[4].target, 2);
}

TEST(GovernorRelief, GoesNoCoarserThanCreditAndThePromiseAllow) {
  CostModel costs{CostWeights{}};
  for (const int creditLevel : {1, 2}) {
    GovernorDef def;
    def.creditLevel = creditLevel;
    Governor governor(def);
    std::vector<PlannedPair> pairs = knownPairs(costs, 10, 3, 20.0);
    pairs[3].wish.atLeast = 2;
    planUntilRest(governor, costs, pairs, 20.0);
    EXPECT_EQ(pairs[0].target, creditLevel);
    EXPECT_EQ(pairs[3].target, 2);
  }
}

TEST(GovernorRelief, APairWithFewLevelsIsRelievedToo) {
  CostModel costs{CostWeights{}};
  for (const int creditLevel : {2, 3}) {
    GovernorDef def;
    def.creditLevel = creditLevel;
    Governor governor(def);
    std::vector<PlannedPair> pairs = {knownPair(costs, 3, 20.0), knownPair(costs, 3, 20.0)};
    pairs[1].view.finest = 2;
    pairs[1].view.level = 2;
    planUntilRest(governor, costs, pairs, 10.0);
    EXPECT_EQ(pairs[0].target, 2);
    EXPECT_EQ(pairs[1].target, 1);
  }
}

TEST(GovernorRelief, WhatCreditDidNotSaveIsNotTriedAgain) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 2, 3, 20.0);
  pairs[0].cost.units[1] = 19.5F;
  governor.plan(pairs, costs, 0.0, 10.0);
  EXPECT_EQ(pairs[0].target, 3);
  EXPECT_EQ(pairs[1].target, 2);
}

TEST(GovernorRelief, CreditThatDoesNotPayIsEnded) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 3, 2, 20.0);
  for (PlannedPair& pair : pairs) pair.view.credited = true;
  pairs[0].cost.units[1] = 30.0F;
  pairs[1].cost.units[1] = 30.0F;
  pairs[1].blockedSteps = 1;
  governor.plan(pairs, costs, 0.0, 10.0);
  EXPECT_EQ(pairs[0].target, 3);
  EXPECT_EQ(pairs[1].target, 2);
  EXPECT_EQ(pairs[2].target, 2);
}

TEST(GovernorRelief, APairThatRestsIsNotAsked) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 10, 3);
  for (std::size_t i = 0; i < 5; ++i) pairs[i].rests = true;
  for (int i = 0; i < 20; ++i) {
    governor.plan(pairs, costs, 0.0, 20.0);
    followPlan(pairs);
  }
  for (std::size_t i = 0; i < pairs.size(); ++i) EXPECT_EQ(pairs[i].target, i < 5 ? 3 : 2) << i;
}

TEST(GovernorRelief, ASmallExcessIsCoveredByOneDearPair) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  // Nothing less can be taken than what the dearest pair saves, which is more than is needed.
  std::vector<PlannedPair> pairs = knownPairs(costs, 9, 3, 5.0);
  pairs.push_back(knownPair(costs, 3, 50.0));
  governor.plan(pairs, costs, 0.0, 95.0);
  EXPECT_EQ(countAt(pairs, 2), 1);
  EXPECT_EQ(pairs[9].target, 2);
}

TEST(GovernorGivingBack, AllComesBackAShareInAStep) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 200, 1);
  const double budget = 4000.0;
  int steps = 0;
  while (countAt(pairs, 3) < 200 && steps < 100) {
    const double before = countAt(pairs, 3) * 10.0 + countAt(pairs, 1) * 1.0;
    governor.plan(pairs, costs, 0.0, budget);
    ASSERT_GT(followPlan(pairs), 0);
    ASSERT_LE(countAt(pairs, 3) * 10.0 + countAt(pairs, 1) * 1.0 - before, 0.1 * budget);
    ++steps;
  }
  EXPECT_GT(steps, 5);
  EXPECT_LT(steps, 100);
}

TEST(GovernorGivingBack, TheImportantComeFirst) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  Random random(9);
  std::vector<PlannedPair> pairs = knownPairs(costs, 100, 1);
  for (PlannedPair& pair : pairs) pair.wish.importance = static_cast<float>(random.uniform(0.1, 10.0));
  governor.plan(pairs, costs, 0.0, 2000.0);
  const int back = countAt(pairs, 3);
  EXPECT_GT(back, 0);
  EXPECT_LT(back, 50);
  for (const PlannedPair& a : pairs) {
    for (const PlannedPair& b : pairs) {
      const bool matters = a.wish.importance > 1.01F * b.wish.importance;
      ASSERT_TRUE(!matters || a.target >= b.target);
    }
  }
}

TEST(GovernorGivingBack, NothingComesBackWithoutRoom) {
  CostModel costs{CostWeights{}};
  for (const double share : {0.9, 0.95, 1.0, 1.5}) {
    Governor governor({});
    std::vector<PlannedPair> pairs = knownPairs(costs, 100, 2);
    for (PlannedPair& pair : pairs) pair.view.credited = true;
    // The pairs take 400.
    governor.plan(pairs, costs, 1000.0 * share - 400.0, 1000.0);
    EXPECT_EQ(countAt(pairs, 2), 100) << share;
  }
}

TEST(GovernorGivingBack, ManyPairsToComeAreLeftRoom) {
  CostModel costs{CostWeights{}};
  // 110 units are taken, of 2000.
  const auto finestWith = [&costs](double foreseen) {
    Governor governor({});
    std::vector<PlannedPair> pairs = knownPairs(costs, 100, 1);
    const std::vector<PlannedPair> apart = knownPairs(costs, 10, 1, 10.0, false);
    pairs.insert(pairs.end(), apart.begin(), apart.end());
    for (std::size_t i = 100; i < pairs.size(); ++i) pairs[i].wish.atMost = 1;
    governor.expect({.foreseen = foreseen, .expected = foreseen});
    governor.plan(pairs, costs, 0.0, 2000.0);
    return countAt(pairs, 3);
  };
  const int undisturbed = finestWith(0.0);
  EXPECT_GT(undisturbed, 5);
  EXPECT_EQ(finestWith(900.0), undisturbed) << "which take less than what is free";
  EXPECT_EQ(finestWith(3000.0), 0);
}

TEST(GovernorGivingBack, ABlockedPairIsNotAsked) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 2, 1);
  pairs[0].blockedSteps = 1;
  governor.plan(pairs, costs, 0.0, 2000.0);
  EXPECT_EQ(pairs[0].target, 1);
  EXPECT_EQ(pairs[1].target, 3);
}

// It would be asked in every step, in the place of others, and could not follow.
TEST(GovernorGivingBack, APairThatRestsIsNotAskedUntilItWakes) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 200, 1);
  for (std::size_t i = 0; i < 100; ++i) {
    pairs[i].rests = true;
    pairs[i].wish.importance = 10.0F;
  }
  const std::span<PlannedPair> all(pairs);
  for (int i = 0; i < 60; ++i) {
    governor.plan(pairs, costs, 0.0, 2000.0);
    ASSERT_TRUE(
        std::ranges::all_of(all.first(100), [](const PlannedPair& pair) { return pair.target == 1; }));
    followPlan(pairs);
  }
  EXPECT_EQ(countAt(pairs, 3), 100);
  for (PlannedPair& pair : pairs) pair.rests = false;
  governor.plan(pairs, costs, 0.0, 2000.0);
  EXPECT_GT(countAt(pairs, 3), 100);
}

TEST(GovernorGivingBack, ADearImportantPairDoesNotHoldUpTheOthers) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 20, 1, 5.0);
  // There is no room for this one, but for all the others.
  pairs.push_back(knownPair(costs, 1, 500.0));
  pairs[20].wish.importance = 50.0F;
  for (int i = 0; i < 50; ++i) {
    governor.plan(pairs, costs, 500.0, 1000.0);
    followPlan(pairs);
  }
  EXPECT_EQ(countAt(pairs, 3), 20);
}

TEST(GovernorGivingBack, APairThatIsDearerThanAStepsShareComesBackToo) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = {knownPair(costs, 1, 60.0)};
  governor.plan(pairs, costs, 0.0, 500.0);
  EXPECT_EQ(pairs[0].target, 3);
}

TEST(GovernorGivingBack, ThePlanComesToRest) {
  CostModel costs{CostWeights{}};
  for (const double share : {0.5, 0.7, 0.8, 0.9, 1.0, 1.1}) {
    Governor governor({});
    std::vector<PlannedPair> pairs = variousPairs(costs, 200);
    int changes = 0;
    for (int i = 0; i < 120; ++i) {
      governor.plan(pairs, costs, 100.0, share * 4800.0);
      const int now = followPlan(pairs);
      if (i >= 60) changes += now;
      double units = 100.0;
      for (PlannedPair& pair : pairs) {
        const double finest = pair.cost.units[0];
        const double actual = pair.view.credited ? std::min(finest, 3.0 + 0.3 * finest) : finest;
        costs.learn(pair.cost, pair.view.level, 3, true, {.all = actual, .onCredit = pair.view.credited});
        units += actual;
      }
      governor.learn(units);
    }
    EXPECT_EQ(changes, 0) << share;
  }
}

}  // namespace
}  // namespace scatter::lod
