#include <scatter/lab/budget_study.h>

#include "lab/fake_physics.h"
#include "lab/repeats.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace scatter {
namespace {

using testing::HasSubstr;

using Costs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// A world whose steps cost what is given, whatever its budget; `seen` is told the budgets.
RunOptions costing(const Costs& costs, int frames, std::vector<BudgetDef>* seen = nullptr) {
  RunOptions options = test::fakeRun(WorldKind::kHybrid, frames);
  options.engine = [costs, seen](const PhysicsDef& def) -> Result<std::unique_ptr<Physics>> {
    if (seen != nullptr) {
      seen->push_back(def.switching.budget);
    }
    return std::make_unique<test::FakePhysics>(def, test::FakeBehaviour{.costs = costs});
  };
  return options;
}

TEST(BudgetStudy, GivesMultiplesOfTheDearestFrameThatIsCoarse) {
  std::vector<BudgetDef> budgets;
  const auto study = studyBudgets({.scenes = {{.name = "a",
                                               .governed = costing({{90, 0}}, 5, &budgets),
                                               .coarsest = costing({{10, 0}, {50, 0}, {20, 0}}, 5)}},
                                   .floors = {1.5, 3.0}});
  ASSERT_TRUE(study);
  ASSERT_EQ(budgets.size(), 3U);
  EXPECT_EQ(budgets[0].units, 0.0) << "what it takes without one";
  EXPECT_EQ(budgets[1].units, 75.0);
  EXPECT_EQ(budgets[2].units, 150.0);
  ASSERT_EQ(study->trials.size(), 2U);
  EXPECT_EQ(study->trials[0].over5, 5);
  EXPECT_EQ(study->trials[1].over2, 0);
  EXPECT_DOUBLE_EQ(study->trials[1].worst, 0.6);
}

TEST(BudgetStudy, CountsFramesThatTookMoreAndThoseThatHadTo) {
  const Costs costs{{103, 0}, {104, 102}, {120, 130}, {80, 0}, {90, 0}, {96, 0}, {150, 0}};
  const auto study = studyBudgets(
      {.scenes = {{.name = "a", .governed = costing(costs, 7), .coarsest = costing({{100, 0}}, 7)}},
       .floors = {1.0}});
  ASSERT_TRUE(study);
  const BudgetTrial& trial = study->trials.front();
  EXPECT_EQ(trial.frames, 7);
  EXPECT_EQ(trial.over2, 4);
  EXPECT_EQ(trial.over5, 2);
  EXPECT_EQ(trial.impossible, 2);
  EXPECT_DOUBLE_EQ(trial.worst, 1.5);
  const std::string table = formatBudgets(*study);
  EXPECT_THAT(table, HasSubstr("1 runs, 7 frames: 57.14 % took more than 1.02"));
  EXPECT_THAT(budgetsCsv(*study), HasSubstr("a,1,100,7,4,2,1.5,4,1.04,1,2"));
  std::vector<int> frames;
  for (const BudgetOverrun& overrun : trial.overruns) frames.push_back(overrun.frame);
  EXPECT_EQ(frames, (std::vector<int>{0, 1, 2, 6}));
  EXPECT_THAT(budgetOverrunsCsv(*study), HasSubstr("\na,1,1,1.04,104,0,102,103,"));
}

TEST(BudgetStudy, TellsHowMuchIsUsedOfTheBudgetWhereThereIsNotEnough) {
  RunOptions governed = costing({{90, 0}}, 5);
  governed.engine = [](const PhysicsDef& def) -> Result<std::unique_ptr<Physics>> {
    // In the last step nothing is kept back: what it would have taken sleeps.
    const Costs limited{{30, 0}, {80, 0}, {90, 0}, {99, 0}, {100, 0}};
    const Costs unlimited{{30, 0}, {101, 0}, {500, 0}, {200, 0}, {200, 0}};
    const bool isLimited = def.switching.budget.units > 0.0;
    return std::make_unique<test::FakePhysics>(def,
                                               test::FakeBehaviour{.costs = isLimited ? limited : unlimited});
  };
  const auto study = studyBudgets(
      {.scenes = {{.name = "a", .governed = governed, .coarsest = costing({{100, 0}}, 5)}}, .floors = {1.0}});
  ASSERT_TRUE(study);
  EXPECT_EQ(study->trials.front().overloaded, 3);
  EXPECT_DOUBLE_EQ(study->trials.front().use, 0.9);
}

// What the machine adds to one of three is not in their medians.
TEST(BudgetStudy, ByTheClockTheFloorIsFoundInThreeRuns) {
  for (const bool byClock : {true, false}) {
    std::vector<BudgetDef> coarsest;
    int runs = 0;
    int last = 0;
    const auto study = studyBudgets({.scenes = {{.name = "a",
                                                 .governed = costing({{90, 0}}, 5),
                                                 .coarsest = costing({{100, 0}}, 5, &coarsest)}},
                                     .floors = {1.5},
                                     .byClock = byClock},
                                    [&](const CompareProgress& progress) {
                                      runs = progress.runs;
                                      last = progress.run;
                                    });
    ASSERT_TRUE(study);
    EXPECT_EQ(coarsest.size(), byClock ? 3U : 1U);
    EXPECT_EQ(runs, byClock ? 5 : 3);
    EXPECT_EQ(last, runs - 1) << "as many as were announced";
  }
}

TEST(FramewiseMedian, LeavesOutWhatOneRunHasOfItsOwn) {
  EXPECT_EQ(lab::framewiseMedian({{1.0, 9.0, 3.0}, {7.0, 2.0, 3.0}, {1.5, 2.5, 0.1}}),
            (std::vector<double>{1.5, 2.5, 3.0}));
  EXPECT_EQ(lab::framewiseMedian({{1.0, 9.0}, {3.0}}), (std::vector<double>{2.0})) << "the shortest";
  EXPECT_TRUE(lab::framewiseMedian({}).empty());
}

TEST(BudgetStudy, AMachineStandsInForTheClockInFramesThatCostSomething) {
  std::vector<BudgetDef> budgets;
  const Costs costs{{80, 0}, {0, 0}, {60, 0}, {90, 0}};
  const auto study = studyBudgets({.scenes = {{.name = "a",
                                               .governed = costing(costs, 4, &budgets),
                                               .coarsest = costing({{10, 0}, {50, 0}}, 2)}},
                                   .floors = {2.0},
                                   .byClock = true,
                                   .machine = {0.5, 1.0}});
  ASSERT_TRUE(study);
  EXPECT_TRUE(budgets[0].machine.empty()) << "what it takes without a budget needs no time";
  EXPECT_EQ(budgets[1].milliseconds, 100.0) << "twice the 50 units, at a millisecond each when it is slow";
  EXPECT_EQ(budgets[1].machine, (std::vector<double>{0.5, 1.0}));
  // 40 ms, nothing, 60 ms, 45 ms.
  EXPECT_DOUBLE_EQ(study->trials.front().worst, 0.6);
}

TEST(BudgetStudy, ABudgetThatIsCutIsJudgedOnceThereWasTimeForIt) {
  std::vector<BudgetDef> budgets;
  Costs costs(60 + kBudgetWayDown, {180, 0});
  costs.push_back({99, 0});
  const auto study = studyBudgets({.scenes = {{.name = "a",
                                               .governed = costing(costs, 120, &budgets),
                                               .coarsest = costing({{100, 0}}, 120)}},
                                   .floors = {2.0},
                                   .cut = 2.0});
  ASSERT_TRUE(study);
  ASSERT_EQ(budgets.back().recorded.size(), 61U);
  EXPECT_EQ(budgets.back().recorded.front().given, 200.0);
  EXPECT_EQ(budgets.back().recorded.back().given, 100.0);
  EXPECT_EQ(study->trials.front().over2, 0);
  EXPECT_DOUBLE_EQ(study->trials.front().worst, 0.99);
}

TEST(BudgetStudy, TellsWhenDetailIsBackAfterACut) {
  std::vector<BudgetDef> budgets;
  RunOptions governed = costing({{90, 0}}, 120);
  // Of the run whose budget is cut, half of the touching pairs are coarse for seven frames longer.
  governed.engine = [&budgets](const PhysicsDef& def) -> Result<std::unique_ptr<Physics>> {
    budgets.push_back(def.switching.budget);
    const std::uint64_t until = def.switching.budget.recorded.empty() ? 0 : 97;
    return std::make_unique<test::FakePhysics>(
        def, test::FakeBehaviour{.costs = {{90, 0}}, .countsTouching = true, .coarseUntil = until});
  };
  BudgetStudyOptions options{
      .scenes = {{.name = "a", .governed = governed, .coarsest = costing({{100, 0}}, 120)}},
      .floors = {2.0},
      .cut = 2.0,
      .cutFrames = 30};
  const auto study = studyBudgets(options);
  ASSERT_TRUE(study);
  ASSERT_EQ(budgets.size(), 3U);
  EXPECT_EQ(budgets[1].recorded, [] {
    std::vector<BudgetUnits> units(91, {.given = 200.0});
    std::fill_n(units.begin() + 60, 30, BudgetUnits{.given = 100.0});
    return units;
  }());
  EXPECT_EQ(budgets[2].units, 200.0);
  // One of ten frames in which half are missing is as much as may be.
  EXPECT_EQ(study->trials.front().back, 6);
  EXPECT_THAT(formatBudgets(*study), HasSubstr("back"));
  EXPECT_THAT(budgetsCsv(*study), HasSubstr("impossible,back\n"));
  options.cutFrames = 60;
  EXPECT_FALSE(studyBudgets(options)->trials.front().back) << "no frame comes after the cut";
}

TEST(BudgetStudy, RefusesWhatTellsNothing) {
  EXPECT_FALSE(studyBudgets({}));
  const BudgetScene empty{
      .name = "empty", .governed = costing({{90, 0}}, 2), .coarsest = costing({{0, 0}}, 2)};
  const auto free = studyBudgets({.scenes = {empty}, .floors = {2.0}});
  ASSERT_FALSE(free);
  EXPECT_THAT(free.error().message,
              HasSubstr("nothing to govern, as the coarsest world costs nothing, in empty"));
}

TEST(BudgetStudy, RefusesSeedsOfASceneInWhichNothingIsDrawn) {
  const auto seeded = [](const char* name, const char* drawn) {
    return BudgetScene{
        .name = name, .governed = costing({{90, 0}}, 5), .coarsest = costing({{50, 0}}, 5), .drawn = drawn};
  };
  const auto refused = studyBudgets({.scenes = {seeded("a-1", "a"), seeded("a-2", "a")}, .floors = {2.0}});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message,
            "a-2 is the same run as a-1: its seed changes nothing in a; give it one seed");
  EXPECT_TRUE(studyBudgets({.scenes = {seeded("a-1", "a"), seeded("b-1", "b")}, .floors = {2.0}}));
  EXPECT_TRUE(studyBudgets({.scenes = {seeded("a", ""), seeded("a", "")}, .floors = {2.0}}));
}

TEST(BudgetStudy, GoesOnWithoutScenesInWhichThereIsNothingToGovern) {
  const BudgetScene empty{
      .name = "empty", .governed = costing({{90, 0}}, 2), .coarsest = costing({{0, 0}}, 2)};
  const BudgetScene full{
      .name = "full", .governed = costing({{90, 0}}, 2), .coarsest = costing({{50, 0}}, 2)};
  const auto study = studyBudgets({.scenes = {empty, full}, .floors = {2.0}});
  ASSERT_TRUE(study);
  ASSERT_EQ(study->trials.size(), 1U);
  EXPECT_EQ(study->trials.front().scene, "full");
  EXPECT_THAT(formatBudgets(*study), HasSubstr("Left out: nothing to govern"));
}

}  // namespace
}  // namespace scatter
