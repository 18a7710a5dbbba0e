#include <scatter/lab/world_figures.h>
#include <scatter/world/scene.h>
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <vector>

#include "bench_arguments.h"
#include "interrupt.h"
#include "progress_line.h"
#include "run_arguments.h"

namespace scatter::app {

namespace {

constexpr const char* kAllScenes = "all";

struct BenchWorldsArguments {
  BenchArguments bench;
  std::vector<std::string> scenes{kAllScenes};
  std::vector<std::string> worlds{"standard", "finest"};
  int repeat = 3;
  std::optional<int> fidelityEvery;
};

std::vector<std::string> scenesOf(const BenchWorldsArguments& arguments) {
  if (arguments.scenes != std::vector<std::string>{kAllScenes}) {
    return arguments.scenes;
  }
  std::vector<std::string> names;
  for (const auto& scene : SceneRegistry::instance().all()) {
    names.push_back(scene->name);
  }
  return names;
}

Result<std::vector<CompareOptions>> makeComparisons(const BenchWorldsArguments& arguments) {
  std::vector<CompareOptions> comparisons;
  for (const std::string& scene : scenesOf(arguments)) {
    CompareOptions options{.repeat = arguments.repeat};
    for (const std::string& world : arguments.worlds) {
      auto run = makeBenchRun(arguments.bench, scene, world);
      if (!run) {
        return tl::unexpected(run.error());
      }
      run->fidelityEvery = arguments.fidelityEvery.value_or(0);
      options.runs.push_back(std::move(*run));
    }
    comparisons.push_back(std::move(options));
  }
  return comparisons;
}

ExitStatus measure(const BenchWorldsArguments& arguments) {
  const auto comparisons = makeComparisons(arguments);
  if (!comparisons) {
    return refuse(comparisons.error());
  }
  if (auto writable = prepareCsv(arguments.bench); !writable) {
    return refuse(writable.error());
  }
  bool started = false;
  const auto worlds = [&] {
    ProgressLine line(arguments.bench.quiet);
    return benchWorlds(*comparisons, [&](const std::string& scene, const CompareProgress& progress) {
      started = true;
      throwIfInterrupted();
      line.update(fmt::format("{}, {}, run {} of {}", scene, progress.label, progress.run + 1, progress.runs),
                  progress.inside);
    });
  }();
  if (!worlds) {
    return started ? failed(worlds.error()) : refuse(worlds.error());
  }
  return report(arguments.bench, formatWorldFigures(*worlds), worldFiguresCsv(*worlds));
}

}  // namespace

Command addBenchWorldsCommand(CLI::App& bench) {
  CLI::App* command =
      bench.add_subcommand("worlds", "What worlds take on many scenes, as ratios to the first world");
  auto arguments = std::make_shared<BenchWorldsArguments>();
  command->add_option("--scenes", arguments->scenes, "Where to measure; all: every registered scene")
      ->type_name("NAME,NAME")
      ->delimiter(',')
      ->capture_default_str();
  command
      ->add_option("--worlds", arguments->worlds,
                   "What to compare, the first being what the others are compared to; see `scatter list`")
      ->type_name("NAME,NAME")
      ->delimiter(',')
      ->capture_default_str();
  addRepeatArgument(*command, arguments->repeat);
  addFidelityArgument(*command, arguments->fidelityEvery);
  addBenchArguments(*command, arguments->bench);
  return {command, [arguments] { return measure(*arguments); }};
}

}  // namespace scatter::app
