#include "docs/command_table.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "docs/checks.h"
#include "docs/page.h"

namespace scatter::test {

namespace {

using testing::HasSubstr;

/// What ./run calls without arguments, cut short.
std::string callOfRunScript() {
  for (const std::string& line : linesOf(readPage("run"))) {
    const std::string start = "comparison=(";
    if (line.starts_with(start)) {
      return line.substr(start.size(), line.size() - start.size() - 1) + " --frames 3";
    }
  }
  throw std::runtime_error("the script run calls no command of scatter");
}

/// Runs another command in the same folder.
Outcome alsoCall(const Called& called, const std::string& command) {
  Outcome outcome = runProgram({.arguments = wordsOf(command), .folder = called.folder});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  return outcome;
}

void expectNoDeepContactsWithSafety(const Called& called) {
  static_cast<void>(
      alsoCall(called, "run report_2 --switching body --load-fine-pairs 50 --frames 360 --quiet --out safe"));
  EXPECT_EQ(highestIn(called.folder / "out/unsafe/frames.csv", "blocked_tries"), 0.0);
  EXPECT_GT(highestIn(called.folder / "safe/frames.csv", "blocked_tries"), 0.0);
  EXPECT_GT(highestIn(called.folder / "out/unsafe/frames.csv", "max_penetration"),
            2.0 * highestIn(called.folder / "safe/frames.csv", "max_penetration"));
}

void expectRequestsBeforeOverlap(const Called& called) {
  const auto frames = columnOf(called.folder / "out/margin/events.csv", "frame");
  ASSERT_FALSE(frames.empty());
  EXPECT_LT(std::stoi(frames.front()), firstIn(called.folder / "out/margin/frames.csv", "overlapping_pairs"));
}

void expectPoliciesInEvents(const Called& called) {
  const auto policies = columnOf(called.folder / "out/policies/events.csv", "policy");
  EXPECT_THAT(policies, testing::Contains("speed"));
  EXPECT_THAT(policies, testing::Contains("governor"));
}

void expectAllToSwitchAtOnce(const Called& called) {
  EXPECT_THAT(called.outcome.output, testing::ContainsRegex("switches to coarser +[0-9]+ +20"));
  EXPECT_EQ(highestIn(called.folder / "x/frames.csv", "blocked_tries"), 0.0);
  EXPECT_EQ(highestIn(called.folder / "x/frames.csv", "requests"), 0.0);
}

// Of the line for all, in which so many numbers stand before those that are expected: some are, none is
// missed, none is extra.
Check noneMissedOrExtra(const std::string& numbersBefore) {
  return [numbersBefore](const Called& called) {
    EXPECT_THAT(called.outcome.output,
                testing::ContainsRegex("all( +[0-9]+){" + numbersBefore + "} +[1-9][0-9]* +0 +0 "));
  };
}

void expectReplay(const Called& called) {
  EXPECT_THAT(alsoCall(called, "replay run.rec --frames 3:1 --body hunter").output, HasSubstr("hunter"));
}

void expectNoDifference(const Called& called) {
  EXPECT_THAT(alsoCall(called, "diff run.rec run.rec").output, HasSubstr("the same"));
}

void expectExport(const Called& called) {
  static_cast<void>(alsoCall(called, "export run.rec run.glb"));
  leaves("run.glb")(called);
}

void expectTheHelp(const Called& called) {
  EXPECT_THAT(called.outcome.output, HasSubstr("--sanitize"));
}

std::vector<PageCommand> readmeCommands() {
  return {
      {"./run", callOfRunScript(), says("hybrid-4ms") + leaves("out/fleet/report.html")},
      {"./test", "./test --help", expectTheHelp},
      {"./test --help", "", expectTheHelp},
      {"./run ARGS…", "list", says("duel")},
      {"./run list", "list", says("duel")},
      {"./run run duel --out out/duel", "run duel --out out/duel --frames 20", leaves("out/duel/frames.csv")},
      {"./run compare convergence", "compare convergence --frames 20", leaves("out/convergence/report.html")},
      {"./run --help", "--help", says("report-test")},
      {"./run view fleet --worlds standard,hybrid@8ms",
       "view fleet --worlds standard,hybrid@8ms --renderer null --loops 3", says("hybrid-8ms")},
      {"scatter list", "", says("Scenes") + says("Worlds") + says("Policies") + says("group-density")},
      {"scatter run SCENE", "run duel --frames 20", says("manifolds")},
      {"scatter compare SCENE", "compare duel --frames 20", leaves("out/duel/report.html")},
      {"scatter compare", "compare duel --frames 20", leaves("out/duel/report.html")},
      {"scatter view SCENE", "view duel --renderer null --loops 5", says("hybrid")},
      {"scatter replay FILE", "run duel --frames 5 --record run.rec", expectReplay},
      {"scatter diff A B", "run duel --frames 5 --record run.rec", expectNoDifference},
      {"scatter export FILE OUT", "run duel --frames 5 --record run.rec", expectExport},
      {"scatter levels build MESH -o FILE", "levels build ship.obj -o ship.dae", leaves("ship.dae")},
      {"scatter view ship.dae", "view ship.dae --renderer null --loops 2", says("2 loops")},
      {"scatter convert A B", "convert ship.dae ship.glb", leaves("ship.glb")},
      {"scatter bench worlds", "bench worlds --scenes duel --frames 10 --repeat 1", says("duel")},
      {"scatter bench fidelity SCENE", "bench fidelity duel --budgets 4 --repeat 1 --frames 10",
       says("hybrid-4ms") + leaves("out/duel-fidelity/fidelity_budget.svg")},
      {"scatter bench collision", "bench collision --scene duel --frames 10 --repeat 1",
       says("warm simplex")},
      {"scatter bench contacts", "bench contacts --scenes mugs --frames 100", noneMissedOrExtra("3")},
      {"scatter bench spread", "bench spread --scene duel --frames 10 --seeds 2", says("standard")},
      {"scatter bench budget", "bench budget --scenes duel --frames 10 --floors 2 --over over.csv",
       says("took more than 1.02") + leaves("over.csv")},
      {"scatter bench memory", "bench memory --scene duel --frames 10 --every 5", says("lean")},
      {"scatter bench levels MESH…", "bench levels ship.obj --csv levels.csv",
       says("passes yes") + leaves("levels.csv")},
      {"scatter run fleet --budget-ms 4", "run duel --budget-ms 1e-6 --frames 20",
       says("What could not be given up")},
      {"scatter bench fidelity fleet --budgets 4,6,8,12",
       "bench fidelity fleet --budgets 4,6,8,12 --repeat 1 --frames 3",
       says("hybrid-4ms") + says("hybrid-12ms")},
      {"scatter bench contacts --random 30", "bench contacts --random 1", noneMissedOrExtra("2")},
      {"scatter levels build ship.obj -o ship.dae", "", leaves("ship.dae")},
      {"scatter levels check ship.dae", "", says("level 2 in level 1")},
      {"scatter levels show ship.dae --picture ship.png", "", says("level  parts") + leaves("ship.png")},
      {"scatter run my.toml", "run my.toml --frames 20", says("manifolds")},
  };
}

std::vector<PageCommand> mapCommands() {
  const std::string duel = "out/duel/frames.csv";
  return {
      {"scatter run telekinesis", "run telekinesis --frames 240 --out x",
       grows("x/frames.csv", "kinetic_energy") + grows("x/frames.csv", "manifolds")},
      {"scatter run duel --out out/duel", "run duel --out out/duel --frames 250",
       has(duel, "update_aabbs_ms") + has(duel, "collision_detection_ms") +
           has(duel, "contact_constraints_ms") + has(duel, "integrate_ms") + has(duel, "contacts")},
      {"scatter run collapse --out out/collapse", "run collapse --out out/collapse --frames 60",
       has("out/collapse/frames.csv", "noncontact_constraints_ms")},
      {"scatter run breakables --out out/breakables", "run breakables --out out/breakables --frames 90",
       grows("out/breakables/frames.csv", "objects") +
           grows("out/breakables/frames.csv", "narrowphase_pairs")},
      {"scatter levels check models/hunter.dae", "", says("level 3 in level 2") + says("level 2 in level 1")},
      {"scatter levels check models/fighter.dae", "",
       says("level 3 in level 2") + says("level 2 in level 1")},
      {"scatter compare mugs --worlds finest,coarsest", "compare mugs --worlds finest,coarsest --frames 200",
       differs("out/mugs/finest/frames.csv", "out/mugs/coarsest/frames.csv", "state_hash")},
      {"scatter run report_2 --switching body --load-fine-pairs 50 --unsafe-switching --out out/unsafe",
       "run report_2 --switching body --load-fine-pairs 50 --unsafe-switching --out out/unsafe --frames 360",
       expectNoDeepContactsWithSafety},
      {"scatter run report_2 --policy speed:coarse=5,group-density --budget-units 300 --out out/policies", "",
       expectPoliciesInEvents},
      {"scatter run tower", "run tower --frames 60", says("contacts")},
      {"scatter run duel", "run duel --frames 20", says("bullet 3.")},
      {"scatter run quiet_stacks", "run quiet_stacks --frames 20", says("contacts")},
      {"scatter view duel", "view duel --renderer null --loops 5", says("hybrid")},
      {"scatter view duel --views contacts,levels",
       "view duel --views contacts,levels --renderer null --loops 5", says("hybrid")},
      {"scatter view fleet", "view fleet --renderer null --loops 3", says("hybrid")},
      {"scatter compare tower", "compare tower --frames 60",
       same("out/tower/standard/frames.csv", "out/tower/hybrid/frames.csv", "state_hash")},
      {"scatter compare fleet", "compare fleet --frames 3", leaves("out/fleet/report.html")},
      {"scatter run duel --switching body --out out/margin",
       "run duel --switching body --out out/margin --frames 250", expectRequestsBeforeOverlap},
      {"scatter run fleet --budget-units 4000 --fidelity",
       "run fleet --budget-units 4000 --fidelity 1 --frames 3",
       says("visible overlaps") + says("contact gap")},
      {"scatter bench fidelity fleet", "bench fidelity fleet --budgets 4 --repeat 1 --frames 3",
       says("fleet, hybrid-4ms") + leaves("out/fleet-fidelity/fidelity_budget.svg")},
  };
}

std::vector<PageCommand> reportTestCommands() {
  const std::string one = "out/report-test-1/test-1/frames.csv";
  const std::string two = "out/report-test-2/test-2/frames.csv";
  return {
      {"scatter report-test 1", "",
       says("they touch again") + has(one, "narrowphase_pairs") + has(one, "manifolds") +
           has(one, "new_contacts") + leaves("out/report-test-1/figures/fig-5-06.png")},
      {"scatter report-test 2", "",
       says("not safe") + says("hunter switches to level 1") + says("fighter switches to level 1") +
           has(two, "plan_ms") + leaves("out/report-test-2/figures/fig-5-05.png")},
      {"scatter report-test 3", "",
       says("1600  the end") + leaves("out/report-test-3/test-3/frames.csv") +
           leaves("out/report-test-3/figures/fig-5-11.svg")},
      {"scatter report-test 4", "",
       says("tries that are not safe") + says("requests are retracted") + says("--retry-interval") +
           leaves("out/report-test-4/figures/fig-5-07.png")},
      {"scatter report-test all", "",
       leaves("out/report-test-all/figures/fig-5-05.svg") +
           leaves("out/report-test-all/figures/fig-5-08.svg") +
           leaves("out/report-test-all/figures/fig-5-11.svg")},
      {"scatter run report_2 --switching body --collision bullet --proximity-steps 0 --quiet-steps 100000",
       "run report_2 --switching body --collision bullet --proximity-steps 0 --quiet-steps 100000 --out x",
       expectAllToSwitchAtOnce},
  };
}

}  // namespace

std::ostream& operator<<(std::ostream& stream, const PageCommand& command) {
  return stream << command.command;
}

const std::vector<PageCommand>& pageCommands() {
  static const std::vector<PageCommand> all = [] {
    std::vector<PageCommand> commands = readmeCommands();
    for (const auto& more : {mapCommands(), reportTestCommands()}) {
      commands.insert(commands.end(), more.begin(), more.end());
    }
    return commands;
  }();
  return all;
}

}  // namespace scatter::test
