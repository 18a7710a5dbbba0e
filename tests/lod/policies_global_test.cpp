#include "lod/policies_global.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "lod/policy_world.h"

namespace scatter::lod {
namespace {

using testing::Dice;
using testing::kNothingAsked;
using testing::PolicyWorld;

/// How many steps of a fine load pass until a latch goes off.
int stepsUntilOff(Latch& latch) {
  int steps = 0;
  while (latch.isOn() && steps < 10000) {
    latch.update(false, true);
    ++steps;
  }
  return steps;
}

TEST(Latch, GoesOnAtOnceAndOffAfterAWhile) {
  Latch latch(5);
  latch.update(false, true);
  EXPECT_FALSE(latch.isOn());
  latch.update(true, false);
  EXPECT_TRUE(latch.isOn());
  EXPECT_EQ(stepsUntilOff(latch), 5);
}

TEST(Latch, TheWhileBeginsAnewWhenTheLoadIsNotFine) {
  Latch latch(5);
  latch.update(true, false);
  for (int i = 0; i < 100; ++i) {
    for (int fine = 0; fine < 4; ++fine) latch.update(false, true);
    latch.update(false, false);
    ASSERT_TRUE(latch.isOn());
  }
  EXPECT_EQ(stepsUntilOff(latch), 5);
}

TEST(Latch, WaitsLongerEachTimeThatItRelapses) {
  Latch latch(5);
  std::vector<int> waits;
  for (int i = 0; i < 7; ++i) {
    latch.update(true, false);
    waits.push_back(stepsUntilOff(latch));
  }
  EXPECT_EQ(waits, (std::vector<int>{5, 10, 20, 40, 80, 80, 80}));
  for (int i = 0; i < 100; ++i) latch.update(false, true);
  latch.update(true, false);
  EXPECT_EQ(stepsUntilOff(latch), 5) << "was off for long enough";
}

class LoadPolicyTest : public ::testing::Test {
 protected:
  std::uint8_t askAt(double units) {
    world_.load.units = units;
    ++world_.step;
    return world_.ask(policy_).atMost;
  }

  PolicyWorld world_ = PolicyWorld::twoBodies();
  LoadPolicy policy_{{.over = 1.0F, .fine = 0.5F, .steps = 3, .level = 2}};
};

TEST_F(LoadPolicyTest, AsksWhenAStepCostsTooMuchAndTakesItBackWhenTheLoadIsFine) {
  world_.load.budget = 100.0;
  EXPECT_EQ(askAt(99.0), kNothingAsked);
  EXPECT_EQ(askAt(101.0), 2);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(askAt(60.0), 2) << "neither over nor fine";
  EXPECT_EQ(askAt(49.0), 2);
  EXPECT_EQ(askAt(49.0), 2);
  EXPECT_EQ(askAt(49.0), kNothingAsked);
  EXPECT_EQ(askAt(99.0), kNothingAsked);
}

TEST_F(LoadPolicyTest, SaysNothingWithoutABudget) {
  EXPECT_EQ(askAt(1e9), kNothingAsked);
  world_.load.budget = 100.0;
  EXPECT_EQ(askAt(101.0), 2);
  world_.load.budget = 0.0;
  EXPECT_EQ(askAt(101.0), kNothingAsked);
}

/// Pairs of bodies that touch, with their middles at these places along x; a group's ball has a radius of 2
/// m.
PolicyWorld couples(const std::vector<float>& places) {
  PolicyWorld world;
  for (const float x : places) {
    const auto a = world.addBody(Vec3(x, -1.0F, 0.0F));
    world.addPair(a, world.addBody(Vec3(x, 1.0F, 0.0F))).touching = true;
  }
  return world;
}

TEST(OverlapPolicy, AsksWhileManyGroupsOverlap) {
  OverlapPolicy policy({.groups = 1, .members = 2, .steps = 3, .level = 1}, nullptr);
  PolicyWorld world = couples({0.0F, 3.9F, 20.0F});
  EXPECT_EQ(world.ask(policy).atMost, kNothingAsked) << "one overlap is not over the threshold";
  world = couples({0.0F, 3.9F, 7.8F});
  world.step = Grouping::kInterval;
  EXPECT_EQ(world.ask(policy).atMost, 1);

  world = couples({0.0F, 10.0F, 20.0F});
  world.step = 2 * Grouping::kInterval;
  EXPECT_EQ(world.ask(policy).atMost, 1);
  EXPECT_EQ(world.ask(policy).atMost, 1);
  EXPECT_EQ(world.ask(policy).atMost, kNothingAsked);
}

TEST(OverlapPolicy, DoesNotCountSmallGroups) {
  OverlapPolicy policy({.groups = 0, .members = 3}, nullptr);
  EXPECT_EQ(couples({0.0F, 1.0F, 2.0F}).ask(policy).atMost, kNothingAsked);
}

TEST(CountOverlaps, AgreesWithTryingAllPairsOfGroups) {
  Dice dice(3);
  for (int round = 0; round < 100; ++round) {
    std::vector<Group> groups(dice.below(40));
    for (Group& group : groups) {
      group.count = 2 + dice.below(4);
      group.center = dice.point(10.0F);
      group.reach = dice.between(0.1F, 5.0F);
    }
    int expected = 0;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const bool isLarge = groups[i].count >= 4 && groups[j].count >= 4;
        const float distance = glm::length(groups[i].center - groups[j].center);
        if (isLarge && distance < groups[i].reach + groups[j].reach) ++expected;
      }
    }
    EXPECT_EQ(countOverlaps(groups, 4), expected);
  }
}

TEST(FinestPolicy, PromisesTheFinestLevelOfEveryPair) {
  PolicyWorld world = PolicyWorld::twoBodies();
  FinestPolicy policy{FinestPolicy::Def{}};
  EXPECT_EQ(world.ask(policy).atLeast, 3);
  world.pairs[0].finest = 2;
  EXPECT_EQ(world.ask(policy).atLeast, 2);
}

TEST(CoarsestPolicy, AsksForLevel1) {
  const PolicyWorld world = PolicyWorld::twoBodies();
  CoarsestPolicy policy{CoarsestPolicy::Def{}};
  EXPECT_EQ(world.ask(policy).atMost, 1);
}

}  // namespace
}  // namespace scatter::lod
