#include <scatter/lab/memory_study.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "bench_arguments.h"

namespace scatter::app {

namespace {

struct BenchMemoryArguments {
  BenchArguments bench;
  std::string scene = "fleet";
  std::vector<std::string> worlds{"standard", "finest", "lean"};
  int every = 10;
};

Result<CompareOptions> makeComparison(const BenchMemoryArguments& arguments) {
  CompareOptions options{.repeat = 1};
  for (const std::string& world : arguments.worlds) {
    auto run = makeBenchRun(arguments.bench, arguments.scene, world);
    if (!run) {
      return tl::unexpected(run.error());
    }
    run->memoryEvery = arguments.every;
    options.runs.push_back(std::move(*run));
  }
  return options;
}

ExitStatus measure(const BenchMemoryArguments& arguments) {
  const auto options = makeComparison(arguments);
  if (!options) {
    return refuse(options.error());
  }
  if (auto writable = prepareCsv(arguments.bench); !writable) {
    return refuse(writable.error());
  }
  const auto comparison = compareWorlds(*options, benchProgress(arguments.bench, arguments.scene));
  if (!comparison) {
    return failed(comparison.error());
  }
  return report(arguments.bench, formatMemory(*comparison), memoryCsv(*comparison));
}

}  // namespace

Command addBenchMemoryCommand(CLI::App& bench) {
  CLI::App* command = bench.add_subcommand("memory", "How much memory a step touches");
  auto arguments = std::make_shared<BenchMemoryArguments>();
  addSceneArgument(*command, arguments->scene);
  command->add_option("--worlds", arguments->worlds, "Where to count; see `scatter list`")
      ->type_name("NAME,NAME")
      ->delimiter(',')
      ->capture_default_str();
  command->add_option("--every", arguments->every, "Frames from one count to the next")
      ->check(CLI::Range(1, 1000))
      ->type_name("N")
      ->capture_default_str();
  addBenchArguments(*command, arguments->bench);
  return {command, [arguments] { return measure(*arguments); }};
}

}  // namespace scatter::app
