#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "lod/fake_engine.h"
#include "lod/governor_pairs.h"
#include "trials.h"

/// The governor at work over whole runs, against an engine whose costs it can only learn.
namespace scatter::lod {
namespace {

using testing::FakeDef;
using testing::FakeEngine;
using testing::FakePair;
using testing::FakeStep;
using testing::kNoBudget;
using testing::makeClump;
using testing::makePile;

constexpr int kSteps = 500;
constexpr int kPairs = 2500;
constexpr int kMany = 50;  ///< So many touching pairs have a share that means something.

struct Outcome {
  double peak = 0.0;
  int over = 0;              ///< Steps over 1.02 of the budget.
  double leastFinest = 1.0;  ///< Share of the touching pairs, in the worst step with many of them.
  double meanFinest = 0.0;
  int lateSwitches = 0;  ///< In the last fifth.
};

Outcome runPile(const FakeDef& def, const std::vector<FakePair>& script, double budget) {
  FakeEngine engine(def, script);
  Outcome run;
  int counted = 0;
  for (int i = 0; i < kSteps; ++i) {
    const FakeStep step = engine.step(budget);
    run.peak = std::max(run.peak, step.units);
    run.over += step.units > 1.02 * budget ? 1 : 0;
    if (i >= kSteps * 4 / 5) run.lateSwitches += step.coarser + step.finer;
    if (step.touching < kMany) continue;
    const double finest = static_cast<double>(step.touchingFinest) / step.touching;
    run.leastFinest = std::min(run.leastFinest, finest);
    run.meanFinest += finest;
    ++counted;
  }
  run.meanFinest /= std::max(counted, 1);
  return run;
}

std::vector<FakePair> allCoarse(std::vector<FakePair> script) {
  for (FakePair& pair : script) pair.atMost = 1;
  return script;
}

struct Weather {
  const char* name;
  double noise;
  double spike;
  double blocked;
  int growth;
  int mostOver;  ///< Steps of kSteps: nothing is known of the pile but how it grows.
};

class GovernorRun : public ::testing::TestWithParam<Weather> {
 protected:
  [[nodiscard]] static FakeDef def() {
    FakeDef result;
    result.noise = GetParam().noise;
    result.spike = GetParam().spike;
    result.blocked = GetParam().blocked;
    return result;
  }
};

TEST_P(GovernorRun, HoldsEveryBudgetThatCanBeHeld) {
  const auto script = makePile(kPairs, GetParam().growth, 3);
  const double least = runPile(def(), allCoarse(script), kNoBudget).peak;
  for (const double factor : test::trials<double>({1.3, 1.6, 2.0, 3.0, 4.0})) {
    const double budget = factor * least;
    const Outcome run = runPile(def(), script, budget);
    EXPECT_LE(run.over, GetParam().mostOver) << "at " << factor << " times what the coarsest levels cost";
    EXPECT_LE(run.peak, 1.15 * budget) << "at " << factor << " times what the coarsest levels cost";
  }
}

TEST_P(GovernorRun, SpendsTheBudgetOnContacts) {
  const auto script = makePile(kPairs, GetParam().growth, 3);
  const double most = runPile(def(), script, kNoBudget).peak;
  const Outcome nearly = runPile(def(), script, 0.95 * most);
  EXPECT_GE(nearly.leastFinest, 0.6);
  EXPECT_GE(nearly.meanFinest, 0.85);
  const Outcome half = runPile(def(), script, 0.5 * most);
  EXPECT_GE(half.leastFinest, 0.25);
  EXPECT_GE(half.meanFinest, 0.4);
  EXPECT_EQ(runPile(def(), script, 1.5 * most).leastFinest, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Weather, GovernorRun,
                         ::testing::Values(Weather{"calm", 0.0, 0.0, 0.0, 300, 5},
                                           Weather{"noisy", 0.3, 0.05, 0.2, 300, 5},
                                           Weather{"fast", 0.2, 0.05, 0.2, 120, 10},
                                           Weather{"reluctant", 0.2, 0.05, 0.6, 300, 5}),
                         [](const auto& instance) { return instance.param.name; });

TEST(GovernorLongRun, DoesNotFlapUnderAConstantLoad) {
  for (const double noise : {0.0, 0.2}) {
    FakeDef def;
    def.noise = noise;
    def.spike = noise / 4.0;
    const auto script = makeClump(1500, 5);
    const double most = runPile(def, script, kNoBudget).peak;
    for (const double share : test::trials<double>({0.5, 0.7, 0.9, 1.0, 1.1})) {
      EXPECT_LE(runPile(def, script, share * most).lateSwitches, noise > 0.0 ? 30 : 3) << share;
    }
  }
}

TEST(GovernorLongRun, GivesAllDetailBackWhenTheLoadIsGone) {
  auto script = makeClump(2000, 6);
  for (std::size_t i = 0; i < script.size(); ++i) script[i].gone = i % 4 == 0 ? 1 << 30 : 200;
  FakeEngine engine({}, script);
  FakeStep step;
  for (int i = 0; i < 200; ++i) step = engine.step(7000.0);
  EXPECT_LT(step.touchingFinest, 0.9 * step.touching);
  for (int i = 0; i < 120; ++i) {
    step = engine.step(7000.0);
    ASSERT_LE(step.units, 7000.0);
  }
  EXPECT_EQ(step.touchingFinest, step.touching);
}

// Where everything becomes twice as dear in one step, which no work that is counted does, relief gains
// nothing: it asks what pairs on credit cost against what they did cost before.
TEST(GovernorLongRun, ASuddenLoadIsShedInAFewSteps) {
  FakeDef def;
  const auto script = makeClump(1000, 6);
  def.activity = [](int step) { return step < 200 ? 1.0 : 1.9; };
  FakeEngine engine(def, script);
  double budget = kNoBudget;
  int over = 0;
  int reused = 0;
  for (int i = 0; i < 300; ++i) {
    const FakeStep step = engine.step(budget);
    reused += step.reused;
    if (i < 200) {
      ASSERT_EQ(reused, 0);
    }
    // When the hits are over.
    if (i == 199) budget = 1.2 * step.units;
    over += step.units > budget ? 1 : 0;
  }
  EXPECT_GE(over, 1) << "it was no load";
  EXPECT_LE(over, 6);
  EXPECT_GT(reused, 0);
}

TEST(GovernorLongRun, PromisesHoldInEveryStep) {
  auto script = makePile(kPairs, 200, 3);
  for (std::size_t i = 0; i < script.size(); i += 10)
    script[i].atLeast = static_cast<std::uint8_t>(2 + i % 2);
  FakeEngine engine({}, script);
  for (int i = 0; i < 300; ++i) {
    engine.step(2000.0);
    for (std::size_t pair = 0; pair < engine.pairs().size(); ++pair) {
      ASSERT_GE(engine.pairs()[pair].view.level, engine.scriptOf(pair).atLeast);
    }
  }
}

/// Shares of the touching pairs that are finest, over a run: of the unimportant and of the important ones.
std::array<double, 2> finestByImportance(double budget) {
  auto script = makePile(kPairs, 200, 3);
  for (std::size_t i = 0; i < script.size(); ++i) script[i].importance = i % 2 == 0 ? 4.0F : 0.25F;
  FakeEngine engine({}, script);
  std::array<double, 2> touching{};
  std::array<double, 2> finest{};
  for (int i = 0; i < 400; ++i) {
    engine.step(budget);
    for (std::size_t pair = 0; pair < engine.pairs().size(); ++pair) {
      const PairView& view = engine.pairs()[pair].view;
      const std::size_t kind = engine.scriptOf(pair).importance > 1.0F ? 1 : 0;
      touching[kind] += view.touching ? 1.0 : 0.0;
      finest[kind] += view.touching && view.level == view.finest ? 1.0 : 0.0;
    }
  }
  return {finest[0] / touching[0], finest[1] / touching[1]};
}

TEST(GovernorLongRun, ImportantPairsAreFiner) {
  for (const double budget : {2400.0, 4000.0}) {
    const auto [unimportant, important] = finestByImportance(budget);
    EXPECT_GT(important, 1.4 * unimportant) << budget;
  }
}

TEST(GovernorLongRun, IsTheSameRunAfterRun) {
  const auto script = makePile(kPairs, 150, 3);
  FakeEngine a({}, script);
  FakeEngine b({}, script);
  for (int i = 0; i < 250; ++i) {
    ASSERT_EQ(a.step(2400.0).units, b.step(2400.0).units);
    for (std::size_t pair = 0; pair < a.pairs().size(); ++pair) {
      ASSERT_EQ(a.pairs()[pair].target, b.pairs()[pair].target);
    }
  }
}

}  // namespace
}  // namespace scatter::lod
