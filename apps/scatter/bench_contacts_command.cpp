#include <scatter/bullet/contact_trials.h>
#include <scatter/lab/contact_survey.h>
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench_arguments.h"
#include "lab/text.h"
#include "lab/text_table.h"
#include "number_checks.h"

namespace scatter::app {

namespace {

struct BenchContactsArguments {
  BenchArguments bench;
  std::vector<std::string> scenes{"duel", "convergence", "fleet", "fleet_boxes", "pile", "quiet_hybrids"};
  std::string world = "finest";
  int verifyEvery = 10;
  std::optional<int> random;
};

using Cells = std::vector<std::string>;

constexpr const char* kLegend =
    "Pairs: of parts. Expected: those that a plain engine has in contact at the same places; of these "
    "missed, and "
    "besides these extra. Doubt: rounding decides. Errs: the engine's own detector errs, by proof.";

Cells cellsOf(const ContactTrial& trial) {
  Cells cells{trial.shape};
  for (const auto count : {trial.worlds, trial.childPairs, trial.expected, trial.missed, trial.extra,
                           trial.doubtful, trial.engineErrs}) {
    cells.push_back(std::to_string(count));
  }
  return cells;
}

/// Random worlds of every kind of convex shape, so many of each.
ExitStatus tryShapes(const BenchContactsArguments& arguments) {
  if (auto writable = prepareCsv(arguments.bench); !writable) {
    return refuse(writable.error());
  }
  std::vector<Cells> table{{"shape", "worlds", "pairs", "expected", "missed", "extra", "doubt", "errs"}};
  std::vector<Cells> csv{
      {"shape", "worlds", "child_pairs", "expected", "missed", "extra", "doubtful", "engine_errs"}};
  ContactTrial all{.shape = "all"};
  for (const std::string& shape : contactTrialShapes()) {
    ContactTrial trials{.shape = shape};
    for (int seed = 0; seed < *arguments.random; ++seed) {
      trials += runContactTrial(shape, static_cast<std::uint64_t>(seed));
    }
    table.push_back(cellsOf(trials));
    csv.push_back(cellsOf(trials));
    all += trials;
  }
  table.push_back(cellsOf(all));
  const ExitStatus status =
      report(arguments.bench, lab::textTable(table) + lab::fitTerminal(kLegend), lab::csvText(csv));
  const bool differs = all.missed > 0 || all.extra > 0;
  return status == ExitStatus::kOk && differs ? ExitStatus::kFailed : status;
}

Result<std::vector<RunOptions>> makeSurvey(const BenchContactsArguments& arguments) {
  std::vector<RunOptions> runs;
  for (const std::string& scene : arguments.scenes) {
    auto run = makeBenchRun(arguments.bench, scene, arguments.world);
    if (!run) {
      return tl::unexpected(run.error());
    }
    if (run->physics.world != WorldKind::kHybrid) {
      return fail("only the contacts of a hybrid world can be verified; leave --world out or use finest");
    }
    run->physics.collision.verifyEvery = arguments.verifyEvery;
    runs.push_back(std::move(*run));
  }
  return runs;
}

ExitStatus verify(const BenchContactsArguments& arguments) {
  const auto runs = makeSurvey(arguments);
  if (!runs) {
    return refuse(runs.error());
  }
  if (auto writable = prepareCsv(arguments.bench); !writable) {
    return refuse(writable.error());
  }
  const auto scenes = surveyContacts(*runs, benchProgress(arguments.bench, "contacts"));
  if (!scenes) {
    return failed(scenes.error());
  }
  const ExitStatus status = report(arguments.bench, formatContacts(*scenes), contactsCsv(*scenes));
  for (const SceneContacts& scene : *scenes) {
    if (scene.check.missed > 0) {
      fmt::print("{}:\n{}", scene.scene, formatMisses(scene.check));
    }
  }
  const bool missed = totalOf(*scenes).missed > 0;
  return status == ExitStatus::kOk && missed ? ExitStatus::kFailed : status;
}

}  // namespace

Command addBenchContactsCommand(CLI::App& bench) {
  CLI::App* command = bench.add_subcommand(
      "contacts", "Compare the contacts of hybrid bodies with the engine's own; status 1 if any is missed");
  auto arguments = std::make_shared<BenchContactsArguments>();
  command->add_option("--scenes", arguments->scenes, "Where to look")
      ->type_name("NAME,NAME")
      ->delimiter(',')
      ->capture_default_str();
  command->add_option("--world", arguments->world, "A hybrid world of `scatter list`")
      ->type_name("NAME")
      ->capture_default_str();
  command->add_option("--verify-every", arguments->verifyEvery, "Frames from one verification to the next")
      ->check(wholeNumber<int>(1))
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--random", arguments->random,
                   "In the place of scenes: so many random worlds of every convex shape; status 1 if any is "
                   "extra, too")
      ->check(wholeNumber<int>(1))
      ->type_name("N");
  addBenchArguments(*command, arguments->bench);
  return {command, [arguments] { return arguments->random ? tryShapes(*arguments) : verify(*arguments); }};
}

}  // namespace scatter::app
