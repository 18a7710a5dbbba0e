#include <scatter/lab/budget_study.h>
#include <scatter/lab/recorded_machine.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench_arguments.h"
#include "family_arguments.h"
#include "world_spec.h"

namespace scatter::app {

namespace {

struct BenchBudgetArguments {
  BenchArguments bench;
  FamilyArguments drawn;
  std::vector<std::string> scenes;
  std::vector<std::uint64_t> sceneSeeds;
  std::vector<std::string> families;
  std::vector<double> floors{1.2, 1.5, 2.0, 3.0};
  std::string world = "hybrid";
  bool byClock = false;
  std::optional<std::string> machine;
  double cut = 0.0;
  int cutFrames = 0;
  std::optional<std::string> over;
};

std::string nameOf(const std::string& scene) {
  return std::filesystem::path(scene).stem().string();
}

bool drawsFamilies(const BenchBudgetArguments& arguments) {
  return arguments.scenes.empty() || !arguments.families.empty();
}

// Without a seed it has its own.
struct SeededScene {
  std::string scene;
  std::optional<std::uint64_t> seed{};
};

std::vector<SeededScene> namedScenes(const BenchBudgetArguments& arguments) {
  std::vector<SeededScene> scenes;
  for (const std::string& scene : arguments.scenes) {
    if (arguments.sceneSeeds.empty()) {
      scenes.push_back({scene});
    }
    for (const std::uint64_t seed : arguments.sceneSeeds) {
      scenes.push_back({scene, seed});
    }
  }
  return scenes;
}

// Those that were named, and of each family one for each seed, written into the folder.
Result<std::vector<SeededScene>> scenesOf(const BenchBudgetArguments& arguments,
                                          const std::filesystem::path& folder) {
  std::vector<SeededScene> scenes = namedScenes(arguments);
  if (!drawsFamilies(arguments)) {
    return scenes;
  }
  const auto files =
      writeFamilies(arguments.families.empty() ? familyNames() : arguments.families, arguments.drawn, folder);
  if (!files) {
    return tl::unexpected(files.error());
  }
  for (const std::filesystem::path& file : *files) {
    scenes.push_back({file});
  }
  return scenes;
}

// Scenes are called after their seed if they were given one.
Result<BudgetScene> makeScene(const BenchBudgetArguments& arguments, const SeededScene& scene) {
  auto governed = makeBenchRun(arguments.bench, scene.scene, arguments.world);
  if (!governed) {
    return tl::unexpected(governed.error());
  }
  std::string name = nameOf(scene.scene);
  if (scene.seed) {
    governed->seed = scene.seed;
    name += "-" + std::to_string(*scene.seed);
  }
  auto resolved = resolveRun(*governed);
  if (!resolved) {
    return tl::unexpected(resolved.error());
  }
  RunOptions coarsest = *resolved;
  coarsest.physics.switching.policy = Policy::kCoarsest;
  return BudgetScene{.name = std::move(name),
                     .governed = std::move(*resolved),
                     .coarsest = std::move(coarsest),
                     .drawn = scene.seed ? nameOf(scene.scene) : std::string()};
}

Result<BudgetStudyOptions> makeStudy(const BenchBudgetArguments& arguments,
                                     const std::filesystem::path& folder) {
  BudgetStudyOptions options{.floors = arguments.floors,
                             .byClock = arguments.byClock || arguments.machine,
                             .cut = arguments.cut,
                             .cutFrames = arguments.cutFrames};
  // Families take seconds to be written.
  if (arguments.machine) {
    auto machine = readMachine(*arguments.machine);
    if (!machine) {
      return fail("--machine: " + machine.error().message);
    }
    options.machine = std::move(*machine);
  }
  const auto scenes = scenesOf(arguments, folder);
  if (!scenes) {
    return tl::unexpected(scenes.error());
  }
  for (const SeededScene& scene : *scenes) {
    auto made = makeScene(arguments, scene);
    if (!made) {
      return tl::unexpected(made.error());
    }
    options.scenes.push_back(std::move(*made));
  }
  return options;
}

Result<void> checkMeaning(const CLI::App& command, const BenchBudgetArguments& arguments) {
  if (arguments.byClock && arguments.machine) {
    return fail("--machine is in the place of the --clock; give one of them");
  }
  if ((arguments.byClock || arguments.machine) && arguments.cut > 0.0) {
    return fail(std::string("--cut has no meaning with ") + (arguments.byClock ? "--clock" : "--machine") +
                ": it is for budgets in units");
  }
  if (arguments.cutFrames > 0 && !(arguments.cut > 0.0)) {
    return fail("--cut-frames says how long --cut holds; give both");
  }
  if (!arguments.sceneSeeds.empty() && arguments.scenes.empty()) {
    return fail("--scene-seeds are those of --scenes; give both, or --seeds for families");
  }
  // Families take seconds to be written.
  if (auto world = parseWorld(arguments.world); !world) {
    return tl::unexpected(world.error());
  }
  return checkFamilyArguments(command, drawsFamilies(arguments), "--families (--scenes have --scene-seeds)");
}

ExitStatus study(const CLI::App& command, const BenchBudgetArguments& arguments) {
  if (auto meaningful = checkMeaning(command, arguments); !meaningful) {
    return refuse(meaningful.error());
  }
  const auto folder = makeFamilyFolder(drawsFamilies(arguments));
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
  if (auto writable = prepareCsv("--over", arguments.over); !writable) {
    return refuse(writable.error());
  }
  const auto result = studyBudgets(*options, benchProgress(arguments.bench, "budgets"));
  if (!result) {
    return failed(result.error());
  }
  const ExitStatus reported = report(arguments.bench, formatBudgets(*result), budgetsCsv(*result));
  const ExitStatus told =
      writeCsv(arguments.over, "the frames over their budget", budgetOverrunsCsv(*result));
  return reported == ExitStatus::kOk ? told : reported;
}

}  // namespace

Command addBenchBudgetCommand(CLI::App& bench) {
  CLI::App* command = bench.add_subcommand(
      "budget", "Are budgets kept? Multiples of what each scene takes with everything at level 1");
  auto arguments = std::make_shared<BenchBudgetArguments>();
  command->add_option("--scenes", arguments->scenes, "Scenes and files [all families]")
      ->type_name("NAME,NAME")
      ->delimiter(',');
  command
      ->add_option("--scene-seeds", arguments->sceneSeeds,
                   "Each of --scenes for each of these seeds [its own]")
      ->check(wholeNumber<std::uint64_t>(0))
      ->type_name("N,N")
      ->delimiter(',');
  command
      ->add_option("--families", arguments->families,
                   "Families of scenes, as `scatter families` writes them [all]")
      ->type_name("NAME,NAME")
      ->delimiter(',');
  addFamilyArguments(*command, arguments->drawn);
  command
      ->add_option("--floors", arguments->floors,
                   "Budgets, as multiples of what the scene's dearest frame takes with everything at level 1")
      ->check(CLI::Range(0.01, 1000.0))
      ->type_name("X,X")
      ->delimiter(',')
      ->capture_default_str();
  command->add_option("--world", arguments->world, "The world that is given budgets; see `scatter list`")
      ->type_name("NAME")
      ->capture_default_str();
  command->add_flag("--clock", arguments->byClock,
                    "Budgets of milliseconds [of units, the same run after run]");
  command
      ->add_option("--machine", arguments->machine,
                   "Budgets of milliseconds on a machine that was recorded, in the place of the clock, the "
                   "same run after run: a CSV file with ms_per_unit, or the frames.csv of a run")
      ->type_name("FILE");
  command->add_option("--cut", arguments->cut, "From the middle of each run on its budget is divided by this")
      ->check(CLI::Range(1.0, 1000.0))
      ->type_name("X");
  command
      ->add_option("--cut-frames", arguments->cutFrames,
                   "The cut ends after so many frames, and it is measured when detail is back [to the end]")
      ->check(wholeNumber<int>(1))
      ->type_name("N");
  command
      ->add_option("--over", arguments->over,
                   "Write the frames that took more than 1.02 of their budget into this file")
      ->type_name("FILE");
  addBenchArguments(*command, arguments->bench);
  return {command, [command, arguments] { return study(*command, *arguments); }};
}

}  // namespace scatter::app
