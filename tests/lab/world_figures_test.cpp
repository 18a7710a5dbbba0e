#include <scatter/lab/world_figures.h>

#include <scatter/lab/fidelity_study.h>

#include "lab/fake_physics.h"
#include "lab/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace scatter {
namespace {

using test::fakeRun;
using testing::HasSubstr;
using testing::Not;

// A standard world and hybrid ones that are governed to these times.
CompareOptions governed(const std::vector<double>& budgets, int repeat, int fidelityEvery) {
  CompareOptions options{.runs = {fakeRun(WorldKind::kStandard, 12)}, .repeat = repeat, .commandLine = {}};
  for (const double budget : budgets) {
    RunOptions run = fakeRun(WorldKind::kHybrid, 12);
    run.label = "hybrid-" + std::to_string(static_cast<int>(budget)) + "ms";
    run.physics.switching.budget.milliseconds = budget;
    options.runs.push_back(run);
  }
  for (RunOptions& run : options.runs) {
    run.fidelityEvery = fidelityEvery;
  }
  return options;
}

std::vector<WorldFigures> figuresOf(const CompareOptions& options) {
  const auto comparison = compareWorlds(options);
  EXPECT_TRUE(comparison);
  return worldFigures(*comparison);
}

std::vector<std::vector<std::string>> cellsOf(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::string cell;
    for (std::istringstream cells(line + ','); std::getline(cells, cell, ',');) {
      rows.back().push_back(cell);
    }
  }
  return rows;
}

TEST(WorldFigures, AreMediansOverTheRepeats) {
  const auto comparison = compareWorlds(governed({5.0}, 3, 5));
  ASSERT_TRUE(comparison);
  const auto figures = worldFigures(*comparison);
  ASSERT_EQ(figures.size(), 2U);
  std::vector<double> peaks;
  for (const scatter::Run& run : comparison->worlds[1].repeats) {
    peaks.push_back(run.summary.physicsCpuMs.peak);
  }
  EXPECT_EQ(figures[1].cpuMs.peak, medianOf(peaks));
  EXPECT_EQ(figures[1].ratios.peak.median, comparison->worlds[1].physicsCpuMs.peak.median);
  EXPECT_EQ(figures[1].governedMs, 5.0);
  EXPECT_EQ(figures[0].governedMs, 0.0);
  EXPECT_EQ(figures[1].repeats, 3);
  EXPECT_EQ(figures[1].frames, 12U);
  // As in the fake's steps 5 and 10.
  EXPECT_DOUBLE_EQ(figures[1].visibleOverlapMean, 1.5);
  EXPECT_DOUBLE_EQ(figures[1].finestShareWorst, 5.0 / 8.0);
}

TEST(WorldFigures, HaveTheRatiosOfDetectionAndOfAwakeBodies) {
  const auto comparison = compareWorlds(governed({5.0}, 2, 0));
  ASSERT_TRUE(comparison);
  const auto figures = worldFigures(*comparison);
  // The fake says that detection takes milliseconds, which no frame has; its two bodies never sleep.
  EXPECT_DOUBLE_EQ(figures[1].collisionMs, figures[1].cpuMs.total);
  EXPECT_DOUBLE_EQ(figures[1].collisionRatio.median, figures[1].ratios.total.median);
  EXPECT_DOUBLE_EQ(figures[1].awakeStepRatio.median, figures[1].ratios.total.median);
  const double total = comparison->worlds[1].repeats[0].summary.physicsCpuMs.total;
  const double other = comparison->worlds[1].repeats[1].summary.physicsCpuMs.total;
  EXPECT_DOUBLE_EQ(figures[1].awakeStepUs, 1000.0 * medianOf({total, other}) / (12.0 * 2.0));
}

TEST(WorldFigures, ScenesFollowEachOther) {
  CompareOptions second = governed({}, 1, 0);
  second.runs[0].scene = "other";
  std::vector<std::string> scenes;
  const auto figures =
      benchWorlds({governed({5.0}, 1, 0), second}, [&](const std::string& scene, const CompareProgress&) {
        if (scenes.empty() || scenes.back() != scene) {
          scenes.push_back(scene);
        }
      });
  ASSERT_TRUE(figures);
  EXPECT_THAT(scenes, testing::ElementsAre("fake", "other"));
  ASSERT_EQ(figures->size(), 3U);
  EXPECT_EQ((*figures)[1].label, "hybrid-5ms");
  EXPECT_EQ((*figures)[2].scene, "other");
}

TEST(WorldFigures, ABrokenSceneIsAnError) {
  CompareOptions broken = governed({}, 1, 0);
  broken.runs[0].frames = -1;
  EXPECT_FALSE(benchWorlds({governed({}, 1, 0), broken}));
}

TEST(WorldFigures, EveryRowOfTheFileSaysWhereItIsFrom) {
  auto figures = figuresOf(governed({5.0, 9.0}, 2, 5));
  figures[1].engine = "an \"engine\", of two lines\n1.0";
  const auto rows = cellsOf(worldFiguresCsv(figures));
  ASSERT_EQ(rows.size(), 4U);
  for (const auto& row : rows) {
    EXPECT_EQ(row.size(), rows[0].size());
  }
  const auto cell = [&](std::size_t row, const char* name) {
    const auto found = std::find(rows[0].begin(), rows[0].end(), name);
    EXPECT_NE(found, rows[0].end()) << name;
    return rows[row][static_cast<std::size_t>(found - rows[0].begin())];
  };
  EXPECT_EQ(cell(1, "world"), "standard");
  EXPECT_EQ(cell(3, "governed_ms"), "9");
  EXPECT_EQ(cell(1, "peak_ratio"), "1");
  EXPECT_EQ(cell(2, "visible_overlap_mean"), "1.5");
  EXPECT_NE(cell(2, "collision_detection_ms"), "");
  EXPECT_EQ(cell(1, "collision_detection_ratio"), "1");
  EXPECT_NE(cell(2, "awake_body_step_us"), "");
  EXPECT_EQ(cell(1, "awake_body_step_ratio_max"), "1");
  EXPECT_THAT(cell(2, "date"), testing::MatchesRegex("[0-9-]{10}T[0-9:]{8}Z"));
  for (const char* name : {"commit", "compiler", "build_type", "flags", "cpu", "os"}) {
    EXPECT_NE(cell(2, name), "") << name;
  }
}

TEST(WorldFigures, FidelityIsLeftOutIfItWasNotMeasured) {
  const auto figures = figuresOf(governed({5.0}, 1, 0));
  EXPECT_THAT(formatWorldFigures(figures), Not(HasSubstr("gap p95")));
  EXPECT_THAT(formatWorldFigures(figuresOf(governed({5.0}, 1, 5))), HasSubstr("gap p95"));
  const auto rows = cellsOf(worldFiguresCsv(figures));
  const auto column = std::find(rows[0].begin(), rows[0].end(), "largest_jump_m") - rows[0].begin();
  EXPECT_EQ(rows[1][static_cast<std::size_t>(column)], "");
}

TEST(DrawFidelity, DrawsTheWorldsThatAreGovernedToATime) {
  test::TemporaryFolder folder;
  const auto figure = drawFidelity(figuresOf(governed({9.0, 5.0}, 1, 5)), folder.path());
  ASSERT_TRUE(figure) << figure.error().message;
  EXPECT_THAT(test::contentOf(folder.path() / (figure->name + ".svg")), HasSubstr("worst frame"));
  EXPECT_EQ(test::contentOf(folder.path() / (figure->name + ".png")).substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(folder.entries(), 2U);
}

TEST(DrawFidelity, RefusesWorldsWithoutABudgetOrFidelity) {
  test::TemporaryFolder folder;
  EXPECT_FALSE(drawFidelity(figuresOf(governed({}, 1, 5)), folder.path()));
  EXPECT_FALSE(drawFidelity(figuresOf(governed({5.0}, 1, 0)), folder.path()));
  EXPECT_EQ(folder.entries(), 0U);
}

}  // namespace
}  // namespace scatter
