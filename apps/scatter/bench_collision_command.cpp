#include <scatter/lab/collision_steps.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "bench_arguments.h"

namespace scatter::app {

namespace {

struct BenchCollisionArguments {
  BenchArguments bench;
  std::string scene = "fleet";
  int repeat = 1;
};

ExitStatus measure(const BenchCollisionArguments& arguments) {
  const auto base = makeBenchRun(arguments.bench, arguments.scene, "standard");
  if (!base) {
    return refuse(base.error());
  }
  if (auto writable = prepareCsv(arguments.bench); !writable) {
    return refuse(writable.error());
  }
  const auto comparison =
      compareWorlds({.runs = collisionStepRuns(*base), .repeat = arguments.repeat, .commandLine = {}},
                    benchProgress(arguments.bench, arguments.scene));
  if (!comparison) {
    return failed(comparison.error());
  }
  return report(arguments.bench, formatCollisionSteps(*comparison), collisionStepsCsv(*comparison));
}

}  // namespace

Command addBenchCollisionCommand(CLI::App& bench) {
  CLI::App* command = bench.add_subcommand(
      "collision", "What each step of the pair algorithm is worth, as ratios to the standard world");
  auto arguments = std::make_shared<BenchCollisionArguments>();
  addSceneArgument(*command, arguments->scene);
  command
      ->add_option("--repeat", arguments->repeat,
                   "Runs of each step, interleaved; ratios are medians over them")
      ->check(CLI::Range(1, 1000))
      ->type_name("N")
      ->capture_default_str();
  addBenchArguments(*command, arguments->bench);
  return {command, [arguments] { return measure(*arguments); }};
}

}  // namespace scatter::app
