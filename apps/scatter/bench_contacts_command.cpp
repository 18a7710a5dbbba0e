#include <scatter/lab/contact_survey.h>
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <vector>

#include "bench_arguments.h"
#include "number_checks.h"

namespace scatter::app {

namespace {

struct Arguments {
  BenchArguments bench;
  std::vector<std::string> scenes{"duel", "convergence", "fleet", "fleet_boxes", "pile", "quiet_hybrids"};
  std::string world = "finest";
  int verifyEvery = 10;
};

Result<std::vector<RunOptions>> makeSurvey(const Arguments& arguments) {
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

ExitStatus verify(const Arguments& arguments) {
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
  return status == ExitStatus::kOk && missed ? ExitStatus::kFailedCheck : status;
}

}  // namespace

Command addBenchContactsCommand(CLI::App& bench) {
  CLI::App* command = bench.add_subcommand(
      "contacts", "Compare the contacts of hybrid bodies with brute force; status 1 if any is missed");
  auto arguments = std::make_shared<Arguments>();
  command->add_option("--scenes", arguments->scenes, "Where to look")
      ->type_name("NAME,NAME…")
      ->delimiter(',')
      ->capture_default_str();
  command->add_option("--world", arguments->world, "A hybrid world of `scatter list`")
      ->type_name("NAME")
      ->capture_default_str();
  command->add_option("--verify-every", arguments->verifyEvery, "Frames from one verification to the next")
      ->check(wholeNumber<int>(1))
      ->type_name("N")
      ->capture_default_str();
  addBenchArguments(*command, arguments->bench);
  return {command, [arguments] { return verify(*arguments); }};
}

}  // namespace scatter::app
