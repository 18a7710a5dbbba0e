#include "lod/policies_group.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "lod/policy_world.h"

namespace scatter::lod {
namespace {

using testing::kNothingAsked;
using testing::PolicyWorld;

/// Eight balls of 1 m on the corners of a cube, each in contact with all others.
PolicyWorld cube(float halfSide) {
  PolicyWorld world;
  for (std::uint32_t i = 0; i < 8; ++i) {
    const float x = (i & 1U) != 0 ? halfSide : -halfSide;
    const float y = (i & 2U) != 0 ? halfSide : -halfSide;
    world.addBody(Vec3(x, y, (i & 4U) != 0 ? halfSide : -halfSide));
    for (std::uint32_t j = 0; j < i; ++j) world.addPair(j, i).touching = true;
  }
  return world;
}

void passInterval(PolicyWorld& world) {
  world.step += Grouping::kInterval;
}

// The ball around the cube has a radius of sqrt(3) halfSide + 1; the packing is 8 / radius^3.

TEST(GroupRangePolicy, LooksAtVolumeAgainstSpace) {
  GroupRangePolicy policy({.packing = 0.3F, .members = 8, .importance = 0.5F, .level = 2}, nullptr);
  PolicyWorld dense = cube(1.0F);  // 8 / 2.73^3 = 0.39
  Wish wish = dense.ask(policy);
  EXPECT_FLOAT_EQ(wish.importance, 0.5F);
  EXPECT_EQ(wish.atMost, 2);

  GroupRangePolicy other({.packing = 0.3F, .members = 8, .importance = 0.5F, .level = 2}, nullptr);
  PolicyWorld loose = cube(1.5F);  // 8 / 3.60^3 = 0.17
  wish = loose.ask(other);
  EXPECT_EQ(wish.importance, 1.0F);
  EXPECT_EQ(wish.atMost, kNothingAsked);
}

TEST(GroupRangePolicy, LooksAtTheNumberOfObjectsAgainstSpace) {
  const PolicyWorld world = cube(1.0F);  // 8 / (4/3 pi 2.73^3) = 0.094 in a cubic metre
  GroupRangePolicy under({.packing = 0.0F, .objects = 0.1F, .importance = 0.5F}, nullptr);
  EXPECT_EQ(world.ask(under).importance, 1.0F);
  GroupRangePolicy over({.packing = 0.0F, .objects = 0.09F, .importance = 0.5F}, nullptr);
  EXPECT_EQ(world.ask(over).importance, 0.5F);
}

TEST(GroupRangePolicy, LetsSmallGroupsAndOtherBodiesBe) {
  PolicyWorld world = cube(1.0F);
  GroupRangePolicy policy({.members = 9, .importance = 0.5F}, nullptr);
  EXPECT_EQ(world.ask(policy).importance, 1.0F);

  PolicyWorld two = cube(1.0F);
  const auto a = two.addBody(Vec3(50.0F));
  two.addPair(a, two.addBody(Vec3(53.0F)));
  GroupRangePolicy other({.importance = 0.5F}, nullptr);
  EXPECT_EQ(two.ask(other, 0).importance, 0.5F);
  EXPECT_EQ(two.ask(other, two.pairs.size() - 1).importance, 1.0F);
}

TEST(GroupRangePolicy, LooksAheadWhenAGroupContracts) {
  PolicyWorld world = cube(1.5F);
  const auto ask = [&](float speed, float ahead) {
    for (BodyView& body : world.bodies) body.velocity = -speed * glm::normalize(body.center);
    GroupRangePolicy policy({.packing = 0.3F, .ahead = ahead, .importance = 0.5F}, nullptr);
    return world.ask(policy).importance;
  };
  // 3.60 m - 1 m of contraction: 8 / 2.60^3 = 0.46
  EXPECT_EQ(ask(1.0F, 1.0F), 0.5F);
  EXPECT_EQ(ask(1.0F, 0.0F), 1.0F);
  EXPECT_EQ(ask(-1.0F, 1.0F), 1.0F) << "flies apart";
}

TEST(GroupRangePolicy, StaysUntilAFifthBelowTheThreshold) {
  const auto packingOf = [](const PolicyWorld& world) {
    const float radius = 1.0F + glm::length(world.bodies[0].center);
    return 8.0F / (radius * radius * radius);
  };
  PolicyWorld world = cube(1.0F);
  const GroupRangePolicy::Def def{.packing = 0.95F * packingOf(world), .ahead = 0.0F, .importance = 0.5F};
  GroupRangePolicy policy(def, nullptr);
  EXPECT_EQ(world.ask(policy).importance, 0.5F);

  const auto spread = [&](float threshold) {
    while (packingOf(world) > threshold * def.packing) {
      for (BodyView& body : world.bodies) body.center *= 1.001F;
    }
    passInterval(world);
  };
  spread(0.85F);
  EXPECT_EQ(world.ask(policy).importance, 0.5F) << "was over the threshold";
  GroupRangePolicy fresh(def, nullptr);
  EXPECT_EQ(world.ask(fresh).importance, 1.0F) << "was not";
  spread(0.79F);
  EXPECT_EQ(world.ask(policy).importance, 1.0F);
}

TEST(GroupSharePolicy, AsksForTheWholeGroupWhenManyMembersAreFast) {
  const auto ask = [](int fast) {
    PolicyWorld world = cube(1.0F);
    // In pairs that cancel, so that the group's mean stays at rest.
    for (int i = 0; i < fast; ++i) {
      world.bodies[static_cast<std::size_t>(i)].velocity = Vec3(0.0F, i % 2 == 0 ? 6.0F : -6.0F, 0.0F);
    }
    GroupSharePolicy policy({.share = 0.5F, .speed = 5.0F, .level = 2}, nullptr);
    return world.ask(policy, world.pairs.size() - 1).atMost;
  };
  EXPECT_EQ(ask(0), kNothingAsked);
  EXPECT_EQ(ask(4), kNothingAsked);
  EXPECT_EQ(ask(6), 2);
}

TEST(GroupSharePolicy, AGroupThatFliesAsOneIsNotFast) {
  PolicyWorld world = cube(1.0F);
  for (BodyView& body : world.bodies) body.velocity = Vec3(100.0F, 0.0F, 0.0F);
  GroupSharePolicy policy({}, nullptr);
  EXPECT_EQ(world.ask(policy).atMost, kNothingAsked);
}

TEST(GroupSharePolicy, MembersThatApproachSomethingCount) {
  PolicyWorld world = cube(1.0F);
  for (std::uint32_t i = 0; i < 6; ++i) {
    const auto visitor = world.addBody(3.0F * world.bodies[i].center, -6.0F * world.bodies[i].center);
    world.addPair(i, visitor);
  }
  GroupSharePolicy policy({.share = 0.5F, .approach = 5.0F, .level = 1}, nullptr);
  EXPECT_EQ(world.ask(policy).atMost, 1);
  for (PairView& pair : world.pairs) pair.touching = true;
  GroupSharePolicy touching({.share = 0.5F, .speed = 1e6F, .approach = 5.0F, .level = 1}, nullptr);
  EXPECT_EQ(world.ask(touching).atMost, kNothingAsked) << "is there already";
}

TEST(GroupDensityPolicy, FallsWithTheNumberOfAlikeNeighbours) {
  const auto ask = [](int from, int to) {
    const PolicyWorld world = cube(1.0F);  // Everyone has seven neighbours.
    GroupDensityPolicy policy({.from = from, .to = to, .least = 0.4F});
    return world.ask(policy).importance;
  };
  EXPECT_EQ(ask(7, 8), 1.0F);
  EXPECT_FLOAT_EQ(ask(5, 9), 0.7F);
  EXPECT_FLOAT_EQ(ask(3, 7), 0.4F);
  EXPECT_FLOAT_EQ(ask(0, 1), 0.4F);
}

TEST(GroupDensityPolicy, BodiesThatDoNotTouchAreNoNeighbours) {
  PolicyWorld world = cube(1.0F);
  for (PairView& pair : world.pairs) pair.touching = false;
  GroupDensityPolicy policy({.from = 0, .to = 1, .least = 0.4F});
  EXPECT_EQ(world.ask(policy).importance, 1.0F);
}

TEST(GroupDensityPolicy, OnlyAlikeNeighboursHideErrors) {
  PolicyWorld world = cube(1.0F);
  world.bodies[0].radius = 2.0F;
  GroupDensityPolicy policy({.from = 0, .to = 7, .alike = 1.5F, .least = 0.3F});
  EXPECT_EQ(world.ask(policy, 0).importance, 1.0F) << "unlike its neighbours, it is seen";
  std::swap(world.pairs[0].a, world.pairs[0].b);
  EXPECT_EQ(world.ask(policy, 0).importance, 1.0F) << "whichever comes first";
  // Six alike neighbours of seven: 1 - 0.7 * 6 / 7.
  EXPECT_FLOAT_EQ(world.ask(policy, world.pairs.size() - 1).importance, 0.4F);
}

TEST(GroupPolicies, ShareOneGrouping) {
  const PolicyWorld world = cube(1.0F);
  const auto grouping = std::make_shared<Grouping>();
  GroupRangePolicy range({.importance = 0.5F}, grouping);
  GroupSharePolicy share({.share = 0.5F, .speed = 1.0F}, grouping);
  EXPECT_EQ(world.ask(range).importance, 0.5F);
  EXPECT_EQ(world.ask(share).atMost, kNothingAsked);
  EXPECT_EQ(grouping->generation(), 1U);
}

TEST(GroupPolicies, AreReadyForBodiesThatHaveJustCome) {
  PolicyWorld world = cube(1.0F);
  GroupRangePolicy range({.importance = 0.5F}, nullptr);
  GroupDensityPolicy density({.from = 0, .to = 1, .least = 0.3F});
  EXPECT_EQ(world.ask(range).importance, 0.5F);
  EXPECT_FLOAT_EQ(world.ask(density).importance, 0.3F);
  ++world.step;
  const auto a = world.addBody(Vec3(20.0F));
  world.addPair(a, world.addBody(Vec3(23.0F)));
  EXPECT_EQ(world.ask(range, world.pairs.size() - 1).importance, 1.0F);
  EXPECT_EQ(world.ask(density, world.pairs.size() - 1).importance, 1.0F);
}

}  // namespace
}  // namespace scatter::lod
