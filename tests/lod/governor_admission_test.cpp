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

/// So many that a middle level for all their pairs would take the whole budget.
constexpr int kManyBodies = 80;

/// A governor whose fixed units take so much of the budget.
Governor loaded(const CostModel& costs, double share, int bodies = 0) {
  Governor governor({});
  governor.plan({}, costs, share * kBudget, kBudget, bodies);
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
  // 700 units for the pairs.
  const double share = halfLoad(costs);
  governor.plan(pairs, costs, share * kBudget - 700.0, kBudget, 0);
  PlannedPair cheap = newPair(0);
  cheap.kind = 4;
  PlannedPair costly = newPair(0);
  costly.kind = 9;
  EXPECT_GT(admitNew(governor, costs, 1000, cheap), 1.5 * admitNew(governor, costs, 1000, costly));
  // With room, what they cost does not matter.
  governor.plan(pairs, costs, 0.0, 3.0 * kBudget, 0);
  EXPECT_EQ(admitNew(governor, costs, 1000, costly), 1000);
}

TEST(GovernorAdmission, KeepsRoomForBodiesThatAreOnTheirWay) {
  CostModel costs{CostWeights{}};
  double before = 2.0;
  for (const int bodies : {50, 100, 125, 150, 200}) {
    const double admission = loaded(costs, 0.1, bodies).admission();
    EXPECT_LE(admission, before) << bodies;
    before = admission;
  }
  EXPECT_EQ(loaded(costs, 0.1, 50).admission(), 1.0);
  EXPECT_EQ(before, 0.0);
}

TEST(GovernorAdmission, APileThatIsThereNeedsNoMoreRoom) {
  CostModel costs{CostWeights{}};
  const GovernorDef def;
  Governor alone(def);
  Governor piled(def);
  const int bodies = static_cast<int>(400.0 / def.pileUnits);
  // Pairs without detail that cost 400 units.
  std::vector<PlannedPair> pairs = knownPairs(costs, 400, 1, 10.0);
  const double fixed = halfLoad(costs) * kBudget - 400.0;
  alone.plan(pairs, costs, fixed, kBudget, 0);
  piled.plan(pairs, costs, fixed, kBudget, bodies);
  EXPECT_EQ(piled.admission(), alone.admission());
  EXPECT_NEAR(piled.admission(), 0.5, 0.2);
  // With detail, they say nothing about what they would cost without.
  pairs = knownPairs(costs, 60, 3, 10.0);
  alone.plan(pairs, costs, 0.0, kBudget, 0);
  piled.plan(pairs, costs, 0.0, kBudget, bodies);
  EXPECT_EQ(alone.admission(), 1.0);
  EXPECT_LT(piled.admission(), 0.5);
}

TEST(GovernorAdmission, AMiddleLevelIsForThoseWhoAreRefusedIfItIsAffordable) {
  CostModel costs{CostWeights{}};
  GovernorDef def;
  for (const int creditLevel : {1, 2}) {
    def.creditLevel = creditLevel;
    Governor few(def);
    few.plan({}, costs, 1.1 * kBudget, kBudget, 10);
    EXPECT_EQ(few.planNew(newPair(1), costs), creditLevel);
    PlannedPair asked = newPair(1);
    asked.wish.atMost = 1;
    EXPECT_EQ(few.planNew(asked, costs), 1);
    Governor many(def);
    many.plan({}, costs, 1.1 * kBudget, kBudget, kManyBodies);
    EXPECT_EQ(many.planNew(newPair(1), costs), 1);
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
    governor.plan(pairs, costs, 1.2 * kBudget, kBudget, kManyBodies);
    followPlan(pairs);
  }
  // Some may keep what they have.
  EXPECT_LE(countAt(pairs, 3), 40);
  for (int i = 0; i < 100; ++i) {
    governor.plan(pairs, costs, 0.3 * kBudget, kBudget, kManyBodies);
    followPlan(pairs);
  }
  EXPECT_EQ(countAt(pairs, 3), 200);
}

TEST(GovernorAdmission, ChangesAreSpreadOverSteps) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 500, 1, 0.5, false);
  governor.plan(pairs, costs, 0.0, kBudget, 0);
  const int changes = followPlan(pairs);
  EXPECT_GT(changes, 0);
  EXPECT_LE(changes * costs.weights().switched, 0.05 * kBudget);
}

TEST(GovernorAdmission, ABlockedPairIsLeftAlone) {
  CostModel costs{CostWeights{}};
  Governor governor({});
  std::vector<PlannedPair> pairs = knownPairs(costs, 2, 2, 0.5, false);
  pairs[0].blockedSteps = 1;
  governor.plan(pairs, costs, 0.0, kBudget, 0);
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
    governor.plan(pairs, costs, fixed, kBudget, kManyBodies);
    followPlan(pairs);
  }
  const int fine = countAt(pairs, 3);
  EXPECT_GT(fine, 20);
  EXPECT_LT(fine, 180);
  for (const double less : {0.0, 2.0, 4.0, 0.0, 4.0}) {
    governor.plan(pairs, costs, fixed + less, kBudget, kManyBodies);
    EXPECT_EQ(followPlan(pairs), 0) << less;
  }
}

}  // namespace
}  // namespace scatter::lod
