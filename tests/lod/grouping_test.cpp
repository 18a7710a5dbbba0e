#include "lod/grouping.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "lod/policy_world.h"

namespace scatter::lod {
namespace {

using testing::PolicyWorld;
using testing::randomWorld;

/// The lowest body that each body can be reached from, by following pairs until nothing changes.
std::vector<std::uint32_t> reachedFrom(const Situation& situation) {
  std::vector<std::uint32_t> lowest(situation.bodies.size());
  for (std::uint32_t i = 0; i < lowest.size(); ++i) lowest[i] = i;
  bool changed = true;
  while (changed) {
    changed = false;
    for (const PairView& pair : situation.pairs) {
      const BodyView& a = situation.bodies[pair.a];
      const BodyView& b = situation.bodies[pair.b];
      if (a.mass == 0.0F || b.mass == 0.0F) continue;
      if (!pair.touching && glm::length(a.center - b.center) >= a.radius + b.radius) continue;
      const std::uint32_t low = std::min(lowest[pair.a], lowest[pair.b]);
      changed = changed || lowest[pair.a] != low || lowest[pair.b] != low;
      lowest[pair.a] = low;
      lowest[pair.b] = low;
    }
  }
  return lowest;
}

TEST(Grouping, FindsTheConnectedComponentsOfRandomWorlds) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto bodies = static_cast<std::uint32_t>(2 + seed % 60);
    const PolicyWorld world = randomWorld(seed, bodies, static_cast<std::uint32_t>(seed % 7) * bodies / 3);
    const Situation situation = world.situation();
    Grouping grouping;
    grouping.observe(situation);

    const auto truth = reachedFrom(situation);
    for (std::uint32_t i = 0; i < bodies; ++i) {
      const auto size = std::count(truth.begin(), truth.end(), truth[i]);
      EXPECT_EQ(grouping.groupOf(i) != Grouping::kNone, size > 1) << "seed " << seed << " body " << i;
      for (std::uint32_t j = 0; j < i && size > 1; ++j) {
        EXPECT_EQ(grouping.groupOf(i) == grouping.groupOf(j), truth[i] == truth[j]) << "seed " << seed;
      }
    }
  }
}

TEST(Grouping, ListsEveryMemberOnceInOrderAndNumbersGroupsByTheirFirst) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const PolicyWorld world = randomWorld(seed, 50, 60);
    Grouping grouping;
    grouping.observe(world.situation());
    std::vector<int> seen(50, 0);
    std::uint32_t before = 0;
    for (std::size_t g = 0; g < grouping.groups().size(); ++g) {
      const auto members = grouping.members(grouping.groups()[g]);
      ASSERT_GE(members.size(), 2U);
      EXPECT_TRUE(std::is_sorted(members.begin(), members.end()));
      EXPECT_TRUE(g == 0 || members.front() > before);
      before = members.front();
      for (const std::uint32_t member : members) {
        ++seen[member];
        EXPECT_EQ(grouping.groupOf(member), g);
      }
    }
    for (std::uint32_t i = 0; i < 50; ++i) {
      EXPECT_EQ(seen[i], grouping.groupOf(i) == Grouping::kNone ? 0 : 1);
    }
  }
}

TEST(Grouping, DoesNotDependOnTheOrderOfPairs) {
  PolicyWorld world = randomWorld(7, 80, 120);
  Grouping forwards;
  forwards.observe(world.situation());
  std::reverse(world.pairs.begin(), world.pairs.end());
  for (PairView& pair : world.pairs) std::swap(pair.a, pair.b);
  Grouping backwards;
  backwards.observe(world.situation());
  ASSERT_EQ(forwards.groups().size(), backwards.groups().size());
  for (std::size_t g = 0; g < forwards.groups().size(); ++g) {
    EXPECT_EQ(forwards.groups()[g].center, backwards.groups()[g].center);
    EXPECT_EQ(forwards.groups()[g].approach, backwards.groups()[g].approach);
  }
  for (std::uint32_t i = 0; i < 80; ++i) EXPECT_EQ(forwards.groupOf(i), backwards.groupOf(i));
}

TEST(Grouping, MeasuresAGroup) {
  PolicyWorld world;
  world.addBody(Vec3(-2.0F, 0.0F, 5.0F), Vec3(4.0F, 0.0F, 0.0F));
  world.addBody(Vec3(2.0F, 0.0F, 5.0F), Vec3(0.0F, 0.0F, 0.0F));
  world.bodies[0].radius = 2.0F;
  world.addPair(0, 1).touching = true;
  Grouping grouping;
  grouping.observe(world.situation());

  ASSERT_EQ(grouping.groups().size(), 1U);
  const Group& group = grouping.groups()[0];
  EXPECT_EQ(group.center, Vec3(0.0F, 0.0F, 5.0F));
  EXPECT_EQ(group.velocity, Vec3(2.0F, 0.0F, 0.0F));
  EXPECT_FLOAT_EQ(group.range, 2.0F);
  EXPECT_FLOAT_EQ(group.reach, 4.0F);
  // 4/3 pi (2^3 + 1^3) = 12 pi.
  EXPECT_FLOAT_EQ(group.volume, 37.699112F);
  // Each moves at 2 m/s towards the middle, seen from the mean.
  EXPECT_FLOAT_EQ(group.approach, 2.0F);
}

TEST(Grouping, AGroupThatFliesAsOneDoesNotApproachItself) {
  PolicyWorld world;
  for (const float x : {0.0F, 1.0F, 5.0F}) world.addBody(Vec3(x, 0.0F, 0.0F), Vec3(100.0F, 0.0F, 0.0F));
  world.addPair(0, 1).touching = true;
  world.addPair(1, 2).touching = true;
  Grouping grouping;
  grouping.observe(world.situation());
  ASSERT_EQ(grouping.groups().size(), 1U);
  EXPECT_EQ(grouping.groups()[0].approach, 0.0F);
}

TEST(Grouping, AFloorMakesNoGroup) {
  PolicyWorld world;
  const auto floor = world.addBody(Vec3(0.0F));
  world.bodies[floor].mass = 0.0F;
  for (const float x : {-5.0F, 5.0F})
    world.addPair(floor, world.addBody(Vec3(x, 1.0F, 0.0F))).touching = true;
  Grouping grouping;
  grouping.observe(world.situation());
  EXPECT_TRUE(grouping.groups().empty());
}

TEST(Grouping, APairIsTheAffairOfTheOneGroupThatItsBodiesAreIn) {
  PolicyWorld world;
  for (int i = 0; i < 5; ++i) world.addBody(Vec3(10.0F * static_cast<float>(i), 0.0F, 0.0F));
  world.addPair(0, 1).touching = true;
  world.addPair(2, 3).touching = true;
  Grouping grouping;
  grouping.observe(world.situation());
  EXPECT_EQ(grouping.groupOf({.a = 0, .b = 1}), 0U);
  EXPECT_EQ(grouping.groupOf({.a = 3, .b = 2}), 1U);
  EXPECT_EQ(grouping.groupOf({.a = 4, .b = 3}), 1U);
  EXPECT_EQ(grouping.groupOf({.a = 3, .b = 4}), 1U);
  EXPECT_EQ(grouping.groupOf({.a = 1, .b = 2}), Grouping::kNone);
  EXPECT_EQ(grouping.groupOf({.a = 4, .b = 99}), Grouping::kNone);
}

TEST(Grouping, IsMadeAnewOnceEveryFewSteps) {
  PolicyWorld world = PolicyWorld::twoBodies();
  Grouping grouping;
  for (world.step = 100; world.step < 100 + 3 * Grouping::kInterval; ++world.step) {
    grouping.observe(world.situation());
    grouping.observe(world.situation());
    EXPECT_EQ(grouping.generation(), 1 + (world.step - 100) / Grouping::kInterval);
  }
}

TEST(Grouping, StartsAgainWithAnotherRunAndForgetsBodiesThatAreGone) {
  PolicyWorld world = PolicyWorld::twoBodies();
  world.pairs[0].touching = true;
  world.step = 50;
  Grouping grouping;
  grouping.observe(world.situation());
  EXPECT_EQ(grouping.groupOf(1), 0U);

  world.step = 0;
  world.pairs.clear();
  world.bodies.pop_back();
  grouping.observe(world.situation());
  EXPECT_EQ(grouping.groupOf(1), Grouping::kNone);
  EXPECT_TRUE(grouping.groups().empty());
}

TEST(Grouping, AnEmptyWorldHasNoGroups) {
  Grouping grouping;
  grouping.observe(Situation{});
  EXPECT_TRUE(grouping.groups().empty());
  EXPECT_EQ(grouping.groupOf(0), Grouping::kNone);
}

}  // namespace
}  // namespace scatter::lod
