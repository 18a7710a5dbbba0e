#include <gtest/gtest.h>

#include <vector>

#include "lod/governor.h"
#include "lod/governor_pairs.h"

/// Who may have detail before contact.
namespace scatter::lod {
namespace {

using testing::admitNew;
using testing::countAt;
using testing::followPlan;
using testing::knownPairs;
using testing::newPair;

constexpr double kBudget = 1000.0;

/// A governor whose fixed units take so much of the budget.
Governor loaded(const CostModel& costs, double share) {
  Governor governor({});
  governor.plan({}, costs, share * kBudget, kBudget);
  return governor;
}

/// A load at which some are admitted and some are not.
double halfLoad(const CostModel& costs) {
  double share = 0.0;
  while (loaded(costs, share).admission() > 0.5) share += 0.005;
  return share;
}

TEST(GovernorAdmission, EverybodyIsAdmittedWithRoom) {
  CostModel costs{CostWeights{}};
  Governor governor = loaded(costs, 0.3);
  EXPECT_EQ(governor.admission(), 1.0);
  EXPECT_EQ(admitNew(governor, costs, 1000), 1000);
}

TEST(GovernorAdmission, NobodyIsAdmittedWithout) {
  CostModel costs{CostWeights{}};
  Governor governor = loaded(costs, 1.1);
  EXPECT_EQ(governor.admission(), 0.0);
  EXPECT_EQ(admitNew(governor, costs, 1000), 0);
  PlannedPair important = newPair(0);
  important.wish.importance = 50.0F;
  EXPECT_EQ(admitNew(governor, costs, 1000, important), 0);
}

TEST(GovernorAdmission, TheShareGrowsWithTheRoom) {
  CostModel costs{CostWeights{}};
  int before = 1000;
  bool some = false;
  for (double share = 0.5; share < 1.2; share += 0.01) {
    Governor governor = loaded(costs, share);
    const double admission = governor.admission();
    const int admitted = admitNew(governor, costs, 1000);
    EXPECT_LE(admitted, before);
    // Nobody any more in a step that is short already.
    EXPECT_NEAR(admitted, governor.isShort() ? 0.0 : 1000.0 * admission, 3.0);
    some = some || (admitted > 0 && admitted < 1000);
    before = admitted;
  }
  EXPECT_TRUE(some);
  EXPECT_EQ(before, 0);
}

TEST(GovernorAdmission, IsMonotoneInImportance) {
  CostModel costs{CostWeights{}};
  const double share = halfLoad(costs);
  for (std::uint32_t identity = 0; identity < 300; ++identity) {
    int before = 0;
    for (const float importance : {0.0F, 0.1F, 0.5F, 0.99F, 1.0F, 1.01F, 2.0F, 8.0F, 1e6F}) {
      Governor governor = loaded(costs, share);
      PlannedPair pair = newPair(identity);
      pair.wish.importance = importance;
      const int level = governor.planNew(pair, costs);
      ASSERT_GE(level, before) << "importance " << importance << ", pair " << identity;
      before = level;
    }
    ASSERT_EQ(before, 3);
  }
}

TEST(GovernorAdmission, ImportantPairsAreAdmittedMoreOften) {
  CostModel costs{CostWeights{}};
  const double share = halfLoad(costs);
  int before = -1;
  for (const float importance : {0.1F, 0.5F, 1.0F, 2.0F, 8.0F}) {
    Governor governor = loaded(costs, share);
    PlannedPair pair = newPair(0);
    pair.wish.importance = importance;
    const int admitted = admitNew(governor, costs, 1000, pair);
    EXPECT_GT(admitted, before + 50) << importance;
    before = admitted;
  }
}

TEST(GovernorAdmission, CheapKindsComeFirst) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 50, 3, 2.0);
  const std::vector<PlannedPair> dear = knownPairs(costs, 50, 3, 12.0);
  pairs.insert(pairs.end(), dear.begin(), dear.end());
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i].kind = i < 50 ? 4 : 9;
  double fixed = 0.0;
  for (double admission = 1.0; admission > 0.5; fixed += 5.0) {
    Governor probe({});
    std::vector<PlannedPair> same = pairs;
    probe.plan(same, costs, fixed, kBudget);
    admission = probe.admission();
  }
  governor.plan(pairs, costs, fixed, kBudget);
  PlannedPair cheap = newPair(0);
  cheap.kind = 4;
  PlannedPair costly = newPair(0);
  costly.kind = 9;
  EXPECT_GT(admitNew(governor, costs, 1000, cheap), 1.5 * admitNew(governor, costs, 1000, costly));
  // With room, what they cost does not matter.
  governor.plan(pairs, costs, 0.0, 3.0 * kBudget);
  EXPECT_EQ(admitNew(governor, costs, 1000, costly), 1000);
}

/// A pile that grows by so many pairs a step, all at their coarsest level, for so many steps.
Governor watching(CostModel& costs, int pairsAStep, int steps, double budget) {
  Governor governor({});
  for (int step = 1; step <= steps; ++step) {
    std::vector<PlannedPair> pairs = knownPairs(costs, pairsAStep * step, 1, 10.0);
    governor.plan(pairs, costs, 100.0, budget);
    governor.learn(governor.planned());
  }
  return governor;
}

TEST(GovernorAdmission, KeepsRoomForWhatIsOnItsWay) {
  CostModel costs{CostWeights{}};
  constexpr int kSteps = 40;
  // The same load: who comes to it quickly goes on, as far as is known.
  double before = 2.0;
  for (const int pairsAStep : {0, 1, 2, 4}) {
    const double load = 100.0 + 1.0 * kSteps * pairsAStep;
    const double admission = watching(costs, pairsAStep, kSteps, 2.0 * load).admission();
    EXPECT_LE(admission, before) << pairsAStep;
    before = admission;
  }
  EXPECT_EQ(watching(costs, 0, kSteps, 200.0).admission(), 1.0);
  EXPECT_EQ(before, 0.0);
}

TEST(GovernorAdmission, KeepsRoomForBodiesThatAreOnTheirWay) {
  CostModel costs{CostWeights{}};
  double before = 2.0;
  for (const double bodyUnitsAStep : {0.0, 1.0, 2.0, 4.0}) {
    Governor governor({});
    std::vector<PlannedPair> pairs = knownPairs(costs, 10, 1, 10.0);
    const double load = 110.0 + 40.0 * bodyUnitsAStep;
    for (int step = 1; step <= 40; ++step) {
      governor.plan(pairs, costs, 100.0 + bodyUnitsAStep * step, 2.0 * load);
      governor.learn(governor.planned());
    }
    EXPECT_LE(governor.admission(), before) << bodyUnitsAStep;
    before = governor.admission();
  }
  EXPECT_EQ(before, 0.0);
}

TEST(GovernorAdmission, KeepsRoomForPairsThatAreForeseen) {
  CostModel costs{CostWeights{}};
  const auto admission = [&costs](double expected) {
    Governor governor({});
    std::vector<PlannedPair> pairs = knownPairs(costs, 100, 1, 10.0, false);
    governor.expect({.foreseen = 0.0, .expected = expected});
    governor.plan(pairs, costs, 100.0, kBudget);
    return governor.admission();
  };
  EXPECT_EQ(admission(0.0), 1.0);
  EXPECT_EQ(admission(100.0), 1.0) << "200 units are taken, and they take as much as those that are there";
  double before = 1.0;
  for (double expected = 200.0; expected < 600.0; expected += 50.0) {
    EXPECT_LE(admission(expected), before) << expected;
    before = admission(expected);
  }
  EXPECT_EQ(before, 0.0);
}

TEST(GovernorAdmission, ALullIsNotTheEndOfAPile) {
  CostModel costs{CostWeights{}};
  constexpr int kSteps = 40;
  constexpr double kTwiceTheLoad = 2.0 * (100.0 + 4.0 * kSteps);
  Governor governor = watching(costs, 4, kSteps, kTwiceTheLoad);
  std::vector<PlannedPair> pairs = knownPairs(costs, 4 * kSteps, 1, 10.0);
  const auto rest = [&](int steps) {
    for (int step = 0; step < steps; ++step) {
      governor.plan(pairs, costs, 100.0, kTwiceTheLoad);
      governor.learn(governor.planned());
    }
    return governor.admission();
  };
  EXPECT_EQ(rest(12), 0.0) << "a fifth of a second";
  EXPECT_EQ(rest(48), 1.0) << "a second";
}

TEST(GovernorAdmission, APileThatIsThereNeedsNoMoreRoom) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 400, 1, 10.0);
  for (int step = 0; step < 200; ++step) {
    governor.plan(pairs, costs, 100.0, 2.0 * kBudget);
    governor.learn(governor.planned());
  }
  EXPECT_EQ(governor.admission(), 1.0);
}

TEST(GovernorAdmission, AMiddleLevelIsForThoseWhoAreRefusedIfItIsAffordable) {
  CostModel costs{CostWeights{}};
  GovernorDef def;
  for (const int creditLevel : {1, 2}) {
    def.creditLevel = creditLevel;
    std::vector<PlannedPair> cheap = knownPairs(costs, 100, 3, 10.0);
    Governor roomy(def);
    roomy.plan(cheap, costs, 0.0, 0.95 * 100 * 10.0);
    ASSERT_LT(roomy.admission(), 1.0);
    PlannedPair refused = newPair(1);
    while (roomy.planNew(refused, costs) == 3) ++refused.identity;
    EXPECT_EQ(roomy.planNew(refused, costs), creditLevel);
    refused.wish.atMost = 1;
    EXPECT_EQ(roomy.planNew(refused, costs), 1);
    Governor tight(def);
    tight.plan(cheap, costs, 0.0, 0.2 * 100 * 10.0);
    EXPECT_EQ(tight.planNew(newPair(1), costs), 1);
  }
}

TEST(GovernorAdmission, NewPairsAreCharged) {
  CostModel costs{CostWeights{}};
  Governor governor = loaded(costs, 0.3);
  double before = governor.planned();
  for (std::uint32_t i = 0; i < 10; ++i) {
    const double expected = costs.predict({}, governor.planNew(newPair(i), costs), 0, 3, false);
    EXPECT_NEAR(governor.planned() - before, expected, 1e-9);
    EXPECT_GT(governor.planned(), before);
    before = governor.planned();
  }
}

TEST(GovernorAdmission, PairsThatAreApartComeAndGoWithTheRoom) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 200, 3, 0.5, false);
  for (int i = 0; i < 100; ++i) {
    governor.plan(pairs, costs, 0.98 * kBudget, kBudget);
    followPlan(pairs);
  }
  EXPECT_EQ(countAt(pairs, 3), 0);
  for (int i = 0; i < 100; ++i) {
    governor.plan(pairs, costs, 0.3 * kBudget, kBudget);
    followPlan(pairs);
  }
  EXPECT_EQ(countAt(pairs, 3), 200);
}

TEST(GovernorAdmission, ChangesAreSpreadOverSteps) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 500, 1, 0.5, false);
  governor.plan(pairs, costs, 0.0, kBudget);
  const int changes = followPlan(pairs);
  EXPECT_GT(changes, 0);
  EXPECT_LE(changes * costs.weights().switched, 0.05 * kBudget);
}

/// These pairs after a step of a governor that has seen them for so long, and then has no room.
std::vector<PlannedPair> afterTightStep(std::vector<PlannedPair> pairs, const CostModel& costs, double tight,
                                        int steps = 40) {
  constexpr double kPlenty = 1e6;
  Governor governor({});
  for (int i = 0; i < steps; ++i) {
    governor.plan(pairs, costs, 0.0, kPlenty);
    governor.learn(governor.planned());
  }
  governor.plan(pairs, costs, 0.0, tight);
  return pairs;
}

// A switch that saves in its own step what it costs is not held up; one that does not is.
TEST(GovernorAdmission, WhoeverPaysForItsSwitchAtOnceGoesAtOnce) {
  CostModel costs{CostWeights{}};
  const std::vector<PlannedPair> dear = knownPairs(costs, 200, 3, 20.0, false);
  const std::vector<PlannedPair> cheap = knownPairs(costs, 200, 3, 2.0, false);
  EXPECT_EQ(countAt(afterTightStep(dear, costs, 0.2 * 200 * 20.0), 1), 200);
  const int some = countAt(afterTightStep(cheap, costs, 0.2 * 200 * 2.0), 1);
  EXPECT_GT(some, 0);
  EXPECT_LT(some, 20);
}

// Where there is room for all of them at a middle level, cheap ones at their finest level are left there.
TEST(GovernorAdmission, WhoeverIsApartAndDearGoesToAMiddleLevelIfThereIsNoRoom) {
  CostModel costs{CostWeights{}};
  const std::vector<PlannedPair> dear = knownPairs(costs, 100, 3, 20.0, false);
  const std::vector<PlannedPair> cheap = knownPairs(costs, 100, 3, 1.0, false);
  EXPECT_EQ(countAt(afterTightStep(dear, costs, 0.8 * 100 * 20.0), 2), 100);
  EXPECT_EQ(countAt(afterTightStep(dear, costs, 2.0 * 100 * 20.0), 3), 100);
  EXPECT_EQ(countAt(afterTightStep(cheap, costs, 0.8 * 100 * 1.0), 3), 100);
}

// What pairs cost is a guess at first.
TEST(GovernorAdmission, NobodyIsTurnedAwayInHasteAtFirst) {
  CostModel costs{CostWeights{}};
  const std::vector<PlannedPair> dear = knownPairs(costs, 200, 3, 20.0, false);
  EXPECT_GT(countAt(afterTightStep(dear, costs, 0.2 * 200 * 20.0, 5), 3), 160);
}

TEST(GovernorAdmission, ABlockedPairIsLeftAlone) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 2, 2, 0.5, false);
  pairs[0].blockedSteps = 1;
  governor.plan(pairs, costs, 0.0, kBudget);
  EXPECT_EQ(pairs[0].target, 2);
  EXPECT_FALSE(pairs[0].byBudget);
  EXPECT_EQ(pairs[1].target, 3);
}

TEST(GovernorAdmission, NobodyIsTurnedAwayForALittleLessRoom) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  // So cheap that what they get changes nothing for the others.
  std::vector<PlannedPair> pairs = knownPairs(costs, 200, 1, 0.02, false);
  const double fixed = halfLoad(costs) * kBudget - 4.0;
  for (int i = 0; i < 100; ++i) {
    governor.plan(pairs, costs, fixed, kBudget);
    followPlan(pairs);
  }
  const int fine = countAt(pairs, 3);
  EXPECT_GT(fine, 20);
  EXPECT_LT(fine, 180);
  for (const double less : {0.0, 2.0, 4.0, 0.0, 4.0}) {
    governor.plan(pairs, costs, fixed + less, kBudget);
    EXPECT_EQ(followPlan(pairs), 0) << less;
  }
}

}  // namespace
}  // namespace scatter::lod
