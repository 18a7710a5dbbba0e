#include "lod/policy_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "lod/make_policy.h"
#include "lod/policy_world.h"

namespace scatter::lod {
namespace {

using testing::Dice;
using testing::kNothingAsked;
using testing::PolicyWorld;
using testing::randomWorld;

/// Wants the same of every pair.
class ConstantPolicy final : public Policy {
 public:
  explicit ConstantPolicy(const Wish& wish) : wish_(wish) {}

  [[nodiscard]] std::string_view name() const override { return "constant"; }
  [[nodiscard]] Scope scope() const override { return Scope::kLocal; }
  void advise(const Situation& /*situation*/, const PairView& /*pair*/, Wish& wish) const override {
    wish = wish_;
  }

 private:
  Wish wish_;
};

Wish compose(const std::vector<Wish>& wishes, std::uint8_t finest = 3) {
  PolicyList list;
  for (const Wish& wish : wishes) list.add(std::make_unique<ConstantPolicy>(wish));
  PolicyWorld world = PolicyWorld::twoBodies();
  world.pairs[0].finest = finest;
  list.observe(world.situation());
  return list.advise(world.situation(), world.pairs[0]);
}

TEST(PolicyList, AnEmptyOneWantsNothing) {
  const Wish wish = compose({});
  EXPECT_EQ(wish.importance, 1.0F);
  EXPECT_EQ(wish.atMost, kNothingAsked);
  EXPECT_EQ(wish.atLeast, 1);
}

TEST(PolicyList, MultipliesImportance) {
  EXPECT_FLOAT_EQ(compose({{.importance = 0.5F}, {.importance = 3.0F}, {.importance = 4.0F}}).importance,
                  6.0F);
}

TEST(PolicyList, TheCoarsestRequestCountsAndItsPolicyIsNamed) {
  const Wish wish = compose({{}, {.atMost = 2}, {.atMost = 1}, {.atMost = 2}, {.atMost = 1}});
  EXPECT_EQ(wish.atMost, 1);
  EXPECT_EQ(wish.askedBy, 2) << "the first of those that ask for it";
}

TEST(PolicyList, TheFinestPromiseCountsAndWins) {
  const Wish wish = compose({{.atMost = 1}, {.atLeast = 2}, {.atLeast = 1}});
  EXPECT_EQ(wish.atLeast, 2);
  EXPECT_EQ(wish.atMost, 2);
  EXPECT_EQ(wish.askedBy, 0);
}

TEST(PolicyList, PromisesNoLevelThatAPairDoesNotHave) {
  EXPECT_EQ(compose({{.atLeast = 9}}, 2).atLeast, 2);
}

TEST(PolicyList, BringsImportanceIntoRange) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(compose({{.importance = 0.0F}}).importance, PolicyList::kLeastImportance);
  EXPECT_EQ(compose({{.importance = -1.0F}}).importance, PolicyList::kLeastImportance);
  EXPECT_EQ(compose({{.importance = kNan}}).importance, PolicyList::kLeastImportance);
  EXPECT_EQ(compose({{.importance = kInfinity}}).importance, PolicyList::kMostImportance);
  EXPECT_EQ(compose({{.atMost = 0}}).atMost, 1);
}

TEST(PolicyList, ComposesInAnyOrder) {
  Dice dice(11);
  for (int round = 0; round < 300; ++round) {
    std::vector<Wish> wishes(1 + dice.below(6));
    for (Wish& wish : wishes) {
      wish.importance = dice.between(0.2F, 5.0F);
      if (dice.below(2) == 0) wish.atMost = static_cast<std::uint8_t>(1 + dice.below(4));
      wish.atLeast = static_cast<std::uint8_t>(1 + dice.below(3));
    }
    const Wish forwards = compose(wishes);
    std::rotate(wishes.begin(), wishes.begin() + dice.below(static_cast<std::uint32_t>(wishes.size())),
                wishes.end());
    std::reverse(wishes.begin(), wishes.end());
    const Wish backwards = compose(wishes);
    EXPECT_NEAR(forwards.importance, backwards.importance, 1e-5F * forwards.importance);
    EXPECT_EQ(forwards.atMost, backwards.atMost);
    EXPECT_EQ(forwards.atLeast, backwards.atLeast);
  }
}

TEST(PolicyList, ItsPoliciesShareOneGrouping) {
  const std::vector<std::string> specs{"group-range", "overlap", "group-density", "group-share"};
  auto list = makePolicyList(specs);
  ASSERT_TRUE(list);
  (*list)->observe(PolicyWorld::twoBodies().situation());
  EXPECT_EQ((*list)->grouping()->generation(), 1U);
}

std::vector<std::string> allSpecs() {
  std::vector<std::string> specs;
  for (const PolicyInfo& info : knownPolicies()) {
    if (info.name != "finest" && info.name != "coarsest") specs.emplace_back(info.name);
  }
  specs.emplace_back("speed:coarse=8");
  specs.emplace_back("group-range:level=2,members=3");
  specs.emplace_back("group-share:members=3,share=0.2");
  return specs;
}

/// Worlds that change from step to step, bodies and pairs coming and going, some of it no number.
PolicyWorld worldAt(std::uint64_t step) {
  PolicyWorld world = randomWorld(step / 5, static_cast<std::uint32_t>(20 + 7 * (step % 3)), 60);
  if (step % 10 == 9) world.bodies[3].velocity.x = std::numeric_limits<float>::quiet_NaN();
  if (step % 10 == 8) world.bodies[2].center.y = std::numeric_limits<float>::infinity();
  if (step % 2 == 0) world.focus = Focus{Vec3(20.0F), Vec3(static_cast<float>(step), 0.0F, 0.0F), 1.0F};
  world.load = {static_cast<double>(step % 17), step % 50 == 0 ? 0.0 : 9.0};
  world.step = step;
  return world;
}

TEST(PolicyList, KeepsItsLawsWithAllPoliciesOnWhateverHappens) {
  auto list = makePolicyList(allSpecs());
  ASSERT_TRUE(list) << list.error().message;
  for (std::uint64_t step = 0; step < 300; ++step) {
    const PolicyWorld world = worldAt(step);
    const Situation situation = world.situation();
    (*list)->observe(situation);
    for (const PairView& pair : world.pairs) {
      const Wish wish = (*list)->advise(situation, pair);
      ASSERT_GE(wish.importance, PolicyList::kLeastImportance);
      ASSERT_LE(wish.importance, PolicyList::kMostImportance);
      ASSERT_GE(wish.atLeast, 1);
      ASSERT_LE(wish.atLeast, pair.finest);
      ASSERT_GE(wish.atMost, wish.atLeast);
      ASSERT_LT(wish.askedBy, (*list)->size());
      const bool isHeld = world.bodies[pair.a].held || world.bodies[pair.b].held;
      ASSERT_EQ(wish.atLeast, isHeld ? pair.finest : 1);
    }
  }
}

TEST(PolicyList, SaysTheSameEveryTime) {
  auto one = makePolicyList(allSpecs());
  auto other = makePolicyList(allSpecs());
  ASSERT_TRUE(one && other);
  for (std::uint64_t step = 0; step < 200; ++step) {
    const PolicyWorld world = worldAt(step);
    const PolicyWorld same = worldAt(step);
    (*one)->observe(world.situation());
    (*other)->observe(same.situation());
    for (std::size_t i = 0; i < world.pairs.size(); ++i) {
      const Wish a = (*one)->advise(world.situation(), world.pairs[i]);
      const Wish b = (*other)->advise(same.situation(), same.pairs[i]);
      ASSERT_EQ(a.importance, b.importance);
      ASSERT_EQ(a.atMost, b.atMost);
      ASSERT_EQ(a.atLeast, b.atLeast);
      ASSERT_EQ(a.askedBy, b.askedBy);
    }
  }
}

}  // namespace
}  // namespace scatter::lod
