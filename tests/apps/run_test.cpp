#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "apps/program.h"

namespace scatter::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr const char* kHeader =
    "frame,time_s,physics_ms,physics_cpu_ms,update_aabbs_ms,predict_motion_ms,collision_detection_ms,islands_"
    "ms,"
    "noncontact_constraints_ms,contact_constraints_ms,integrate_ms,vehicles_ms,activation_ms,plan_ms,cpu_"
    "load,"
    "objects,hybrids,joints,overlapping_pairs,narrowphase_pairs,pairs_with_hybrid,pairs_without_hybrid,"
    "manifolds,"
    "contacts,"
    "new_contacts,requests,switches_coarser,switches_finer,retractions,credited_pairs,finest_pairs,"
    "touching_pairs,touching_finest_pairs,reused_pairs,hidden_contacts,resting_bodies,woken_bodies,"
    "iterations_left_out,"
    "blocked_tries,"
    "separation_queries,cost_units,planned_"
    "units,floor_units,reachable_units,budget_verdict,withheld_pairs,overdue_pairs,"
    "pairs_skipped,list_rebuilds,child_pairs,child_pairs_asleep,recycled,bounds_rejected,axis_rejected,gjk_"
    "runs,"
    "gjk_iterations,detector_runs,half_space_runs,ground_pieces,awake_bodies,budget_ms,budget_units,revised_"
    "units,settled_"
    "units,"
    "kinetic_energy,max_penetration,state_hash";

class RunTest : public ProgramTest {
 protected:
  /// The state hashes of a run that must succeed.
  [[nodiscard]] std::vector<std::string> hashes(std::vector<std::string> arguments,
                                                const std::string& out) const {
    arguments.insert(arguments.end(), {"--out", out});
    const Outcome outcome = scatter(std::move(arguments));
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    return columnOf(folder / out / "frames.csv", "state_hash");
  }
};

TEST_F(RunTest, WritesARowForEveryFrameAndASummary) {
  const Outcome outcome = scatter({"run", "tower", "--frames", "60", "--out", "a/b"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.errors, "");
  EXPECT_THAT(outcome.output, HasSubstr("a/b/frames.csv"));
  EXPECT_THAT(readText(folder / "a/b/events.csv"),
              testing::StartsWith("frame,kind,scope,policy,body,other,from,to,on_credit\n"));
  const auto lines = linesOf(readText(folder / "a/b/frames.csv"));
  ASSERT_EQ(lines.size(), 61U);
  EXPECT_EQ(lines[0], kHeader);
  EXPECT_THAT(lines[60], testing::StartsWith("60,"));
  const std::string summary = readText(folder / "a/b/summary.json");
  for (const char* key : {"peak", "p999", "p99", "median", "total", "frames_over_budget", "state_hash"}) {
    EXPECT_THAT(summary, HasSubstr("\"" + std::string(key) + "\""));
  }
}

TEST_F(RunTest, WithoutAFolderPrintsItsSummaryAndWritesNothing) {
  const Outcome outcome = scatter({"run", "tower", "--frames", "3"});
  EXPECT_EQ(outcome.status, 0);
  for (const char* part :
       {"tower, hybrid world, bullet", "3 frames, seed 1", "peak", "p99", "median", "total",
        "frames over 16.67 ms", "manifolds", "contacts", "switches to coarser", "state hash"}) {
    EXPECT_THAT(outcome.output, HasSubstr(part));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST_F(RunTest, IsTheSameRunAfterRun) {
  for (const char* world : {"standard", "hybrid"}) {
    const std::vector<std::string> arguments{"run", "convergence", "--world", world, "--frames", "120"};
    const auto first = hashes(arguments, std::string("first-") + world);
    EXPECT_EQ(first.size(), 120U);
    EXPECT_EQ(first, hashes(arguments, std::string("second-") + world));
  }
}

TEST_F(RunTest, ProfilingDoesNotChangeTheRun) {
  const auto with = hashes({"run", "tower", "--frames", "60"}, "with");
  EXPECT_EQ(with, hashes({"run", "tower", "--frames", "60", "--no-profiling"}, "without"));
  EXPECT_THAT(columnOf(folder / "with/frames.csv", "integrate_ms"), testing::Contains(Not("0")));
  EXPECT_THAT(columnOf(folder / "without/frames.csv", "integrate_ms"), testing::Each("0"));
}

TEST_F(RunTest, AnotherSeedIsAnotherScene) {
  const auto one = hashes({"run", "convergence", "--frames", "2"}, "one");
  EXPECT_NE(one, hashes({"run", "convergence", "--frames", "2", "--seed", "2"}, "two"));
}

TEST_F(RunTest, TheWorldCoarsestIsTheHybridWorldWithThatPolicy) {
  // The two ships have met by then.
  const auto shorthand = hashes({"run", "duel", "--world", "coarsest", "--frames", "500"}, "shorthand");
  EXPECT_EQ(shorthand, hashes({"run", "duel", "--policy", "coarsest", "--frames", "500"}, "policy"));
  EXPECT_NE(shorthand, hashes({"run", "duel", "--policy", "finest", "--frames", "500"}, "finest"));
}

TEST_F(RunTest, NamedWorldsAreTheHybridWorldWithTheirOptions) {
  const auto duel = [&](std::vector<std::string> more, const std::string& out) {
    const std::vector<std::string> common{"run", "duel", "--frames", "400"};
    more.insert(more.begin(), common.begin(), common.end());
    return hashes(std::move(more), out);
  };
  const auto body = duel({"--world", "hybrid-body"}, "hybrid-body");
  EXPECT_EQ(body, duel({"--switching", "body"}, "body"));
  EXPECT_EQ(body, duel({"--switching", "body", "--policy", "proximity"}, "proximity"));
  EXPECT_THAT(columnOf(folder / "hybrid-body/events.csv", "kind"), testing::Contains("switched"));
  const auto lowest = duel({"--world", "coarsest-body"}, "coarsest-body");
  EXPECT_EQ(lowest, duel({"--switching", "body", "--policy", "coarsest"}, "coarsest"));
  EXPECT_NE(lowest, body);
}

TEST_F(RunTest, EveryLevelEventIsWritten) {
  ASSERT_FALSE(hashes({"run", "duel", "--frames", "500", "--world", "hybrid-body"}, "out").empty());
  const auto frames = columnOf(folder / "out/events.csv", "frame");
  EXPECT_FALSE(frames.empty());
  const auto kinds = columnOf(folder / "out/events.csv", "kind");
  const auto summary = nlohmann::json::parse(readText(folder / "out/summary.json"));
  for (const char* kind : {"requested", "acknowledged", "blocked", "switched", "retracted"}) {
    EXPECT_EQ(std::count(kinds.begin(), kinds.end(), kind), summary["level_events"][kind]) << kind;
  }
}

TEST_F(RunTest, MeasuringFidelityChangesNothing) {
  const std::vector<std::string> worlds[] = {{"standard"},    {"finest"},        {"hybrid"},
                                             {"hybrid-body"}, {"coarsest-body"}, {"hybrid@300units"}};
  for (const auto& world : worlds) {
    const std::vector<std::string> arguments{"run", "convergence", "--world", world[0], "--frames", "450"};
    auto measured = arguments;
    measured.insert(measured.end(), {"--fidelity", "7"});
    EXPECT_EQ(hashes(arguments, "without-" + world[0]), hashes(measured, "with-" + world[0])) << world[0];
    EXPECT_FALSE(nlohmann::json::parse(readText(folder / ("without-" + world[0]) / "summary.json"))
                     .contains("fidelity"));
  }
}

TEST_F(RunTest, FidelityIsInTheFilesAndOnTheScreen) {
  const Outcome outcome = scatter(
      {"run", "convergence", "--world", "coarsest-body", "--frames", "480", "--fidelity", "--out", "o"});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("fidelity, 48 samples"));
  EXPECT_THAT(outcome.output, HasSubstr("largest jump"));
  const auto visible = columnOf(folder / "o/frames.csv", "visible_overlap_pairs");
  ASSERT_EQ(visible.size(), 480U);
  for (std::size_t i = 0; i < visible.size(); ++i) EXPECT_EQ(visible[i].empty(), (i + 1) % 10 != 0) << i;
  const auto fidelity = nlohmann::json::parse(readText(folder / "o/summary.json"))["fidelity"];
  EXPECT_EQ(fidelity["samples"], 48);
  EXPECT_GT(fidelity["touching_pairs"], 0);
  EXPECT_EQ(fidelity["finest_share"]["mean"], 0.0);
  EXPECT_GT(fidelity["contact_gap_p95"], 0.0);
}

TEST_F(RunTest, ARecordedBudgetIsReplayedToTheSameStates) {
  const std::vector<std::string> base{"run", "convergence", "--frames", "450"};
  auto recorded = base;
  recorded.insert(recorded.end(), {"--budget-ms", "0.05"});
  const auto states = hashes(recorded, "recorded");
  auto replayed = base;
  replayed.insert(replayed.end(), {"--replay", "recorded/frames.csv"});
  EXPECT_EQ(hashes(replayed, "replayed"), states);
  for (const char* column : {"budget_units", "revised_units", "settled_units"}) {
    EXPECT_EQ(columnOf(folder / "replayed/frames.csv", column),
              columnOf(folder / "recorded/frames.csv", column));
  }
  const auto options = nlohmann::json::parse(readText(folder / "replayed/summary.json"))["options"];
  EXPECT_EQ(options["switching"]["budget"]["replayed_steps"], 450);
}

TEST_F(RunTest, ABudgetOfUnitsIsTheSameRunAfterRun) {
  const std::vector<std::string> arguments{"run", "convergence", "--frames", "450", "--budget-units", "60"};
  const auto first = hashes(arguments, "first");
  EXPECT_EQ(first, hashes(arguments, "second"));
  EXPECT_EQ(first, hashes({"run", "convergence", "--frames", "450", "--world", "hybrid@60units"}, "third"));
}

TEST_F(RunTest, SwitchingIsInTheSummary) {
  const Outcome outcome =
      scatter({"run", "duel", "--frames", "3", "--policy", "speed:from=4,to=9,held,proximity",
               "--credit-level", "3", "--no-credit", "--budget-ms", "7.5", "--out", "o"});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  const auto options = nlohmann::json::parse(readText(folder / "o/summary.json"))["options"];
  EXPECT_EQ(options["budget_ms"], 7.5);
  const auto& switching = options["switching"];
  EXPECT_EQ(switching["mode"], "pair");
  EXPECT_EQ(switching["policy"], "proximity");
  EXPECT_EQ(switching["policies"], (std::vector<std::string>{"speed:from=4,to=9", "held"}));
  EXPECT_EQ(switching["budget"]["milliseconds"], 7.5);
  EXPECT_EQ(switching["credit"], false);
  EXPECT_EQ(switching["credit_level"], 3);
}

TEST_F(RunTest, BulletsCollisionIsTheStandardWorldAtTheFinestLevel) {
  const std::vector<std::string> duel{"run", "duel", "--frames", "400", "--world"};
  const auto with = [&](std::vector<std::string> more, const std::string& out) {
    more.insert(more.begin(), duel.begin(), duel.end());
    return hashes(std::move(more), out);
  };
  const auto bullet = with({"finest", "--collision", "bullet"}, "bullet");
  EXPECT_EQ(bullet, with({"finest-bullet"}, "finest-bullet"));
  EXPECT_EQ(bullet, with({"standard"}, "standard"));
  EXPECT_THAT(columnOf(folder / "bullet/frames.csv", "child_pairs"), testing::Each("0"));
  // The two ships have met by then.
  EXPECT_EQ(with({"finest", "--collision", "scatter"}, "scatter"), with({"finest"}, "finest"));
  EXPECT_THAT(columnOf(folder / "scatter/frames.csv", "child_pairs"), testing::Contains(Not("0")));
}

TEST_F(RunTest, VerifyingContactsSaysWhatItFoundAndChangesNothing) {
  const std::vector<std::string> arguments{"run", "quiet_hybrids", "--world", "finest", "--frames", "20"};
  const auto plain = hashes(arguments, "plain");
  std::vector<std::string> verified = arguments;
  verified.insert(verified.end(), {"--verify-contacts", "10", "--out", "verified"});
  const Outcome outcome = scatter(verified);
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_THAT(outcome.output,
              testing::ContainsRegex("2 frames verified, [1-9][0-9]* expected, 0 missed, [0-9]+ extra"));
  EXPECT_EQ(plain, columnOf(folder / "verified/frames.csv", "state_hash"));
  EXPECT_THAT(readText(folder / "verified/summary.json"), HasSubstr("\"contact_check\""));
}

TEST_F(RunTest, TheBudgetIsWhatFramesAreCountedAgainst) {
  const Outcome outcome = scatter({"run", "tower", "--frames", "20", "--budget-ms", "1e-6"});
  EXPECT_THAT(outcome.output, testing::ContainsRegex("frames over 1e-06 ms +20 +20"));
}

TEST_F(RunTest, OtherFilesInTheFolderAreLeftAlone) {
  std::filesystem::create_directory(folder / "out");
  const auto write = [&](int frames) {
    return scatter({"run", "tower", "--frames", std::to_string(frames), "--out", "out"}).status;
  };
  std::filesystem::create_directory(folder / "out/mine");
  EXPECT_EQ(write(5), 0);
  EXPECT_EQ(write(4), 0);
  EXPECT_EQ(columnOf(folder / "out/frames.csv", "frame").size(), 4U);
  EXPECT_TRUE(std::filesystem::exists(folder / "out/mine"));
}

// The rows of frames.csv, which are whole, and what summary.json says of them.
void expectFramesUntilThen(const std::filesystem::path& out) {
  const std::string frames = readText(out / "frames.csv");
  ASSERT_FALSE(frames.empty());
  EXPECT_EQ(frames.back(), '\n');
  const std::vector<std::string> rows = columnOf(out / "frames.csv", "frame");
  ASSERT_FALSE(rows.empty());
  EXPECT_EQ(rows.back(), std::to_string(rows.size()));
  EXPECT_THAT(columnOf(out / "frames.csv", "state_hash"), testing::Each(testing::SizeIs(16)));
  EXPECT_THAT(linesOf(readText(out / "events.csv")).front(), testing::StartsWith("frame,kind"));
  const auto summary = nlohmann::json::parse(readText(out / "summary.json"));
  EXPECT_EQ(summary["complete"], false);
  EXPECT_EQ(summary["options"]["frames"], 10000000);
  EXPECT_NE(summary["stopped"], "");
}

TEST_F(RunTest, AnInterruptKeepsTheFramesUntilThen) {
  const Outcome outcome = runProgram({.arguments = {"run", "tower", "--frames", "10000000", "--out", "out"},
                                      .folder = folder,
                                      .interruptOnce = folder / "out/frames.csv",
                                      .lines = 4});
  EXPECT_EQ(outcome.status, 130);
  EXPECT_THAT(outcome.errors, HasSubstr("scatter: this run is not whole: it was interrupted after frame"));
  EXPECT_THAT(outcome.output, HasSubstr("state hash of the last frame"));
  expectFramesUntilThen(folder / "out");
  const auto summary = nlohmann::json::parse(readText(folder / "out/summary.json"));
  EXPECT_EQ(summary["frames"], columnOf(folder / "out/frames.csv", "frame").size());
}

TEST_F(RunTest, AKilledRunKeepsTheFramesUntilThen) {
  const Outcome outcome = runProgram({.arguments = {"run", "tower", "--frames", "10000000", "--out", "out"},
                                      .folder = folder,
                                      .interruptOnce = folder / "out/frames.csv",
                                      .lines = 4,
                                      .signal = SIGKILL});
  EXPECT_EQ(outcome.status, 128 + SIGKILL);
  expectFramesUntilThen(folder / "out");
}

TEST_F(RunTest, AFullDiskKeepsTheFramesUntilThen) {
  const Outcome outcome = runProgram({.arguments = {"run", "tower", "--frames", "10000000", "--out", "out"},
                                      .folder = folder,
                                      .largestFile = 20000});
  EXPECT_EQ(outcome.status, 1);
  ASSERT_EQ(linesOf(outcome.errors).size(), 1U) << outcome.errors;
  EXPECT_THAT(outcome.errors, HasSubstr("frames.csv: File too large; free some space"));
  expectFramesUntilThen(folder / "out");
  EXPECT_THAT(readText(folder / "out/summary.json"), HasSubstr("could not be written after frame"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "out"), {}), 3);
}

TEST_F(RunTest, ABudgetThatCannotBeKeptIsAnsweredInWords) {
  const Outcome outcome = scatter({"run", "duel", "--frames", "50", "--budget-ms", "1e-6"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.output, HasSubstr("the budget of 1e-06 ms was exceeded in 50 of 50 frames"));
  EXPECT_THAT(outcome.output, HasSubstr("What could not be given up"));
}

}  // namespace
}  // namespace scatter::test
