#include <scatter/lab/output_folder.h>
#include <scatter/lab/world_figures.h>
#include <scatter/world/scene.h>
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <vector>

#include "bench_arguments.h"
#include "family_arguments.h"
#include "interrupt.h"
#include "progress_line.h"
#include "run_arguments.h"
#include "world_spec.h"

namespace scatter::app {

namespace {

constexpr const char* kAllScenes = "all";
constexpr const char* kFamilies = "families";

struct BenchWorldsArguments {
  BenchArguments bench;
  FamilyArguments families;
  std::vector<std::string> scenes{kAllScenes};
  std::vector<std::string> worlds{"standard", "finest"};
  int repeat = 3;
  std::optional<int> fidelityEvery;
};

bool asksForFamilies(const BenchWorldsArguments& arguments) {
  return std::find(arguments.scenes.begin(), arguments.scenes.end(), kFamilies) != arguments.scenes.end();
}

// Families are written into the folder.
Result<std::vector<std::string>> scenesOf(const BenchWorldsArguments& arguments,
                                          const std::filesystem::path& folder) {
  std::vector<std::string> names;
  if (arguments.scenes == std::vector<std::string>{kAllScenes}) {
    for (const auto& scene : SceneRegistry::instance().all()) {
      names.push_back(scene->name);
    }
    return names;
  }
  for (const std::string& scene : arguments.scenes) {
    if (scene != kFamilies) {
      names.push_back(scene);
      continue;
    }
    const auto files = writeFamilies(familyNames(), arguments.families, folder);
    if (!files) {
      return tl::unexpected(files.error());
    }
    names.insert(names.end(), files->begin(), files->end());
  }
  return names;
}

Result<std::vector<CompareOptions>> makeComparisons(const BenchWorldsArguments& arguments,
                                                    const std::filesystem::path& folder) {
  const auto scenes = scenesOf(arguments, folder);
  if (!scenes) {
    return tl::unexpected(scenes.error());
  }
  std::vector<CompareOptions> comparisons;
  for (const std::string& scene : *scenes) {
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

ExitStatus measure(const CLI::App& command, const BenchWorldsArguments& arguments) {
  const std::string asks = std::string("--scenes ") + kFamilies;
  if (auto meaningful = checkFamilyArguments(command, asksForFamilies(arguments), asks); !meaningful) {
    return refuse(meaningful.error());
  }
  // Families take seconds to be written.
  for (const std::string& world : arguments.worlds) {
    if (auto known = parseWorld(world); !known) {
      return refuse(known.error());
    }
  }
  const auto folder = makeFamilyFolder(asksForFamilies(arguments));
  if (!folder) {
    return refuse(folder.error());
  }
  const auto comparisons = makeComparisons(arguments, *folder ? (*folder)->path() : std::filesystem::path());
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
  command
      ->add_option("--scenes", arguments->scenes,
                   "Where to measure; all: every registered scene; families: those that `scatter "
                   "families` writes")
      ->type_name("NAME,NAME")
      ->delimiter(',')
      ->capture_default_str();
  command
      ->add_option("--worlds", arguments->worlds,
                   "What to compare, the first being what the others are compared to; see `scatter list`")
      ->type_name("NAME,NAME")
      ->delimiter(',')
      ->capture_default_str();
  addFamilyArguments(*command, arguments->families);
  addRepeatArgument(*command, arguments->repeat);
  addFidelityArgument(*command, arguments->fidelityEvery);
  addBenchArguments(*command, arguments->bench);
  return {command, [command, arguments] { return measure(*command, *arguments); }};
}

}  // namespace scatter::app
