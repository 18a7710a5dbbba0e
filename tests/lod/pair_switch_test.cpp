#include "lod/pair_switch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace scatter::lod {
namespace {

/// Two bodies whose shapes are so far apart at each level, coarsest first; metres, negative if they overlap.
/// Writes down what was asked.
class Shapes {
 public:
  struct Question {
    int level;
    float gap;
    bool operator==(const Question&) const = default;
  };

  explicit Shapes(std::vector<float> distances) : distances_(std::move(distances)) {}

  bool operator()(int level, float gap) {
    questions.push_back({level, gap});
    return at(level) > gap;
  }

  [[nodiscard]] float at(int level) const { return distances_.at(static_cast<std::size_t>(level - 1)); }
  [[nodiscard]] int finest() const { return static_cast<int>(distances_.size()); }

  std::vector<Question> questions{};

 private:
  std::vector<float> distances_;
};

using Questions = std::vector<Shapes::Question>;

PairView pairAt(int level, int finest = 3) {
  PairView pair;
  pair.level = static_cast<std::uint8_t>(level);
  pair.finest = static_cast<std::uint8_t>(finest);
  return pair;
}

void expectChoice(const SwitchChoice& choice, SwitchKind kind, int level) {
  EXPECT_EQ(choice.kind, kind);
  EXPECT_EQ(choice.level, level);
}

SwitchRules withoutCredit() {
  SwitchRules rules;
  rules.credit = false;
  return rules;
}

TEST(ChooseLevel, StaysWithoutAQuestion) {
  Shapes shapes({-1.0F, -1.0F, -1.0F});
  expectChoice(chooseLevel(pairAt(2), 2, {}, shapes), SwitchKind::kStay, 2);
  EXPECT_TRUE(shapes.questions.empty());
}

TEST(ChooseLevel, ANewPairTakesTheLevelItShouldHaveIfApartThere) {
  Shapes shapes({0.1F, 0.2F, 0.3F});
  expectChoice(chooseLevel(pairAt(0), 1, {}, shapes), SwitchKind::kFree, 1);
  EXPECT_EQ(shapes.questions, (Questions{{1, 0.0F}}));
}

TEST(ChooseLevel, ANewPairTakesTheCoarsestFinerLevelAtWhichItIsApart) {
  Shapes shapes({-0.1F, 0.2F, 0.3F});
  expectChoice(chooseLevel(pairAt(0), 1, {}, shapes), SwitchKind::kFree, 2);
  EXPECT_EQ(shapes.questions, (Questions{{1, 0.0F}, {2, 0.0F}}));
}

TEST(ChooseLevel, ANewPairThatOverlapsAtAllLevelsIsFinestAndNotAskedThere) {
  Shapes shapes({-0.3F, -0.2F, -0.1F});
  expectChoice(chooseLevel(pairAt(0), 1, {}, shapes), SwitchKind::kFree, 3);
  EXPECT_EQ(shapes.questions, (Questions{{1, 0.0F}, {2, 0.0F}}));
}

TEST(ChooseLevel, ANewPairThatShouldBeFinestIsFinestAtOnce) {
  Shapes shapes({-0.3F, -0.2F, -0.1F});
  expectChoice(chooseLevel(pairAt(0), 3, {}, shapes), SwitchKind::kFree, 3);
  EXPECT_TRUE(shapes.questions.empty());
}

TEST(ChooseLevel, CoarserIsFreeAtTheCoarsestLevelOnTheWayThatIsApart) {
  Shapes shapes({-0.1F, 0.1F, 0.2F});
  expectChoice(chooseLevel(pairAt(3), 1, {}, shapes), SwitchKind::kFree, 2);
  EXPECT_EQ(shapes.questions, (Questions{{1, 0.0F}, {2, 0.0F}}));
}

TEST(ChooseLevel, CoarserInContactIsOnCreditNoCoarserThanTheCreditLevel) {
  Shapes shapes({-0.2F, -0.1F, 0.0F});
  expectChoice(chooseLevel(pairAt(3), 1, {}, shapes), SwitchKind::kOnCredit, 2);
  expectChoice(chooseLevel(pairAt(3), 2, {}, shapes), SwitchKind::kOnCredit, 2);
  SwitchRules rules;
  rules.creditLevel = 1;
  expectChoice(chooseLevel(pairAt(3), 1, rules, shapes), SwitchKind::kOnCredit, 1);
  expectChoice(chooseLevel(pairAt(2), 1, rules, shapes), SwitchKind::kOnCredit, 1);
}

TEST(ChooseLevel, CoarserInContactIsBlockedWithoutCreditOrBelowTheCreditLevel) {
  Shapes shapes({-0.2F, -0.1F, 0.0F});
  expectChoice(chooseLevel(pairAt(3), 1, withoutCredit(), shapes), SwitchKind::kBlocked, 3);
  expectChoice(chooseLevel(pairAt(2), 1, {}, shapes), SwitchKind::kBlocked, 2);
}

TEST(ChooseLevel, FinerIsFreeAtTheFinestLevelThatIsApart) {
  Shapes apart({-0.1F, -0.1F, 0.2F});
  expectChoice(chooseLevel(pairAt(1), 3, {}, apart), SwitchKind::kFree, 3);
  EXPECT_EQ(apart.questions, (Questions{{3, 0.0F}}));
  // Levels that do not nest quite: part of the way.
  Shapes halfway({-0.1F, 0.1F, -0.2F});
  expectChoice(chooseLevel(pairAt(1), 3, {}, halfway), SwitchKind::kFree, 2);
}

TEST(ChooseLevel, FinerThatNearlyFitsIsOnCredit) {
  Shapes shapes({-0.3F, -0.2F, -0.01F});
  expectChoice(chooseLevel(pairAt(1), 3, {}, shapes), SwitchKind::kOnCredit, 3);
  EXPECT_EQ(shapes.questions.back(), (Shapes::Question{3, -0.02F}));
  expectChoice(chooseLevel(pairAt(1), 3, withoutCredit(), shapes), SwitchKind::kBlocked, 1);
}

TEST(ChooseLevel, FinerThatOverlapsIsBlocked) {
  Shapes shapes({-0.3F, -0.2F, -0.1F});
  expectChoice(chooseLevel(pairAt(1), 3, {}, shapes), SwitchKind::kBlocked, 1);
}

TEST(ChooseLevel, WithoutSafetyEverythingIsFreeAndNothingIsAsked) {
  SwitchRules rules;
  rules.safe = false;
  Shapes shapes({-0.3F, -0.2F, -0.1F});
  expectChoice(chooseLevel(pairAt(3), 1, rules, shapes), SwitchKind::kFree, 1);
  expectChoice(chooseLevel(pairAt(1), 3, rules, shapes), SwitchKind::kFree, 3);
  expectChoice(chooseLevel(pairAt(0), 1, rules, shapes), SwitchKind::kFree, 1);
  EXPECT_TRUE(shapes.questions.empty());
}

/// What must hold of every choice.
void expectSafe(const PairView& pair, int target, const SwitchRules& rules, const Shapes& shapes,
                const SwitchChoice& choice) {
  ASSERT_GE(choice.level, 1);
  ASSERT_LE(choice.level, shapes.finest());
  const bool isNew = pair.level == 0;
  if (!isNew) {
    EXPECT_GE(choice.level, std::min<int>(target, pair.level));
    EXPECT_LE(choice.level, std::max<int>(target, pair.level));
  } else {
    EXPECT_GE(choice.level, target);
  }
  switch (choice.kind) {
    case SwitchKind::kFree:
      EXPECT_TRUE(shapes.at(choice.level) > 0.0F || (isNew && choice.level == shapes.finest()));
      break;
    case SwitchKind::kOnCredit:
      EXPECT_TRUE(rules.credit);
      EXPECT_FALSE(isNew);
      if (choice.level < pair.level) {
        EXPECT_GE(choice.level, rules.creditLevel);
      } else {
        EXPECT_GT(shapes.at(choice.level), -rules.finerOverlap);
      }
      EXPECT_NE(choice.level, pair.level);
      break;
    case SwitchKind::kStay:
    case SwitchKind::kBlocked:
      EXPECT_EQ(choice.level, pair.level);
      break;
  }
}

TEST(ChooseLevel, IsSafeForAllKindsOfPairs) {
  std::mt19937_64 random(5);
  const auto pick = [&random](int count) {
    return static_cast<int>(random() % static_cast<std::uint64_t>(count));
  };
  int kinds[4] = {};
  for (int round = 0; round < 20000; ++round) {
    const int finest = 1 + pick(4);
    std::vector<float> distances;
    for (int i = 0; i < finest; ++i) distances.push_back(0.01F * static_cast<float>(pick(21) - 10));
    Shapes shapes(distances);
    const PairView pair = pairAt(pick(finest + 1), finest);
    SwitchRules rules;
    rules.credit = pick(2) == 0;
    rules.creditLevel = 1 + pick(3);
    const int target = 1 + pick(finest);
    const SwitchChoice choice = chooseLevel(pair, target, rules, shapes);
    expectSafe(pair, target, rules, shapes, choice);
    ++kinds[static_cast<int>(choice.kind)];
    if (HasFailure()) return;
  }
  for (const int count : kinds) EXPECT_GT(count, 500);
}

}  // namespace
}  // namespace scatter::lod
