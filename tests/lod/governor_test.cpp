#include "lod/governor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "lod/fake_engine.h"
#include "lod/governor_pairs.h"

/// What holds of every plan.
namespace scatter::lod {
namespace {

using testing::countAt;
using testing::followPlan;
using testing::kNoBudget;
using testing::knownPairs;
using testing::newPair;
using testing::Random;
using testing::unitsAt;

constexpr float kOdd[] = {0.0F,
                          -1.0F,
                          1e30F,
                          std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity(),
                          std::numeric_limits<float>::quiet_NaN()};

TEST(Governor, WithoutABudgetAllGetWhatTheyWish) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 4, 2);
  pairs[1].wish.atMost = 1;
  pairs[2].wish.atMost = 1;
  pairs[2].wish.atLeast = 2;
  pairs[3].view.touching = false;
  governor.plan(pairs, costs, 100.0, kNoBudget);
  EXPECT_EQ(pairs[0].target, 3);
  EXPECT_EQ(pairs[1].target, 1);
  EXPECT_EQ(pairs[2].target, 2);
  EXPECT_EQ(pairs[3].target, 3);
  for (const PlannedPair& pair : pairs) EXPECT_FALSE(pair.byBudget);
  for (std::uint32_t i = 0; i < 1000; ++i) ASSERT_EQ(governor.planNew(newPair(i), costs), 3);
}

TEST(Governor, ABudgetThatIsLiftedGivesEverythingBackAtOnce) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 100, 3);
  governor.plan(pairs, costs, 0.0, 100.0);
  governor.learn(1000.0);
  EXPECT_LT(countAt(pairs, 3), 100);
  governor.plan(pairs, costs, 0.0, kNoBudget);
  EXPECT_EQ(countAt(pairs, 3), 100);
  EXPECT_EQ(governor.admission(), 1.0);
  EXPECT_EQ(governor.planNew(newPair(7), costs), 3);
}

TEST(Governor, TheFloorIsWhatPairsCostAsCoarseAsTheyMayBe) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 4, 3);
  governor.plan(pairs, costs, 100.0, kNoBudget);
  const double middle = unitsAt(2, 10.0);
  EXPECT_EQ(governor.floorUnits(pairs, costs), 100.0) << "pairs that nobody looked at take nothing";
  for (PlannedPair& pair : pairs) governor.spend(pair, 12.0, 12.0);
  // In contact they keep the level that is taken on credit.
  EXPECT_NEAR(governor.floorUnits(pairs, costs), 100.0 + 4 * middle, 1e-4);
  // A promise keeps one at its finest level; one that is coarser already stays there; a new one costs nothing
  // yet.
  pairs[0].wish.atLeast = 3;
  pairs[1].view.level = 1;
  pairs[2].view.level = 0;
  EXPECT_NEAR(governor.floorUnits(pairs, costs), 100.0 + 12.0 + 12.0 + middle, 1e-4);
}

TEST(Governor, TheFloorIsNoMoreThanWasTakenAndHasWhatAnyLevelTakes) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 2, 3);
  governor.plan(pairs, costs, 0.0, kNoBudget);
  governor.spend(pairs[0], 1.0, 1.0);
  governor.spend(pairs[1], 50.0, 50.0);
  pairs[1].bound = 30.0F;
  EXPECT_NEAR(governor.floorUnits(pairs, costs), 1.0 + 30.0, 1e-4);
}

TEST(Governor, ALullMakesTheReachableFloorNoCheaper) {
  CostModel costs{CostWeights{}};
  const auto reachableAfter = [&costs](double ofWhatWasPredicted) {
    Governor governor({});
    std::vector<PlannedPair> pairs = knownPairs(costs, 100, 3);
    for (int i = 0; i < 40; ++i) {
      governor.plan(pairs, costs, 100.0, 1e6);
      governor.learn(100.0 + ofWhatWasPredicted * 100.0 * unitsAt(3, 10.0));
    }
    return governor.reachableUnits();
  };
  const double predicted = 100.0 + 100.0 * unitsAt(1, 10.0);
  EXPECT_NEAR(reachableAfter(1.0), predicted, 1.0);
  EXPECT_NEAR(reachableAfter(0.7), predicted, 1.0);
  EXPECT_NEAR(reachableAfter(1.5), 100.0 + 1.5 * 100.0 * unitsAt(1, 10.0), 1.0);
}

TEST(Governor, GivesNothingUpForAnImpossibleBudgetThatDetailIsHardlyAnythingOf) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 100, 3);
  const auto planFor = [&](int steps, double fixed, double budget) {
    for (int i = 0; i < steps; ++i) {
      governor.plan(pairs, costs, fixed, budget);
      followPlan(pairs);
    }
  };
  planFor(29, 50'000.0, 10'000.0);
  EXPECT_FALSE(governor.isVain());
  EXPECT_LT(countAt(pairs, 3), 10) << "it may have been a slip";
  planFor(30, 50'000.0, 10'000.0);
  EXPECT_TRUE(governor.isVain());
  EXPECT_EQ(countAt(pairs, 3), 100);
  EXPECT_EQ(governor.planNew(newPair(7), costs), 3);
  for (const PlannedPair& pair : pairs) EXPECT_FALSE(pair.byBudget);
  // As soon as the budget is possible again, or detail is much of what there is, it is taken.
  planFor(30, 9'000.0, 10'000.0);
  EXPECT_FALSE(governor.isVain());
  planFor(60, 5'000.0, 1'000.0);
  EXPECT_FALSE(governor.isVain());
  EXPECT_LT(countAt(pairs, 3), 10);
}

TEST(Governor, DetailThatIsOnItsWayIsWeighedAsIfItWereThere) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> apart = knownPairs(costs, 1000, 1, 10.0, false);
  for (int i = 0; i < 60; ++i) governor.plan(apart, costs, 50'000.0, 10'000.0);
  EXPECT_FALSE(governor.isVain()) << "a thousand pairs that meet at their finest level take 10 000 units";
  apart.resize(100);
  for (int i = 0; i < 60; ++i) governor.plan(apart, costs, 50'000.0, 10'000.0);
  EXPECT_TRUE(governor.isVain());
}

TEST(Governor, KeepsFreeWhatPairsTakeThatAreAwaited) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> none;
  governor.awaitNew(100);
  governor.plan(none, costs, 0.0, 1000.0);
  int admitted = 0;
  for (std::uint32_t i = 0; i < 100; ++i) {
    PlannedPair pair = newPair(i);
    pair.view.level = static_cast<std::uint8_t>(governor.planNew(pair, costs));
    admitted += pair.view.level == 3 ? 1 : 0;
    const double units = pair.view.level == 3 ? 40.0 : 5.0;
    governor.spend(pair, units, units);
  }
  EXPECT_GT(admitted, 0);
  // All would take 4000 units: what the budget bears besides all others, a few at most too many.
  EXPECT_LE(admitted, (1000 - 500) / 35 + 3);
}

TEST(Governor, KnowsWhatAPairTakesThatGoesFiner) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 50, 3);
  const auto fill = [&] {
    governor.plan(pairs, costs, 0.0, 1000.0);
    governor.spend(420.0);
  };
  fill();
  EXPECT_FALSE(governor.isShortOfFiner(pairs[0], costs, false));
  for (int i = 0; i < 100; ++i) governor.learnFiner(pairs[0], costs, 110.0);
  fill();
  EXPECT_FALSE(governor.isShort());
  EXPECT_TRUE(governor.isShortOfFiner(pairs[0], costs, false));
}

TEST(Governor, LetsADearPairWaitForRoomForItsFirstLook) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 50, 3);
  PlannedPair& dear = pairs[0];
  dear.cost.units[0] = 100.0F;
  governor.plan(pairs, costs, 0.0, 1000.0);
  EXPECT_FALSE(governor.isShortOfFiner(dear, costs, true));
  governor.spend(300.0);
  EXPECT_TRUE(governor.isShortOfFiner(dear, costs, true));
  EXPECT_FALSE(governor.isShortOfFiner(dear, costs, false));
  EXPECT_FALSE(governor.isShortOfFiner(pairs[1], costs, true));
}

TEST(Governor, TakesAWorldWithoutPairs) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> none;
  for (const double budget : {kNoBudget, 1000.0, 1e-6}) {
    governor.plan(none, costs, 100.0, budget);
    EXPECT_EQ(governor.planned(), 100.0);
    governor.learn(100.0);
  }
}

TEST(Governor, AWideBudgetChangesNothing) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 100, 3);
  governor.plan(pairs, costs, 50.0, 2000.0);
  EXPECT_EQ(countAt(pairs, 3), 100);
  for (const PlannedPair& pair : pairs) EXPECT_FALSE(pair.byBudget);
  // 50 + 100 · 10
  EXPECT_NEAR(governor.planned(), 1050.0, 20.0);
}

TEST(Governor, ExpectsWhatThePairsCostNow) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 50, 3, 8.0);
  const std::vector<PlannedPair> coarse = knownPairs(costs, 50, 2, 8.0);
  pairs.insert(pairs.end(), coarse.begin(), coarse.end());
  for (PlannedPair& pair : pairs) pair.blockedSteps = 5;
  governor.plan(pairs, costs, 30.0, 3000.0);
  // 30 + 50 · 8 + 50 · 3.2
  EXPECT_NEAR(governor.planned(), 590.0, 20.0);
}

TEST(Governor, ExpectsNothingOfPairsThatRestAndAllOfThoseThatWake) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 10, 3);
  for (const bool rests : {false, true, false}) {
    for (PlannedPair& pair : pairs) pair.rests = rests;
    for (const double budget : {1000.0, kNoBudget}) {
      governor.plan(pairs, costs, 50.0, budget);
      EXPECT_NEAR(governor.planned(), rests ? 50.0 : 150.0, 1e-3);
    }
  }
}

TEST(Governor, PromisesHoldWhateverTheBudget) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 90, 3);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    pairs[i].wish.atLeast = static_cast<std::uint8_t>(1 + i % 3);
    pairs[i].view.touching = i % 2 == 0;
  }
  for (const double budget : {900.0, 400.0, 100.0, 1.0}) {
    for (int step = 0; step < 20; ++step) {
      governor.plan(pairs, costs, 0.0, budget);
      for (const PlannedPair& pair : pairs) ASSERT_GE(pair.target, pair.wish.atLeast);
      followPlan(pairs);
      governor.learn(governor.planned());
    }
  }
  PlannedPair promised = newPair(0);
  promised.wish.atLeast = 3;
  EXPECT_EQ(governor.planNew(promised, costs), 3);
}

TEST(Governor, PromisesAreKeptAtOnce) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 200, 1);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    pairs[i].wish.atLeast = 3;
    pairs[i].wish.atMost = 1;  // The promise wins.
    pairs[i].view.touching = i % 2 == 0;
  }
  governor.plan(pairs, costs, 0.0, 10.0);
  EXPECT_EQ(countAt(pairs, 3), 200);
}

TEST(Governor, RequestsAreFollowedAndAreNotTheBudgetsFault) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 50, 3);
  for (PlannedPair& pair : pairs) pair.wish.atMost = 2;
  governor.plan(pairs, costs, 0.0, 10000.0);
  EXPECT_EQ(countAt(pairs, 2), 50);
  for (const PlannedPair& pair : pairs) EXPECT_FALSE(pair.byBudget);
  PlannedPair asked = newPair(0);
  asked.wish.atMost = 2;
  EXPECT_EQ(governor.planNew(asked, costs), 2);
}

TEST(Governor, TellsWhatTheBudgetTook) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 50, 3);
  const std::vector<PlannedPair> coarse = knownPairs(costs, 50, 1);
  pairs.insert(pairs.end(), coarse.begin(), coarse.end());
  governor.plan(pairs, costs, 0.0, 300.0);
  EXPECT_GT(countAt(pairs, 1), 0);
  EXPECT_GT(countAt(pairs, 2), 0);
  for (const PlannedPair& pair : pairs) EXPECT_EQ(pair.byBudget, pair.target < 3);
}

TEST(Governor, LearnsHowFarOffItsPlansAre) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 100, 3);
  for (int i = 0; i < 20; ++i) {
    governor.plan(pairs, costs, 100.0, 5000.0);
    governor.learn(100.0 + 1.5 * 1000.0);
  }
  governor.plan(pairs, costs, 100.0, 5000.0);
  EXPECT_NEAR(governor.planned(), 1600.0, 30.0);
  // One odd step changes nothing.
  governor.learn(20000.0);
  governor.plan(pairs, costs, 100.0, 50000.0);
  EXPECT_NEAR(governor.planned(), 1600.0, 30.0);
}

TEST(Governor, AStepIsShortOnceItCostsMoreThanItsBudgetBears) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 100, 3);
  governor.plan(pairs, costs, 100.0, 1300.0);
  EXPECT_FALSE(governor.isShort());
  // What the others are expected to take still counts.
  for (std::size_t i = 0; i < 10; ++i) governor.spend(pairs[i], 30.0, 30.0);
  EXPECT_NEAR(governor.planned(), 1100.0, 30.0);
  EXPECT_TRUE(governor.isShort());
  for (std::size_t i = 10; i < 40; ++i) governor.spend(pairs[i], 4.0, 4.0);
  EXPECT_FALSE(governor.isShort());
  governor.spend(150.0);
  EXPECT_TRUE(governor.isShort());
}

TEST(Governor, AStepIsShortNoMoreOncePairsHavePutOffEnough) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 100, 3);
  governor.plan(pairs, costs, 100.0, 1200.0);
  for (std::size_t i = 0; i < 10; ++i) governor.spend(pairs[i], 12.0, 12.0);
  EXPECT_TRUE(governor.isShort());
  for (std::size_t i = 10; i < 40; ++i) governor.spend(pairs[i], 4.0, 10.0);
  EXPECT_FALSE(governor.isShort());
}

// In a crash contacts become more at once.
TEST(Governor, ExpectsPairsToBeAsDearAsThoseBeforeThem) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 100, 3);
  const auto isShortAfter = [&](double units, double full) {
    governor.plan(pairs, costs, 0.0, 1200.0);
    for (std::size_t i = 0; i < 20; ++i) governor.spend(pairs[i], units, full);
    return governor.isShort();
  };
  EXPECT_FALSE(isShortAfter(10.0, 10.0));
  EXPECT_TRUE(isShortAfter(15.0, 15.0)) << "300 units, and 1200 more of the others";
  EXPECT_FALSE(isShortAfter(1.0, 1.0));
  EXPECT_FALSE(isShortAfter(1.0, 15.0)) << "what was put off says nothing of the others";
}

TEST(Governor, NewPairsAreRefusedInAShortStep) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 10, 3);
  governor.plan(pairs, costs, 0.0, 1000.0);
  EXPECT_EQ(governor.planNew(newPair(7), costs), 3);
  governor.spend(pairs[0], 950.0, 950.0);
  EXPECT_LT(governor.planNew(newPair(8), costs), 3);
  PlannedPair promised = newPair(9);
  promised.wish.atLeast = 3;
  EXPECT_EQ(governor.planNew(promised, costs), 3);
}

TEST(Governor, WithoutABudgetNoStepIsShort) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 10, 3);
  governor.plan(pairs, costs, 0.0, kNoBudget);
  governor.spend(1e12);
  EXPECT_FALSE(governor.isShort());
}

TEST(Governor, WhatWasPutOffDoesNotCountAsForeseenTooHigh) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 100, 3);
  for (int i = 0; i < 40; ++i) {
    governor.plan(pairs, costs, 100.0, 5000.0);
    for (PlannedPair& pair : pairs) governor.spend(pair, 5.0, 10.0);
    governor.learn(600.0);
  }
  governor.plan(pairs, costs, 100.0, 5000.0);
  EXPECT_NEAR(governor.planned(), 1100.0, 30.0);
}

TEST(Governor, KeepsFreeWhatStepsCostMoreThanForeseen) {
  CostModel costs{CostWeights{}};
  for (const double surprise : {0.0, 150.0}) {
    Governor governor({});
    std::vector<PlannedPair> pairs = knownPairs(costs, 100, 3, 0.5, false);
    for (int i = 0; i < 40; ++i) {
      governor.plan(pairs, costs, 500.0, 1000.0);
      governor.learn(governor.planned() + surprise * (i % 2));
    }
    // As full as the budget bears, if steps cost what was foreseen.
    governor.plan(pairs, costs, 780.0, 1000.0);
    if (surprise > 0.0)
      EXPECT_LT(governor.admission(), 1.0);
    else
      EXPECT_EQ(governor.admission(), 1.0);
  }
}

TEST(Governor, AWorldThatStartsHeavyIsNotTakenForOneThatGetsHeavier) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 100, 3);
  for (int i = 0; i < 5; ++i) {
    governor.plan(pairs, costs, 0.0, 1600.0);
    EXPECT_EQ(countAt(pairs, 3), 100) << "in step " << i;
    EXPECT_EQ(governor.admission(), 1.0) << "in step " << i;
    governor.learn(1000.0);
  }
}

/// After ten steps with the same pairs, of which the last cost 1100 and each `rise` more than the one before.
double admissionAfter(double rise, double budget) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 100, 3);
  for (int i = -9; i <= 0; ++i) {
    governor.plan(pairs, costs, 100.0 + rise * i, 10000.0);
    governor.learn(1100.0 + rise * i);
  }
  governor.plan(pairs, costs, 100.0, budget);
  return governor.admission();
}

TEST(Governor, ForeseesARise) {
  int different = 0;
  for (double budget = 1100.0; budget < 1800.0; budget += 20.0) {
    const double steady = admissionAfter(0.0, budget);
    const double rising = admissionAfter(10.0, budget);
    EXPECT_LE(rising, steady) << budget;
    different += rising < steady ? 1 : 0;
  }
  EXPECT_GT(different, 3);
}

TEST(Governor, DecidesTheSameEveryTime) {
  CostModel costs{CostWeights{}};
  Random random(8);
  std::vector<PlannedPair> pairs = knownPairs(costs, 500, 3);
  for (PlannedPair& pair : pairs) {
    pair.wish.importance = static_cast<float>(random.uniform(0.1, 10.0));
    pair.view.touching = random.uniform() < 0.6;
  }
  std::vector<PlannedPair> again = pairs;
  Governor a({});
  Governor b({});
  for (int step = 0; step < 30; ++step) {
    a.plan(pairs, costs, 50.0, 2500.0);
    b.plan(again, costs, 50.0, 2500.0);
    for (std::size_t i = 0; i < pairs.size(); ++i) ASSERT_EQ(pairs[i].target, again[i].target);
    ASSERT_EQ(a.planNew(newPair(1000), costs), b.planNew(newPair(1000), costs));
    ASSERT_EQ(a.planned(), b.planned());
    followPlan(pairs);
    followPlan(again);
    a.learn(a.planned());
    b.learn(b.planned());
  }
}

TEST(Governor, AnOddImportanceHarmsNobody) {
  CostModel costs{CostWeights{}};
  for (const float odd : kOdd) {
    for (const double budget : {300.0, 900.0, 1300.0, 5000.0}) {
      Governor plain({});
      Governor governor({});
      std::vector<PlannedPair> pairs = knownPairs(costs, 100, 3);
      std::vector<PlannedPair> others = pairs;
      pairs[20].wish.importance = odd;
      plain.plan(others, costs, 0.0, budget);
      governor.plan(pairs, costs, 0.0, budget);
      ASSERT_GE(pairs[20].target, 1);
      ASSERT_LE(pairs[20].target, 3);
      ASSERT_GT(governor.planned(), 0.0);
      int different = 0;
      for (std::size_t i = 0; i < pairs.size(); ++i) different += pairs[i].target != others[i].target ? 1 : 0;
      EXPECT_LE(different, 2) << odd << " at " << budget;
    }
  }
}

TEST(Governor, SurvivesAnyWish) {
  CostModel costs{CostWeights{}};
  Random random(12);
  Governor governor({});
  std::vector<PlannedPair> pairs;
  for (std::uint32_t i = 0; i < 300; ++i) {
    PlannedPair pair = newPair(i);
    pair.view.finest = static_cast<std::uint8_t>(random.uniform(1.0, 9.0));
    pair.view.level = static_cast<std::uint8_t>(random.uniform(0.0, pair.view.finest + 0.99));
    pair.view.touching = random.uniform() < 0.5;
    pair.kind = static_cast<std::uint8_t>(random.uniform(0.0, PlannedPair::kKinds));
    pairs.push_back(pair);
  }
  for (int step = 0; step < 200; ++step) {
    for (PlannedPair& pair : pairs) {
      pair.wish = {kOdd[static_cast<int>(random.uniform(0.0, 6.0))],
                   static_cast<std::uint8_t>(random.uniform(0.0, 256.0)),
                   static_cast<std::uint8_t>(random.uniform(0.0, 12.0)), 0};
      pair.blockedSteps = random.uniform() < 0.1 ? 2 : 0;
    }
    governor.plan(pairs, costs, 10.0, random.uniform(1.0, 2000.0));
    ASSERT_GE(governor.admission(), 0.0);
    ASSERT_LE(governor.admission(), 1.0);
    double units = 10.0;
    for (PlannedPair& pair : pairs) {
      ASSERT_GE(pair.target, std::clamp<int>(pair.wish.atLeast, 1, pair.view.finest));
      ASSERT_LE(pair.target, pair.view.finest);
      if (random.uniform() < 0.7) pair.view.level = pair.target;
      if (pair.view.level == 0) continue;
      const double cost = pair.view.level * random.exponential();
      units += cost;
      costs.learn(pair.cost, pair.view.level, pair.view.finest, pair.view.touching, {cost});
    }
    governor.learn(units);
  }
}

}  // namespace
}  // namespace scatter::lod
