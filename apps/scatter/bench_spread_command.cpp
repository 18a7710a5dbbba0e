#include <scatter/lab/spread_study.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <vector>

#include "bench_arguments.h"

namespace scatter::app {

namespace {

struct BenchSpreadArguments {
  BenchArguments bench;
  std::string scene = "fleet";
  std::vector<std::string> worlds{"standard", "finest"};
  int seeds = 10;
};

Result<SpreadOptions> makeStudy(const BenchSpreadArguments& arguments) {
  SpreadOptions options;
  for (const std::string& world : arguments.worlds) {
    auto run = makeBenchRun(arguments.bench, arguments.scene, world);
    if (!run) {
      return tl::unexpected(run.error());
    }
    options.worlds.push_back(std::move(*run));
  }
  options.seeds = seedsUpTo(arguments.seeds);
  return options;
}

ExitStatus study(const BenchSpreadArguments& arguments) {
  const auto options = makeStudy(arguments);
  if (!options) {
    return refuse(options.error());
  }
  if (auto writable = prepareCsv(arguments.bench); !writable) {
    return refuse(writable.error());
  }
  const auto result = studySpread(*options, benchProgress(arguments.bench, arguments.scene));
  if (!result) {
    return failed(result.error());
  }
  return report(arguments.bench, formatSpread(*result), spreadCsv(*result));
}

}  // namespace

Command addBenchSpreadCommand(CLI::App& bench) {
  CLI::App* command = bench.add_subcommand(
      "spread",
      "Depth, energy and size of the pile over many seeds: does another world differ by more than chance?");
  auto arguments = std::make_shared<BenchSpreadArguments>();
  addSceneArgument(*command, arguments->scene);
  command
      ->add_option("--worlds", arguments->worlds, "What to compare; the first one's extremes are the measure")
      ->type_name("NAME,NAME")
      ->delimiter(',')
      ->capture_default_str();
  command->add_option("--seeds", arguments->seeds, "Seeds from 1 to this")
      ->check(CLI::Range(1, 1000))
      ->type_name("N")
      ->capture_default_str();
  addBenchArguments(*command, arguments->bench);
  return {command, [arguments] { return study(*arguments); }};
}

}  // namespace scatter::app
