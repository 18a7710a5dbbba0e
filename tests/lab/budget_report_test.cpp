#include "lab/budget_report.h"

#include <gmock/gmock.h>

#include <string>
#include <utility>
#include <vector>

namespace scatter {
namespace {

using testing::HasSubstr;
using testing::Not;

struct FrameCost {
  double ms;
  double units;
  double floorUnits;  ///< As the physics reports it: 0 where the budget was kept.
  double verdict = 0.0;
  double withheld = 1.0;
  double overdue = 0.0;
};

scatter::Run governedRun(double milliseconds, double units, const std::vector<FrameCost>& frames) {
  std::vector<FrameColumn> columns;
  const auto add = [&](const char* name, double FrameCost::*value) {
    FrameColumn column{.channel = {name, "", ChannelKind::kReal}, .values = {}, .hashes = {}};
    for (const FrameCost& frame : frames) {
      column.values.push_back(frame.*value);
    }
    columns.push_back(std::move(column));
  };
  add("physics_cpu_ms", &FrameCost::ms);
  add("cost_units", &FrameCost::units);
  add("floor_units", &FrameCost::floorUnits);
  add("budget_verdict", &FrameCost::verdict);
  add("withheld_pairs", &FrameCost::withheld);
  add("overdue_pairs", &FrameCost::overdue);
  scatter::Run run;
  run.table = FrameTable(std::move(columns));
  run.options.label = "hybrid";
  run.options.physics.world = WorldKind::kHybrid;
  run.options.physics.switching.budget = {.milliseconds = milliseconds, .units = units};
  return run;
}

TEST(BudgetSentence, SaysThatABudgetWasKept) {
  EXPECT_EQ(lab::budgetSentence(governedRun(4.0, 0.0, {{3.9, 100, 0}, {4.0, 110, 0}}), false),
            "hybrid: the budget of 4.00 ms was kept in all 2 frames.");
}

TEST(BudgetSentence, TakesTheMachineThatWasGivenForTheClock) {
  scatter::Run run = governedRun(4.0, 0.0, {{90.0, 100, 0}, {90.0, 0, 0}, {1.0, 110, 0}});
  run.options.physics.switching.budget.machine = {0.03, 0.05};
  EXPECT_THAT(lab::budgetSentence(run, false), HasSubstr("in 1 of 3 frames; the dearest took 5.50 ms."));
}

TEST(BudgetSentence, SaysByHowMuchItWasMissedAndWhatCouldNotBeGivenUp) {
  // Half of the first frame's 6 ms could have been given up, none of the second's 5 ms.
  const std::string sentence =
      lab::budgetSentence(governedRun(4.0, 0.0, {{6.0, 100, 50}, {5.0, 80, 90}, {1.0, 10, 0}}), true);
  EXPECT_THAT(sentence,
              HasSubstr("hybrid, in the repeat that is kept: the budget of 4.00 ms was exceeded in 2 of 3 "
                        "frames; the dearest took 6.00 ms."));
  EXPECT_THAT(sentence, HasSubstr("about 4.00 ms (3.00 to 5.00 ms): more than the budget in 1 of 2"));
}

TEST(BudgetSentence, CountsUnitsForABudgetOfUnits) {
  const std::string sentence =
      lab::budgetSentence(governedRun(0.0, 100.0, {{9.0, 120, 60}, {9.0, 100, 0}}), false);
  EXPECT_THAT(sentence,
              HasSubstr("the budget of 100 units was exceeded in 1 of 2 frames; the dearest took 120 units"));
  EXPECT_THAT(sentence, HasSubstr("about 60.0 units (60.0 to 60.0 units): less than the budget."));
}

TEST(BudgetSentence, SaysThatNoLevelsWouldHaveKeptIt) {
  const std::string sentence = lab::budgetSentence(
      governedRun(0.0, 100.0, {{9.0, 120, 110, 4.0}, {9.0, 130, 60, 2.0}, {9.0, 90, 0, 1.0}}), false);
  EXPECT_THAT(sentence, HasSubstr("exceeded in 2 of 3 frames"));
  EXPECT_THAT(sentence,
              HasSubstr("In 1 of them it could not have been kept with every pair at its coarsest"));
  EXPECT_THAT(sentence, Not(HasSubstr("was kept coarser for it")));
}

TEST(BudgetSentence, SaysThatPairsWereNotLookedAt) {
  const std::string sentence = lab::budgetSentence(
      governedRun(0.0, 100.0, {{9.0, 90, 0, 1.0, 9.0, 4.0}, {9.0, 95, 0, 1.0, 9.0, 7.0}, {9.0, 95, 0}}),
      false);
  EXPECT_EQ(
      sentence,
      "hybrid: the budget of 100 units was kept in all 3 frames. In 2 frames there was no room to look for "
      "contacts of up to 7 pairs on credit in time: they may overlap.");
}

TEST(BudgetSentence, SaysThatNothingWasGivenUpInVain) {
  const std::string sentence = lab::budgetSentence(
      governedRun(0.0, 100.0, {{9.0, 120, 110, 4.0, 0.0}, {9.0, 130, 120, 4.0, 7.0}}), false);
  EXPECT_THAT(sentence, HasSubstr("In 1 of these no pair was kept coarser for it, which would hardly help."));
}

TEST(BudgetSentence, SaysNothingWithoutABudget) {
  EXPECT_EQ(lab::budgetSentence(governedRun(0.0, 0.0, {{9.0, 120, 0}}), false), "");
  scatter::Run standard = governedRun(4.0, 0.0, {{9.0, 120, 0}});
  standard.options.physics.world = WorldKind::kStandard;
  EXPECT_EQ(lab::budgetSentence(standard, false), "");
}

}  // namespace
}  // namespace scatter
