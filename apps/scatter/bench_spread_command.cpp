#include <scatter/lab/spread_study.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "bench_arguments.h"
#include "family_arguments.h"
#include "run_arguments.h"

namespace scatter::app {

namespace {

struct BenchSpreadArguments {
  BenchArguments bench;
  std::string scene = "fleet";
  std::optional<std::string> family;
  double scale = 1.0;
  std::vector<std::string> worlds{"standard", "finest"};
  std::vector<double> floors;
  std::optional<int> fidelityEvery;
  int seeds = 10;
};

// A scene of the family for each seed, in the folder.
Result<void> addFamily(const BenchSpreadArguments& arguments, const std::filesystem::path& folder,
                       SpreadOptions& options) {
  const auto files =
      writeFamilies({*arguments.family}, {.seeds = options.seeds, .scale = arguments.scale}, folder);
  if (!files) {
    return tl::unexpected(files.error());
  }
  // Seeds count from 1.
  options.sceneOf = [files = *files](std::uint64_t seed) {
    return files[static_cast<std::size_t>(seed) - 1].string();
  };
  return {};
}

Result<void> addBudgets(const BenchSpreadArguments& arguments, const std::string& scene,
                        SpreadOptions& options) {
  if (arguments.floors.empty()) {
    return {};
  }
  auto governed = makeBenchRun(arguments.bench, scene, "hybrid");
  auto coarsest = makeBenchRun(arguments.bench, scene, "coarsest");
  if (!governed || !coarsest) {
    return tl::unexpected((governed ? coarsest : governed).error());
  }
  governed->fidelityEvery = arguments.fidelityEvery.value_or(0);
  options.budgets = {
      .governed = std::move(*governed), .coarsest = std::move(*coarsest), .floors = arguments.floors};
  return {};
}

Result<SpreadOptions> makeStudy(const BenchSpreadArguments& arguments, const std::filesystem::path& folder) {
  SpreadOptions options;
  options.seeds = seedsUpTo(arguments.seeds);
  if (arguments.family) {
    if (auto added = addFamily(arguments, folder, options); !added) {
      return tl::unexpected(added.error());
    }
  }
  const std::string scene = arguments.family ? options.sceneOf(1) : arguments.scene;
  for (const std::string& world : arguments.worlds) {
    auto run = makeBenchRun(arguments.bench, scene, world);
    if (!run) {
      return tl::unexpected(run.error());
    }
    run->fidelityEvery = arguments.fidelityEvery.value_or(0);
    options.worlds.push_back(std::move(*run));
  }
  if (auto added = addBudgets(arguments, scene, options); !added) {
    return tl::unexpected(added.error());
  }
  return options;
}

Result<void> checkMeaning(const CLI::App& command) {
  if (command.count("--scale") > 0 && command.count("--family") == 0) {
    return fail("--scale has no meaning here; it goes with --family");
  }
  if (command.count("--scene") > 0 && command.count("--family") > 0) {
    return fail("--scene and --family exclude each other; leave one of them out");
  }
  return {};
}

ExitStatus study(const CLI::App& command, const BenchSpreadArguments& arguments) {
  if (auto meaningful = checkMeaning(command); !meaningful) {
    return refuse(meaningful.error());
  }
  const auto folder = makeFamilyFolder(arguments.family.has_value());
  if (!folder) {
    return refuse(folder.error());
  }
  const auto options = makeStudy(arguments, *folder ? (*folder)->path() : std::filesystem::path());
  if (!options) {
    return refuse(options.error());
  }
  if (auto writable = prepareCsv(arguments.bench); !writable) {
    return refuse(writable.error());
  }
  const auto result =
      studySpread(*options, benchProgress(arguments.bench, arguments.family.value_or(arguments.scene)));
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
      ->add_option(
          "--family", arguments->family,
          "In the place of --scene: for each seed another scene of this family, as `scatter families` "
          "writes them")
      ->type_name("NAME");
  addScaleArgument(*command, arguments->scale);
  command
      ->add_option("--worlds", arguments->worlds, "What to compare; the first one's extremes are the measure")
      ->type_name("NAME,NAME")
      ->delimiter(',')
      ->capture_default_str();
  command
      ->add_option("--floors", arguments->floors,
                   "Then the hybrid world with budgets that are these multiples of what a scene's dearest "
                   "frame takes with everything at level 1, in units")
      ->check(CLI::Range(0.01, 1000.0))
      ->type_name("X,X")
      ->delimiter(',');
  addFidelityArgument(*command, arguments->fidelityEvery);
  command->add_option("--seeds", arguments->seeds, "Seeds from 1 to this")
      ->check(CLI::Range(1, 1000))
      ->type_name("N")
      ->capture_default_str();
  addBenchArguments(*command, arguments->bench);
  return {command, [command, arguments] { return study(*command, *arguments); }};
}

}  // namespace scatter::app
