#include <gmock/gmock.h>

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
    "objects,hybrids,overlapping_pairs,narrowphase_pairs,pairs_with_hybrid,pairs_without_hybrid,manifolds,"
    "contacts,"
    "new_contacts,requests,switches_coarser,switches_finer,retractions,credited_pairs,finest_pairs,"
    "pairs_skipped,list_rebuilds,child_pairs,child_pairs_asleep,bounds_rejected,axis_rejected,gjk_runs,"
    "gjk_iterations,detector_runs,budget_ms,"
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
  const auto shorthand = hashes({"run", "duel", "--world", "coarsest", "--frames", "5"}, "shorthand");
  EXPECT_EQ(shorthand, hashes({"run", "duel", "--policy", "coarsest", "--frames", "5"}, "policy"));
  EXPECT_NE(shorthand, hashes({"run", "duel", "--policy", "finest", "--frames", "5"}, "finest"));
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

TEST_F(RunTest, AnInterruptLeavesNoFiles) {
  const Outcome outcome = runProgram({.arguments = {"run", "tower", "--frames", "10000000", "--out", "out"},
                                      .folder = folder,
                                      .interruptOnceIn = folder / "out"});
  EXPECT_EQ(outcome.status, 130);
  EXPECT_THAT(outcome.errors, HasSubstr("scatter: interrupted"));
  EXPECT_TRUE(std::filesystem::is_empty(folder / "out"));
}

}  // namespace
}  // namespace scatter::test
