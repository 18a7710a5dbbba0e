#include <gmock/gmock.h>

#include <fstream>

#include "apps/program.h"
#include "trials.h"

namespace scatter::test {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

class BenchTest : public ProgramTest {
 protected:
  /// The output of `bench` with these arguments, which must succeed.
  [[nodiscard]] std::string bench(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "bench");
    const Outcome outcome = scatter(std::move(arguments));
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    return outcome.output;
  }

  [[nodiscard]] std::size_t linesOfCsv(const std::string& name) const {
    return linesOf(readText(folder / name)).size();
  }
};

TEST_F(BenchTest, ListShowsWhatCanBeMeasured) {
  const std::string output = bench({"--list"});
  for (const char* name :
       {"budget", "collision", "contacts", "spread", "worlds", "fidelity", "memory", "levels"}) {
    EXPECT_THAT(output, HasSubstr(name));
  }
}

TEST_F(BenchTest, EveryBenchCommandHasHelp) {
  for (const char* name :
       {"budget", "collision", "contacts", "spread", "worlds", "fidelity", "memory", "levels"}) {
    EXPECT_THAT(bench({name, "--help"}), HasSubstr(std::string("scatter bench ") + name));
  }
}

TEST_F(BenchTest, CollisionShowsEveryStep) {
  const std::string output =
      bench({"collision", "--scene", "duel", "--frames", "20", "--repeat", "2", "--csv", "new/steps.csv"});
  for (const char* step : {"plain engine", "part boxes in", "warm simplex", "recycled", "level 1"}) {
    EXPECT_THAT(output, HasSubstr(step));
  }
  EXPECT_THAT(output, HasSubstr("new/steps.csv"));
  EXPECT_EQ(linesOfCsv("new/steps.csv"), 12U);
  EXPECT_EQ(columnOf(folder / "new/steps.csv", "total_ratio").front(), "1");
}

TEST_F(BenchTest, ContactsVerifiesEveryScene) {
  const std::string output = bench({"contacts", "--scenes", "duel,quiet_apart", "--frames", "20",
                                    "--verify-every", "10", "--csv", "contacts.csv"});
  // 20 frames, of which two are verified.
  EXPECT_THAT(output, ContainsRegex("duel +20 +2 "));
  EXPECT_THAT(output, ContainsRegex("all +40 +4 "));
  EXPECT_EQ(linesOfCsv("contacts.csv"), 3U);
}

TEST_F(BenchTest, BudgetGoesThroughScenesAndFamilies) {
  const std::string output =
      bench({"budget", "--scenes", "convergence", "--families", "wheel_stack", "--seeds", "2,3", "--scale",
             "0.2", "--frames", "30", "--floors", "1.5,40", "--csv", "budgets.csv"});
  EXPECT_THAT(output, ContainsRegex("convergence +1.50 "));
  EXPECT_THAT(output, ContainsRegex("wheel_stack-3 +40.0 .* 0.00 +0.00 +0.[0-9]+"));
  EXPECT_THAT(output, HasSubstr("6 runs, 180 frames"));
  EXPECT_EQ(linesOfCsv("budgets.csv"), 7U);
}

TEST_F(BenchTest, BudgetGoesThroughSeedsOfAScene) {
  const std::string output = bench({"budget", "--scenes", "fleet_boxes", "--scene-seeds", "2,3", "--frames",
                                    "8", "--floors", "1.5", "--csv", "budgets.csv"});
  EXPECT_THAT(output, HasSubstr("2 runs, 16 frames"));
  EXPECT_EQ(columnOf(folder / "budgets.csv", "scene"),
            (std::vector<std::string>{"fleet_boxes-2", "fleet_boxes-3"}));
  const auto budgets = columnOf(folder / "budgets.csv", "budget_units");
  EXPECT_NE(budgets.front(), budgets.back()) << "bodies lie elsewhere, and another frame is the dearest";
}

TEST_F(BenchTest, BudgetsOfMillisecondsAreTheSameEveryTimeOnAMachineThatIsGiven) {
  std::ofstream(folder / "machine.csv") << "ms_per_unit\n0.001\n0.002\n0.004\n";
  for (const char* csv : {"one.csv", "other.csv"}) {
    const std::string output =
        bench({"budget", "--families", "wheel_stack", "--seeds", "2", "--scale", "0.2", "--frames", "40",
               "--floors", "1.5", "--machine", "machine.csv", "--csv", csv});
    EXPECT_THAT(output, ContainsRegex("floors +ms "));
  }
  EXPECT_EQ(readText(folder / "one.csv"), readText(folder / "other.csv"));
  EXPECT_EQ(columnOf(folder / "one.csv", "frames"), (std::vector<std::string>{"40"}));
}

TEST_F(BenchTest, LevelsAreJudgedBesideThoseOfAProgram) {
  std::string box = "o box\n";
  for (const char* vertex :
       {"-1 -1 -1", "1 -1 -1", "-1 1 -1", "1 1 -1", "-1 -1 1", "1 -1 1", "-1 1 1", "1 1 1"})
    box += std::string("v ") + vertex + "\n";
  for (const char* face : {"1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"})
    box += std::string("f ") + face + "\n";
  std::ofstream(folder / "box.obj") << box;
  const std::string output = bench({"levels", "box.obj", "--csv", "new/levels.csv", "--piles", "piles.csv",
                                    "--repeat", "1", "--program", "whole=(echo o all; cat {mesh}) > {hulls}",
                                    "--program", "none@8x12=echo {mesh} {parts} {vertices} > {hulls}"});
  EXPECT_THAT(output, ContainsRegex("box +12 scatter .* passes yes"));
  EXPECT_THAT(output, ContainsRegex("box +12 whole .* passes yes"));
  EXPECT_THAT(output, ContainsRegex("box +12 none +8 parts: .*left no hulls.*echo mesh.obj 8 12"));
  for (const char* pile : {"scatter-32", "scatter-64", "whole"})
    EXPECT_THAT(output, ContainsRegex(std::string("pile of 30, ") + pile + " +plain Bullet"));
  // A box is one level of one part, however many are asked for.
  EXPECT_EQ(linesOfCsv("new/levels.csv"), 6U);
  EXPECT_EQ(linesOfCsv("piles.csv"), 4U);
  const auto bytes = columnOf(folder / "piles.csv", "bytes");
  EXPECT_EQ(bytes.back(), bytes.front()) << "the program's eight corners are a box, as ours are";
  EXPECT_EQ(columnOf(folder / "new/levels.csv", "passes").back(), "failed");
}

TEST_F(BenchTest, SpreadHasALineForEveryWorldAndSeed) {
  const std::string output =
      bench({"spread", "--scene", "convergence", "--frames", "5", "--seeds", "2", "--csv", "spread.csv"});
  EXPECT_THAT(output, HasSubstr("over 2 seeds"));
  EXPECT_THAT(output, HasSubstr("pile radius"));
  EXPECT_EQ(linesOfCsv("spread.csv"), 5U);
}

TEST_F(BenchTest, SpreadGoesThroughAFamily) {
  const std::string output = bench({"spread", "--family", "wheel_stack", "--scale", "0.1", "--frames", "40",
                                    "--seeds", "3", "--worlds", "standard,wide", "--csv", "stacks.csv"});
  EXPECT_THAT(output, ContainsRegex("all asleep from, frame .*\\) +yes, \\+0 -0"));
  const auto heights = columnOf(folder / "stacks.csv", "mean_height");
  ASSERT_EQ(heights.size(), 6U);
  // Every seed is another stack, the same in both worlds.
  EXPECT_NE(heights[0], heights[1]);
  EXPECT_NEAR(std::stod(heights[0]), std::stod(heights[3]), 0.02);
}

TEST_F(BenchTest, SpreadShowsWhatBudgetsCost) {
  const std::string output =
      bench({"spread", "--family", "wheel_stack", "--scale", "0.2", "--frames", "40", "--seeds", "2",
             "--worlds", "standard,finest", "--floors", "1,50", "--fidelity", "4", "--csv", "budgets.csv"});
  EXPECT_THAT(output, HasSubstr("overlaps of 100 pairs, impact"));
  EXPECT_EQ(columnOf(folder / "budgets.csv", "world"),
            (std::vector<std::string>{"standard", "standard", "finest", "finest", "hybrid-1floors",
                                      "hybrid-1floors", "hybrid-50floors", "hybrid-50floors"}));
  const auto finest = columnOf(folder / "budgets.csv", "finest");
  for (const std::size_t all : {0U, 1U, 2U, 3U, 6U, 7U}) EXPECT_EQ(finest[all], "1");
  for (const std::size_t some : {4U, 5U}) EXPECT_LT(std::stod(finest[some]), 1.0);
}

TEST_F(BenchTest, MemoryHasALineForEveryWorld) {
  const std::string output = bench({"memory", "--scene", "duel", "--frames", "20", "--every", "5", "--worlds",
                                    "standard,lean", "--csv", "memory.csv"});
  EXPECT_THAT(output, ContainsRegex("\nlean +[0-9.]+ +[0-9.]+ +[0-9.]+ +[0-9.]+\n"));
  EXPECT_EQ(linesOfCsv("memory.csv"), 3U);
  EXPECT_GT(std::stod(columnOf(folder / "memory.csv", "touched_median_mb")[1]), 0.1);
}

TEST_F(BenchTest, WorldsHasARowForEverySceneAndWorld) {
  const std::string output =
      bench({"worlds", "--scenes", "duel,tower", "--worlds", "standard,finest,hybrid@5ms", "--frames", "12",
             "--repeat", "2", "--fidelity", "4", "--csv", "worlds.csv"});
  EXPECT_THAT(output, HasSubstr("tower, hybrid-5ms"));
  const auto file = folder / "worlds.csv";
  EXPECT_EQ(linesOfCsv("worlds.csv"), 7U);
  EXPECT_THAT(columnOf(file, "scene"),
              testing::ElementsAre("duel", "duel", "duel", "tower", "tower", "tower"));
  EXPECT_EQ(columnOf(file, "world")[2], "hybrid-5ms");
  EXPECT_EQ(columnOf(file, "governed_ms")[2], "5");
  EXPECT_EQ(columnOf(file, "peak_ratio")[0], "1");
  EXPECT_EQ(columnOf(file, "finest_share_mean")[0], "1");
  for (const char* column : {"commit", "compiler", "flags", "cpu", "date", "repeats", "p99_ratio_max"}) {
    EXPECT_THAT(columnOf(file, column), testing::Each(testing::Not(""))) << column;
  }
}

TEST_F(BenchTest, WorldsMeasuresFamiliesOfScenes) {
  const bool oneSeed = kSanitized;
  const std::string output =
      bench({"worlds", "--scenes", "families", "--seeds", oneSeed ? "2" : "1,2", "--scale", "0.01",
             "--frames", "3", "--repeat", "1", "--csv", "families.csv"});
  EXPECT_THAT(output, HasSubstr(oneSeed ? "ships_mesh-2, standard" : "ships_mesh-1, standard"));
  EXPECT_THAT(output, HasSubstr("quiet-2, finest"));
  EXPECT_THAT(output, HasSubstr("per awake"));
  for (const std::string& line : linesOf(output)) {
    EXPECT_LE(line.size(), 80U) << line;
  }
  const auto file = folder / "families.csv";
  EXPECT_GE(columnOf(file, "scene").size(), (oneSeed ? 1U : 2U) * 2U * 12U);
  for (const char* column :
       {"total_ratio", "p99_ratio", "peak_ratio", "collision_detection_ratio", "awake_body_step_ratio"}) {
    EXPECT_THAT(columnOf(file, column), testing::Each(testing::Not(""))) << column;
  }
}

TEST_F(BenchTest, FidelityDrawsItAgainstTheBudget) {
  const std::string output = bench(
      {"fidelity", "convergence", "--frames", "12", "--budgets", "0.5,2", "--fidelity", "4", "--out", "f"});
  EXPECT_THAT(output, HasSubstr("f/fidelity_budget.svg"));
  EXPECT_EQ(linesOfCsv("f/fidelity.csv"), 4U);
  EXPECT_THAT(columnOf(folder / "f/fidelity.csv", "governed_ms"), testing::ElementsAre("0", "0.5", "2"));
  EXPECT_THAT(readText(folder / "f/fidelity_budget.svg"), HasSubstr("fidelity against budget"));
  EXPECT_GT(readText(folder / "f/fidelity_budget.png").size(), 1000U);
}

}  // namespace
}  // namespace scatter::test
