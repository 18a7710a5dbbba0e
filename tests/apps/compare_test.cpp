#include <gmock/gmock.h>

#include "apps/program.h"

namespace scatter::test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

TEST_F(ProgramTest, CompareWritesDataFiguresAndReport) {
  const Outcome outcome = scatter({"compare", "duel", "--frames", "40"});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("hybrid/standard"));
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
  EXPECT_THAT(outcome.output, HasSubstr("coarsest-body/finest"));
  EXPECT_EQ(columnOf(folder / "x/coarsest-body/frames.csv", "frame").size(), 10U);
  EXPECT_NE(columnOf(folder / "x/coarsest-body/frames.csv", "state_hash"),
            columnOf(folder / "x/finest/frames.csv", "state_hash"));
}

TEST_F(ProgramTest, WorldsThatDoTheSameHaveTheSameStates) {
  ASSERT_EQ(scatter({"compare", "tower", "--frames", "30", "--out", "x"}).status, 0);
  EXPECT_EQ(columnOf(folder / "x/standard/frames.csv", "state_hash"),
            columnOf(folder / "x/hybrid/frames.csv", "state_hash"));
}

TEST_F(ProgramTest, CompareTakesWorldsWithBudgets) {
  const Outcome outcome =
      scatter({"compare", "duel", "--frames", "20", "--worlds", "standard,hybrid@5ms,hybrid@300units",
               "--repeat", "2", "--fidelity", "5", "--out", "x"});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("hybrid-300units/standard"));
  EXPECT_THAT(outcome.output, HasSubstr("frames over 5.00 ms"));
  EXPECT_THAT(outcome.output, HasSubstr("Governed by the clock, so that each run differs: hybrid-5ms."));
  EXPECT_THAT(outcome.output, HasSubstr("touching finely %, worst"));
  EXPECT_FALSE(readText(folder / "x/hybrid-5ms/events.csv").empty());
  EXPECT_THAT(readText(folder / "x/figures/overview.svg"), HasSubstr("its budget 5.00 ms"));
}

TEST_F(ProgramTest, TheReportSaysHowItWasMade) {
  ASSERT_EQ(scatter({"compare", "tower", "--frames", "5", "--seed", "7", "--out", "x"}).status, 0);
  EXPECT_THAT(readText(folder / "x/report.html"),
              HasSubstr("scatter compare tower --frames 5 --seed 7 --out x"));
}

}  // namespace
}  // namespace scatter::test
