#include <gmock/gmock.h>

#include <fstream>

#include "apps/program.h"

namespace scatter::test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

TEST_F(ProgramTest, CompareWritesDataFiguresAndReport) {
  const Outcome outcome = scatter({"compare", "duel", "--frames", "40"});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, testing::ContainsRegex("standard +hybrid\n"));
  EXPECT_THAT(outcome.output, HasSubstr("out/duel/report.html"));
  for (const char* file : {"standard/frames.csv", "standard/summary.json", "hybrid/frames.csv",
                           "hybrid/summary.json", "comparison.json", "report.html"}) {
    EXPECT_FALSE(readText(folder / "out/duel" / file).empty()) << file;
  }
  std::size_t svg = 0;
  std::size_t png = 0;
  for (const auto& figure : fs::directory_iterator(folder / "out/duel/figures")) {
    svg += figure.path().extension() == ".svg" ? 1 : 0;
    png += figure.path().extension() == ".png" ? 1 : 0;
    EXPECT_GT(figure.file_size(), 1000U) << figure.path();
  }
  EXPECT_GE(svg, 6U);
  EXPECT_EQ(svg, png);
}

TEST_F(ProgramTest, CompareTakesAnyWorldsAndRepeats) {
  const Outcome outcome = scatter({"compare", "duel", "--frames", "10", "--worlds", "finest,coarsest-body",
                                   "--repeat", "2", "--out", "x"});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, testing::ContainsRegex("finest +coarsest-body\n"));
  EXPECT_EQ(columnOf(folder / "x/coarsest-body/frames.csv", "frame").size(), 10U);
  EXPECT_NE(columnOf(folder / "x/coarsest-body/frames.csv", "state_hash"),
            columnOf(folder / "x/finest/frames.csv", "state_hash"));
}

TEST_F(ProgramTest, WorldsThatDoTheSameHaveTheSameStates) {
  ASSERT_EQ(scatter({"compare", "tower", "--frames", "30", "--out", "x"}).status, 0);
  EXPECT_EQ(columnOf(folder / "x/standard/frames.csv", "state_hash"),
            columnOf(folder / "x/hybrid/frames.csv", "state_hash"));
}

TEST_F(ProgramTest, HandsDoTheSameInRunAndInEveryWorldOfCompare) {
  std::ofstream(folder / "hands.txt") << "3 gather 0 2 0\n";
  const auto hashes = [this](const char* file) { return columnOf(folder / file, "state_hash"); };
  ASSERT_EQ(scatter({"run", "duel", "--world", "standard", "--frames", "20", "--out", "left"}).status, 0);
  ASSERT_EQ(scatter({"run", "duel", "--world", "standard", "--frames", "20", "--script", "hands.txt", "--out",
                     "moved"})
                .status,
            0);
  const Outcome outcome =
      scatter({"compare", "duel", "--frames", "20", "--script", "hands.txt", "--no-3d", "--out", "x"});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_EQ(hashes("x/standard/frames.csv"), hashes("moved/frames.csv"));
  EXPECT_NE(hashes("x/standard/frames.csv"), hashes("left/frames.csv"));
  EXPECT_THAT(scatter({"compare", "duel", "--script", "none.txt"}).errors, HasSubstr("none.txt"));
}

TEST_F(ProgramTest, CompareTakesWorldsWithBudgets) {
  const Outcome outcome =
      scatter({"compare", "duel", "--frames", "20", "--worlds", "standard,hybrid@5ms,hybrid@300units",
               "--repeat", "2", "--fidelity", "5", "--out", "x"});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, testing::ContainsRegex("standard +hybrid-5ms +hybrid-300units\n"));
  EXPECT_THAT(outcome.output, HasSubstr("frames over 5.00 ms"));
  EXPECT_THAT(outcome.output,
              testing::ContainsRegex("Governed by the clock, so that\\seach run differs:\\shybrid-5ms\\."));
  EXPECT_THAT(outcome.output, HasSubstr("touching finely %, worst"));
  EXPECT_FALSE(readText(folder / "x/hybrid-5ms/events.csv").empty());
  EXPECT_THAT(readText(folder / "x/figures/overview.svg"), HasSubstr("its budget 5.00 ms"));
}

TEST_F(ProgramTest, AnInterruptedCompareIsResumed) {
  const std::vector<std::string> arguments{"compare",         "tower",    "--worlds",
                                           "standard,finest", "--frames", "1500"};
  const auto with = [&](const char* option) {
    std::vector<std::string> more = arguments;
    more.emplace_back(option);
    return more;
  };
  const fs::path out = folder / "out/tower";
  const Outcome cut =
      runProgram({.arguments = arguments, .folder = folder, .interruptOnce = out / "finest/frames.csv"});
  EXPECT_EQ(cut.status, 130) << cut.errors;
  EXPECT_THAT(cut.errors, testing::AllOf(HasSubstr("run 2 of 2"), HasSubstr("go on with --resume")));
  EXPECT_THAT(readText(out / "comparison.json"), HasSubstr("\"complete\": false"));
  const std::string first = readText(out / "standard/frames.csv");
  EXPECT_EQ(linesOf(first).size(), 1501U);

  const Outcome refused = scatter(arguments);
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.errors, testing::AllOf(HasSubstr("1 finished runs"), HasSubstr("--anew")));

  const Outcome resumed = scatter(with("--resume"));
  EXPECT_EQ(resumed.status, 0) << resumed.errors;
  EXPECT_EQ(readText(out / "standard/frames.csv"), first);
  EXPECT_EQ(linesOf(readText(out / "finest/frames.csv")).size(), 1501U);
  EXPECT_THAT(readText(out / "comparison.json"), HasSubstr("\"complete\": true"));
  EXPECT_TRUE(fs::exists(out / "report.html"));
}

TEST_F(ProgramTest, TheTableFitsATerminal) {
  const Outcome outcome = scatter({"compare", "duel", "--frames", "30", "--repeat", "2", "--worlds",
                                   "standard,finest,coarsest,hybrid@8ms,hybrid@4ms,hybrid@2500units"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  for (const std::string& line : linesOf(outcome.output)) {
    EXPECT_LE(line.size(), 80U) << line;
  }
}

TEST_F(ProgramTest, TheReportSaysHowItWasMade) {
  ASSERT_EQ(scatter({"compare", "tower", "--frames", "5", "--seed", "7", "--out", "x"}).status, 0);
  EXPECT_THAT(readText(folder / "x/report.html"),
              HasSubstr("scatter compare tower --frames 5 --seed 7 --out x"));
}

}  // namespace
}  // namespace scatter::test
