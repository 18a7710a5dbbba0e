#include "lod/cost_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lod/fake_engine.h"

namespace scatter::lod {
namespace {

using testing::Random;

constexpr bool kTouching = true;

TEST(CostModel, AddsUpTheWorkOfAPair) {
  CostWeights weights;
  weights.pair = 1.0;
  weights.rebuild = 2.0;
  weights.childPair = 3.0;
  weights.gjkIteration = 7.0;
  weights.detectorRun = 11.0;
  weights.halfSpaceRun = 5.0;
  weights.contact = 13.0;
  weights.manifold = 17.0;
  weights.piece = 19.0;
  const CostModel costs(weights);
  // 1 + 2·1 + 3·2 + 7·4 + 11·5 + 5·3 + 13·6 + 17·7 + 19·8
  const PairWork counts{.rebuilds = 1,
                        .childPairs = 12,
                        .childPairsAsleep = 10,
                        .gjkIterations = 4,
                        .detectorRuns = 5,
                        .halfSpaceRuns = 3,
                        .pieces = 8};
  EXPECT_DOUBLE_EQ(costs.units(PairWorkload{.counts = counts, .contacts = 6, .manifolds = 7}), 456.0);
  EXPECT_DOUBLE_EQ(costs.units(PairWorkload{}), 1.0);
}

TEST(CostModel, CountsWhatNoLevelChanges) {
  CostWeights weights;
  weights.step = 7.0;
  weights.object = 2.0;
  weights.awakeBody = 3.0;
  weights.broadphasePair = 0.5;
  weights.joint = 5.0;
  weights.looseManifold = 4.0;
  weights.contact = 0.25;
  const CostModel costs(weights);
  EXPECT_DOUBLE_EQ(costs.units(StepLoad{.objects = 10, .awake = 4, .broadphasePairs = 8, .joints = 2}), 53.0);
  EXPECT_DOUBLE_EQ(costs.units(LooseContacts{.manifolds = 3, .points = 8}), 14.0);
}

TEST(CostModel, WhatAPairCostsAnywayIsNotTakenToShrinkWithItsLevel) {
  CostModel costs{CostWeights{}};
  PairCost cost;
  for (int i = 0; i < 200; ++i) costs.learn(cost, 3, 3, !kTouching, {10.0, 8.0});
  EXPECT_GT(costs.predict({}, 1, 0, 3, !kTouching), 7.0);
  EXPECT_LT(costs.predict({}, 1, 0, 3, !kTouching), costs.predict({}, 3, 0, 3, !kTouching));
  CostModel detailed{CostWeights{}};
  PairCost other;
  for (int i = 0; i < 200; ++i) detailed.learn(other, 3, 3, !kTouching, {10.0, 0.0});
  EXPECT_LT(detailed.predict({}, 1, 0, 3, !kTouching), 4.0);
}

TEST(CostModel, ExpectsFinerLevelsToCostMoreBeforeItKnowsAnything) {
  const CostModel costs{CostWeights{}};
  for (const bool touching : {false, true}) {
    for (int finest = 2; finest <= 6; ++finest) {
      for (int level = 2; level <= finest; ++level) {
        EXPECT_GT(costs.predict({}, level, 0, finest, touching),
                  costs.predict({}, level - 1, 0, finest, touching));
      }
    }
  }
}

TEST(CostModel, PredictsASteadyPairExactly) {
  CostModel costs{CostWeights{}};
  PairCost cost;
  for (int i = 0; i < 60; ++i) costs.learn(cost, 2, 3, kTouching, {8.0});
  EXPECT_NEAR(costs.predict(cost, 2, 2, 3, kTouching), 8.0, 0.1);
}

TEST(CostModel, RemembersWhatOtherLevelsCost) {
  CostModel costs{CostWeights{}};
  PairCost cost;
  for (int i = 0; i < 60; ++i) costs.learn(cost, 3, 3, kTouching, {20.0});
  for (int i = 0; i < 60; ++i) costs.learn(cost, 2, 3, kTouching, {4.0});
  EXPECT_NEAR(costs.predict(cost, 3, 2, 3, kTouching), 20.0, 3.0);
  for (int i = 0; i < 60; ++i) costs.learn(cost, 1, 3, kTouching, {1.0});
  EXPECT_NEAR(costs.predict(cost, 3, 1, 3, kTouching), 20.0, 3.0);
  EXPECT_NEAR(costs.predict(cost, 2, 1, 3, kTouching), 4.0, 0.6);
}

TEST(CostModel, WhatIsRememberedDoesNotDrift) {
  CostModel costs{CostWeights{}};
  Random random(4);
  PairCost cost;
  const double truth[] = {0.0, 1.0, 4.0, 20.0};
  int level = 3;
  for (int i = 0; i < 20000; ++i) {
    if (i % 7 == 0) level = 1 + static_cast<int>(random.uniform(0.0, 3.0));
    costs.learn(cost, level, 3, kTouching, {truth[level] * random.uniform(0.5, 1.5)});
    if (i < 200) continue;
    for (int other = 1; other <= 3; ++other) {
      const double predicted = costs.predict(cost, other, level, 3, kTouching);
      ASSERT_GT(predicted, 0.4 * truth[other]) << "level " << other << " in step " << i;
      ASSERT_LT(predicted, 2.5 * truth[other]) << "level " << other << " in step " << i;
    }
  }
}

TEST(CostModel, APairThatCalmsDownIsExpectedToBeCheaperAtOtherLevelsToo) {
  CostModel costs{CostWeights{}};
  PairCost cost;
  for (int i = 0; i < 60; ++i) costs.learn(cost, 3, 3, kTouching, {20.0});
  for (int i = 0; i < 60; ++i) costs.learn(cost, 2, 3, kTouching, {8.0});
  const double before = costs.predict(cost, 3, 2, 3, kTouching);
  for (int i = 0; i < 60; ++i) costs.learn(cost, 2, 3, kTouching, {2.0});
  EXPECT_NEAR(costs.predict(cost, 3, 2, 3, kTouching), before / 2.0, 0.15 * before);
}

TEST(CostModel, WhatAPairTakesOnCreditTellsLittleOfOtherLevels) {
  CostModel costs{CostWeights{}};
  PairCost cost;
  for (int i = 0; i < 60; ++i) costs.learn(cost, 3, 3, kTouching, {20.0});
  for (int i = 0; i < 60; ++i) costs.learn(cost, 2, 3, kTouching, {.all = 2.0, .onCredit = true});
  const double before = costs.predict(cost, 3, 2, 3, kTouching);
  for (int i = 0; i < 60; ++i) costs.learn(cost, 2, 3, kTouching, {.all = 12.0, .onCredit = true});
  EXPECT_NEAR(costs.predict(cost, 2, 2, 3, kTouching), 12.0, 0.1);
  EXPECT_GT(costs.predict(cost, 3, 2, 3, kTouching), before) << "it may be a pile that forms";
  EXPECT_LT(costs.predict(cost, 3, 2, 3, kTouching), 1.5 * before);
}

TEST(CostModel, NewPairsCostWhatTheirKindCosts) {
  CostModel costs{CostWeights{}};
  for (int i = 0; i < 200; ++i) {
    PairCost a;
    PairCost b;
    for (int step = 0; step < 5; ++step) {
      costs.learn(a, 3, 3, kTouching, {12.0});
      costs.learn(b, 3, 3, !kTouching, {0.5});
    }
  }
  EXPECT_NEAR(costs.predict({}, 3, 0, 3, kTouching), 12.0, 0.5);
  EXPECT_NEAR(costs.predict({}, 3, 0, 3, !kTouching), 0.5, 0.05);
}

TEST(CostModel, IsNotMisledByWhoIsChosenForACoarserLevel) {
  // Halfway costs a fifth, but only pairs that are dear at the finest level are sent there.
  CostModel costs{CostWeights{}};
  Random random(9);
  for (int i = 0; i < 400; ++i) {
    PairCost cost;
    const double finest = random.uniform(1.0, 20.0);
    for (int step = 0; step < 20; ++step) {
      const bool coarser = finest > 15.0 && step >= 10;
      costs.learn(cost, coarser ? 2 : 3, 3, kTouching, {coarser ? 0.2 * finest : finest});
    }
  }
  EXPECT_NEAR(costs.predict({}, 2, 0, 3, kTouching) / costs.predict({}, 3, 0, 3, kTouching), 0.2, 0.05);
}

TEST(CostModel, TheFirstStepAtALevelDoesNotCount) {
  CostModel costs{CostWeights{}};
  PairCost cost;
  for (int i = 0; i < 300; ++i) {
    cost = {};
    costs.learn(cost, 3, 3, kTouching, {15.0});
    for (int step = 0; step < 9; ++step) costs.learn(cost, 3, 3, kTouching, {10.0});
  }
  EXPECT_NEAR(costs.predict({}, 3, 0, 3, kTouching), 10.0, 0.5);
  // Nor when a pair comes back to a level.
  for (int i = 0; i < 20; ++i) costs.learn(cost, 2, 3, kTouching, {4.0});
  const double before = costs.predict(cost, 3, 2, 3, kTouching);
  costs.learn(cost, 3, 3, kTouching, {100.0});
  EXPECT_NEAR(costs.predict(cost, 3, 3, 3, kTouching), before, 0.1);
}

TEST(CostModel, TheSecondStepAtALevelShowsWhatItCostsThereNow) {
  CostModel costs{CostWeights{}};
  PairCost cost;
  for (int i = 0; i < 20; ++i) costs.learn(cost, 3, 3, kTouching, {10.0});
  for (int i = 0; i < 20; ++i) costs.learn(cost, 2, 3, kTouching, {4.0});
  costs.learn(cost, 3, 3, kTouching, {60.0});
  EXPECT_LT(costs.predict(cost, 3, 3, 3, kTouching), 15.0);
  costs.learn(cost, 3, 3, kTouching, {60.0});
  EXPECT_NEAR(costs.predict(cost, 3, 3, 3, kTouching), 60.0, 0.1);
  // One that falls is not believed at once, nor is a later rise.
  costs.learn(cost, 3, 3, kTouching, {20.0});
  costs.learn(cost, 3, 3, kTouching, {100.0});
  EXPECT_NEAR(costs.predict(cost, 3, 3, 3, kTouching), 65.0, 5.0);
}

TEST(CostModel, OfTheFirstStepWhatItsContactsTakeCounts) {
  const CostModel costs{CostWeights{}};
  const CostWeights weights;
  EXPECT_DOUBLE_EQ(
      costs.contactUnits(PairWorkload{.counts = {.childPairs = 50}, .contacts = 4, .manifolds = 2}),
      4.0 * weights.contact + 2.0 * (weights.manifold + weights.childPair));
  CostModel learning{CostWeights{}};
  PairCost apart;
  PairCost withContacts;
  learning.learn(apart, 3, 3, !kTouching, {40.0, 1.0, 0.0});
  learning.learn(withContacts, 3, 3, !kTouching, {40.0, 1.0, 25.0});
  EXPECT_LT(learning.predict(apart, 3, 3, 3, !kTouching), 5.0);
  EXPECT_GE(learning.predict(withContacts, 3, 3, 3, !kTouching), 25.0);
}

TEST(CostModel, SleepingPairsBecomeCheapAndTeachNothingAboutOthers) {
  CostModel costs{CostWeights{}};
  PairCost cost;
  for (int i = 0; i < 60; ++i) costs.learn(cost, 3, 3, kTouching, {10.0});
  const double kind = costs.predict({}, 3, 0, 3, kTouching);
  for (int i = 0; i < 100; ++i) costs.learn(cost, 3, 3, kTouching, {0.0});
  EXPECT_LT(costs.predict(cost, 3, 3, 3, kTouching), 0.05);
  EXPECT_NEAR(costs.predict({}, 3, 0, 3, kTouching), kind, 0.5);
}

TEST(CostModel, TakesAnyNumberOfLevels) {
  CostModel costs{CostWeights{}};
  PairCost cost;
  for (int level = 1; level <= 40; ++level) {
    for (int i = 0; i < 20; ++i) costs.learn(cost, level, 40, kTouching, {1.0 * level});
    EXPECT_NEAR(costs.predict(cost, level, level, 40, kTouching), level, 0.2 * level + 0.1);
  }
}

TEST(UnitTime, KnowsNothingAtFirst) {
  const UnitTime time;
  EXPECT_EQ(time.unitsIn(5.0), 0.0);
  EXPECT_EQ(time.millisecondsPerUnit(), 0.0);
}

TEST(UnitTime, IsNotImpressedForLongBySingleSteps) {
  UnitTime time;
  for (int i = 0; i < 40; ++i) time.learn(1000.0, i % 5 == 4 ? 20.0 : 2.0);
  EXPECT_LE(time.millisecondsPerUnit(), 0.0036) << "right after one of ten times the others";
  time.learn(1000.0, 2.0);
  EXPECT_GE(time.millisecondsPerUnit(), 0.002);
  EXPECT_LE(time.millisecondsPerUnit(), 0.0023);
  EXPECT_DOUBLE_EQ(time.unitsIn(5.0), 5.0 / time.millisecondsPerUnit());
}

TEST(UnitTime, ExpectsASlowStepToBeFollowedByAnother) {
  UnitTime time;
  for (int i = 0; i < 40; ++i) time.learn(1000.0, 2.0);
  EXPECT_DOUBLE_EQ(time.millisecondsPerUnit(), 0.002);
  time.learn(1000.0, 2.4);
  EXPECT_GE(time.millisecondsPerUnit(), 0.0024);
  time.learn(1000.0, 2.0);
  EXPECT_DOUBLE_EQ(time.millisecondsPerUnit(), 0.002);
}

TEST(UnitTime, FollowsAMachineThatBecomesSlower) {
  UnitTime time;
  for (int i = 0; i < 40; ++i) time.learn(1000.0, 2.0);
  for (int i = 0; i < 20; ++i) time.learn(1000.0, 4.0);
  EXPECT_DOUBLE_EQ(time.millisecondsPerUnit(), 0.004);
}

TEST(UnitTime, IgnoresStepsWithAlmostNoUnits) {
  UnitTime time;
  time.learn(1.0, 3.0);
  time.learn(1000.0, 0.0);
  EXPECT_EQ(time.unitsIn(5.0), 0.0);
}

}  // namespace
}  // namespace scatter::lod
