#include <scatter/lab/comparison.h>

#include "lab/fake_physics.h"
#include "lab/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

namespace scatter {
namespace {

namespace fs = std::filesystem;
using test::contentOf;
using test::fakeRun;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

CompareOptions twoWorlds(int repeat, int frames = 40) {
  return {.runs = {fakeRun(WorldKind::kStandard, frames), fakeRun(WorldKind::kHybrid, frames)},
          .repeat = repeat,
          .commandLine = "scatter compare <fake> & more"};
}

TEST(CompareWorlds, InterleavesRunsInAlternatingOrder) {
  std::vector<std::string> order;
  int lastRun = -1;
  const auto comparison = compareWorlds(twoWorlds(3), [&](const CompareProgress& progress) {
    if (progress.run != lastRun) {
      order.push_back(progress.label);
      lastRun = progress.run;
    }
    EXPECT_EQ(progress.runs, 6);
  });
  ASSERT_TRUE(comparison);
  EXPECT_THAT(order, ElementsAre("standard", "hybrid", "hybrid", "standard", "standard", "hybrid"));
  EXPECT_EQ(comparison->worlds[0].repeats.size(), 3U);
  EXPECT_EQ(lastRun, 5);
}

TEST(CompareWorlds, NamesTheWorldAndTheFirstFrameInWhichARepeatDiffers) {
  CompareOptions options = twoWorlds(3);
  auto made = std::make_shared<int>(0);
  options.runs[1].engine = [made](const PhysicsDef& def) -> Result<std::unique_ptr<Physics>> {
    // The second hybrid run is another one from step 17 on.
    const bool second = ++*made == 2;
    return std::make_unique<test::FakePhysics>(def, test::FakeBehaviour{.hashFlipStep = second ? 17U : 0U});
  };
  const auto comparison = compareWorlds(options);
  ASSERT_FALSE(comparison);
  EXPECT_THAT(comparison.error().message, HasSubstr("hybrid world"));
  EXPECT_THAT(comparison.error().message, HasSubstr("from frame 17 on"));
  EXPECT_THAT(comparison.error().message, Not(HasSubstr("\n")));
}

// The fake of every second run is another one from step 5 on.
EngineFactory fickleEngine() {
  return [made = std::make_shared<int>(0)](const PhysicsDef& def) -> Result<std::unique_ptr<Physics>> {
    const bool other = ++*made % 2 == 0;
    return std::make_unique<test::FakePhysics>(def, test::FakeBehaviour{.hashFlipStep = other ? 5U : 0U});
  };
}

TEST(CompareWorlds, RepeatsOfAWorldThatTheClockGovernsMayDiffer) {
  CompareOptions options = twoWorlds(3);
  options.runs[1].engine = fickleEngine();
  options.runs[1].physics.switching.budget.milliseconds = 5.0;
  options.runs[1].label = "hybrid-5ms";
  const auto comparison = compareWorlds(options);
  ASSERT_TRUE(comparison) << comparison.error().message;
  const std::string table = formatTable(*comparison);
  EXPECT_THAT(table,
              testing::ContainsRegex("Governed by the clock, so that\\seach run differs:\\shybrid-5ms\\."));
  EXPECT_THAT(table, testing::ContainsRegex("Counts of\\sthe other worlds are the same in all repeats\\."));
}

TEST(CompareWorlds, RepeatsOfAWorldWithABudgetOfUnitsMayNotDiffer) {
  CompareOptions options = twoWorlds(3);
  options.runs[1].engine = fickleEngine();
  options.runs[1].physics.switching.budget.units = 3000.0;
  EXPECT_FALSE(compareWorlds(options));
  // Body switching has no budget, whatever it says.
  options.runs[1].physics.switching.switching = Switching::kBody;
  options.runs[1].physics.switching.budget.milliseconds = 5.0;
  EXPECT_FALSE(compareWorlds(options));
}

TEST(CompareWorlds, RatiosAreTakenWithinRepeats) {
  const auto comparison = compareWorlds(twoWorlds(3));
  ASSERT_TRUE(comparison);
  const auto total = [&](std::size_t world, std::size_t repeat) {
    return comparison->worlds[world].repeats[repeat].summary.physicsMs.total;
  };
  std::vector<double> ratios;
  for (std::size_t repeat = 0; repeat < 3; ++repeat) {
    ratios.push_back(total(1, repeat) / total(0, repeat));
  }
  std::sort(ratios.begin(), ratios.end());
  const Spread& spread = comparison->worlds[1].physicsMs.total;
  EXPECT_EQ(spread.min, ratios[0]);
  EXPECT_EQ(spread.median, ratios[1]);
  EXPECT_EQ(spread.max, ratios[2]);
  EXPECT_EQ(comparison->worlds[0].physicsMs.total.median, 1.0);
}

TEST(CompareWorlds, FiguresHaveThePerFrameMedianAndTheTypicalRepeatTheMedianTotal) {
  const auto comparison = compareWorlds(twoWorlds(3));
  ASSERT_TRUE(comparison);
  const ComparedWorld& world = comparison->worlds[1];
  for (std::size_t frame = 0; frame < 40; ++frame) {
    std::vector<double> times;
    for (const scatter::Run& run : world.repeats) {
      times.push_back(run.table.values("physics_ms")[frame]);
    }
    std::sort(times.begin(), times.end());
    ASSERT_EQ(world.median.values("physics_ms")[frame], times[1]);
  }
  std::vector<double> totals;
  for (const scatter::Run& run : world.repeats) {
    totals.push_back(run.summary.physicsCpuMs.total);
  }
  std::sort(totals.begin(), totals.end());
  EXPECT_EQ(world.run().summary.physicsCpuMs.total, totals[1]);
}

TEST(CompareWorlds, RefusesSameLabelsNoWorldsAndNoRepeats) {
  CompareOptions same = twoWorlds(1);
  same.runs[1].label = "standard";
  EXPECT_THAT(compareWorlds(same).error().message, HasSubstr("'standard'"));
  EXPECT_FALSE(compareWorlds({}));
  EXPECT_FALSE(compareWorlds(twoWorlds(0)));
}

TEST(FormatTable, HasAColumnForEachWorldAndTheRatio) {
  const auto comparison = compareWorlds(twoWorlds(2));
  ASSERT_TRUE(comparison);
  const std::string table = formatTable(*comparison);
  EXPECT_THAT(table, testing::ContainsRegex("^ +standard +hybrid\n"));
  // 40 steps: 4 manifolds a step in the standard world, 1 in the hybrid one.
  EXPECT_THAT(table, testing::ContainsRegex("manifolds, peak +160 +40 \\(0.25\\)\n"));
  EXPECT_THAT(table, testing::ContainsRegex("narrowphase pairs, peak +80 +80 \\(1.00\\)\n"));
  EXPECT_THAT(table, testing::ContainsRegex("switches to coarser +0 +1\n"));
  EXPECT_THAT(table, testing::ContainsRegex("requests made +0 +1\n"));
  for (const char* row : {"CPU ms, peak", "CPU ms, p99", "CPU ms, median", "CPU ms, total",
                          "CPU ms, last 100 mean", "wall ms, peak", "wall ms, total", "frames over 16.7 ms",
                          "contacts, peak", "switches to finer", "retracted"}) {
    EXPECT_THAT(table, HasSubstr(row));
  }
  // Below the ratio of a time are its extremes.
  EXPECT_THAT(table, testing::ContainsRegex("CPU ms, total.*\n +[0-9.]+-[0-9.]+\n"));
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), 80U) << line;
  }
}

TEST(FormatTable, CountsEveryWorldAgainstEveryBudget) {
  CompareOptions options = twoWorlds(1);
  options.runs[1].budgetMs = 1e-9;
  const auto comparison = compareWorlds(options);
  ASSERT_TRUE(comparison);
  const std::string table = formatTable(*comparison);
  EXPECT_THAT(table, testing::ContainsRegex("frames over 16.7 ms \\(CPU\\) +0 +0\n"));
  EXPECT_THAT(table, testing::ContainsRegex("frames over 1e-09 ms \\(CPU\\) +40 +40 \\(1.00\\)\n"));
}

TEST(FormatTable, HasFidelityOnlyIfItWasMeasured) {
  CompareOptions options = twoWorlds(1);
  EXPECT_THAT(formatTable(*compareWorlds(options)), Not(HasSubstr("overlaps")));
  for (RunOptions& run : options.runs) {
    run.fidelityEvery = 10;
  }
  const std::string table = formatTable(*compareWorlds(options));
  // In steps 10, 20, 30 and 40 there are 2, 0, 2 and 0 among 13, 23, 33 and 43.
  EXPECT_THAT(table, testing::ContainsRegex("overlaps seen, mean +1.00 +1.00"));
  EXPECT_THAT(table, testing::ContainsRegex("overlaps, per 100 touching +3.57 +3.57"));
  // 10 of 13 in step 10.
  EXPECT_THAT(table, testing::ContainsRegex("touching finely %, worst +76.9 +76.9"));
}

/// Two fake worlds that are written while they run; `ran` counts the runs that were made.
CompareOptions writtenInto(const fs::path& folder, int& ran) {
  CompareOptions options = twoWorlds(2);
  options.out = folder;
  for (RunOptions& run : options.runs) {
    run.inspect = [&ran](const World& /*world*/) { ++ran; };
  }
  return options;
}

/// As if the user had interrupted run `run`, from 1, after its first frame.
void interruptIn(int run, const int& ran, CompareOptions& options) {
  for (RunOptions& world : options.runs) {
    world.stop = [&ran, run] { return ran + 1 == run; };
  }
}

TEST(CompareWorlds, WhatWasCutShortIsResumedWithTheRunsThatAreWhole) {
  TemporaryFolder folder;
  int ran = 0;
  CompareOptions options = writtenInto(folder.path(), ran);
  interruptIn(3, ran, options);
  const auto cut = compareWorlds(options);
  ASSERT_FALSE(cut);
  EXPECT_THAT(cut.error().message, testing::AllOf(HasSubstr("run 3 of 4"), HasSubstr("--resume")));
  EXPECT_EQ(ran, 3);
  EXPECT_EQ(contentOf(folder.path() / "hybrid/repeat-2/summary.json").find("\"complete\": true"),
            std::string::npos);

  int more = 0;
  options = writtenInto(folder.path(), more);
  options.resume = true;
  const auto whole = compareWorlds(options);
  ASSERT_TRUE(whole) << whole.error().message;
  EXPECT_EQ(more, 2);
  ASSERT_TRUE(writeComparison(*whole, folder.path()));
  EXPECT_THAT(contentOf(folder.path() / "comparison.json"), HasSubstr("\"complete\": true"));

  // In one go it is the same, but for times.
  TemporaryFolder other;
  const auto inOneGo = compareWorlds(writtenInto(other.path(), more));
  ASSERT_TRUE(inOneGo);
  for (std::size_t world = 0; world < 2; ++world) {
    for (std::size_t repeat = 0; repeat < 2; ++repeat) {
      const scatter::Run& a = whole->worlds[world].repeats[repeat];
      const scatter::Run& b = inOneGo->worlds[world].repeats[repeat];
      EXPECT_EQ(a.table.hashes("state_hash"), b.table.hashes("state_hash"));
      EXPECT_EQ(a.table.values("manifolds"), b.table.values("manifolds"));
      EXPECT_EQ(a.summary.levelEvents, b.summary.levelEvents);
      EXPECT_EQ(a.summary.engine, b.summary.engine);
      EXPECT_EQ(a.summary.stateHash, b.summary.stateHash);
    }
  }
}

TEST(CompareWorlds, AnotherComparisonIsNotResumedAndWholeRunsAreNotLostUnasked) {
  TemporaryFolder folder;
  int ran = 0;
  CompareOptions options = writtenInto(folder.path(), ran);
  interruptIn(2, ran, options);
  ASSERT_FALSE(compareWorlds(options));

  ran = 0;
  options = writtenInto(folder.path(), ran);
  EXPECT_THAT(compareWorlds(options).error().message,
              testing::AllOf(HasSubstr("1 finished runs"), HasSubstr("--resume"), HasSubstr("--anew")));
  options.resume = true;
  options.runs[1].seed = 77;
  EXPECT_THAT(compareWorlds(options).error().message, HasSubstr("(seed differs)"));
  EXPECT_EQ(ran, 0);
  options.resume = false;
  options.anew = true;
  ASSERT_TRUE(compareWorlds(options));
  EXPECT_EQ(ran, 4);
}

TEST(CompareWorlds, ARunThatIsNotWhatItsSummarySaysIsNotTaken) {
  TemporaryFolder folder;
  int ran = 0;
  ASSERT_TRUE(compareWorlds(writtenInto(folder.path(), ran)));
  CompareOptions options = writtenInto(folder.path(), ran);
  options.resume = true;
  const fs::path frames = folder.path() / "standard/repeat-1/frames.csv";
  const std::string whole = contentOf(frames);
  const auto expectRefused = [&](const std::string& content, const char* words) {
    std::ofstream(frames, std::ios::trunc) << content;
    const auto compared = compareWorlds(options);
    ASSERT_FALSE(compared);
    EXPECT_THAT(compared.error().message, testing::AllOf(HasSubstr(words), HasSubstr("repeat-1")));
  };
  expectRefused(whole.substr(0, whole.rfind('\n', whole.size() - 2) + 1), "not as many frames");
  expectRefused("x" + whole, "other columns");
  expectRefused(whole.substr(0, whole.size() - 20), "not as many frames");
  std::ofstream(frames, std::ios::trunc) << whole;
  EXPECT_TRUE(compareWorlds(options));
}

TEST(WriteComparison, WritesTheEventsThatWereKept) {
  CompareOptions options = twoWorlds(1);
  options.runs[1].keepEvents = true;
  TemporaryFolder folder;
  const auto comparison = compareWorlds(options);
  ASSERT_TRUE(comparison);
  ASSERT_TRUE(writeComparison(*comparison, folder.path()));
  EXPECT_FALSE(fs::exists(folder.path() / "standard" / "events.csv"));
  EXPECT_THAT(contentOf(folder.path() / "hybrid" / "events.csv"), HasSubstr("2,switched,global,governor"));
}

TEST(WriteComparison, LeavesAFolderThatAStrangerUnderstands) {
  TemporaryFolder folder;
  const auto comparison = compareWorlds(twoWorlds(2));
  ASSERT_TRUE(comparison);
  const fs::path out = folder.path() / "out";
  const auto written = writeComparison(*comparison, out);
  ASSERT_TRUE(written) << written.error().message;
  EXPECT_EQ(folder.entries(), 1U);
  for (const char* label : {"standard", "hybrid"}) {
    EXPECT_TRUE(fs::exists(out / label / "frames.csv"));
    EXPECT_TRUE(fs::exists(out / label / "summary.json"));
  }
  const auto json = nlohmann::json::parse(contentOf(out / "comparison.json"));
  EXPECT_EQ(json["worlds"].size(), 2U);
  EXPECT_EQ(json["worlds"][1]["label"], "hybrid");
  EXPECT_EQ(json["repeat"], 2);
  EXPECT_TRUE(json["worlds"][1]["ratios_to_first_world"]["physics_cpu_ms"]["total"]["median"].is_number());
  EXPECT_EQ(json["worlds"][1]["repeats"].size(), 2U);

  const std::string html = contentOf(out / "report.html");
  for (const char* part :
       {"Two boxes pass each other.", "<table>", "standard/frames.csv", "hybrid/summary.json", "gcc",
        "fake 1.0", "scatter compare &lt;fake&gt; &amp; more", "collision overload", "plain physics engine",
        "<figcaption>", "figures/stages.png", "switching pair, policy none", "</html>"}) {
    EXPECT_THAT(html, HasSubstr(part));
  }
  EXPECT_EQ(html.find("id=\"page-data\"") != std::string::npos, hasReportPage());
}

TEST(WriteComparison, AFailureLeavesNothing) {
  TemporaryFolder folder;
  TemporaryFolder empty;
  const auto comparison = compareWorlds(twoWorlds(1));
  ASSERT_TRUE(comparison);
  const std::string path = std::getenv("PATH");
  setenv("PATH", empty.path().c_str(), 1);
  const auto written = writeComparison(*comparison, folder.path() / "out");
  setenv("PATH", path.c_str(), 1);
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message, HasSubstr("gnuplot-nox"));
  EXPECT_EQ(folder.entries(), 0U);
}

}  // namespace
}  // namespace scatter
