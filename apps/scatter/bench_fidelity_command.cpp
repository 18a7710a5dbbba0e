#include <scatter/io/file.h>
#include <scatter/lab/fidelity_study.h>
#include <scatter/lab/output_folder.h>
#include <scatter/lab/spread_study.h>
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

#include "bench_arguments.h"
#include "run_arguments.h"

namespace scatter::app {

namespace {

struct BenchFidelityArguments {
  BenchArguments bench;
  std::string scene;
  std::vector<std::string> budgets{"2", "3", "5", "8", "12"};
  int repeat = 1;
  int seeds = 3;
  std::optional<int> fidelityEvery;
  std::optional<std::string> out;
};

Result<std::vector<RunOptions>> makeWorlds(const BenchFidelityArguments& arguments, const char* first) {
  std::vector<std::string> names{first};
  for (const std::string& budget : arguments.budgets) {
    names.push_back("hybrid@" + budget + "ms");
  }
  std::vector<RunOptions> worlds;
  for (const std::string& name : names) {
    auto run = makeBenchRun(arguments.bench, arguments.scene, name);
    if (!run) {
      return tl::unexpected(run.error());
    }
    worlds.push_back(std::move(*run));
  }
  return worlds;
}

// Full detail first: what budgets are compared to.
Result<CompareOptions> makeComparison(const BenchFidelityArguments& arguments) {
  auto worlds = makeWorlds(arguments, "finest");
  if (!worlds) {
    return tl::unexpected(worlds.error());
  }
  for (RunOptions& run : *worlds) {
    run.fidelityEvery = arguments.fidelityEvery.value_or(kFidelityEvery);
  }
  return CompareOptions{.runs = std::move(*worlds), .repeat = arguments.repeat};
}

// The plain engine first: by how much its piles differ from seed to seed is the measure for all others.
Result<ExitStatus> studyPiles(const BenchFidelityArguments& arguments, const std::filesystem::path& out) {
  if (arguments.seeds == 0) {
    return ExitStatus::kOk;
  }
  auto worlds = makeWorlds(arguments, "standard");
  if (!worlds) {
    return tl::unexpected(worlds.error());
  }
  const auto piles = studySpread({.worlds = std::move(*worlds), .seeds = seedsUpTo(arguments.seeds)},
                                 benchProgress(arguments.bench, arguments.scene));
  if (!piles) {
    return tl::unexpected(piles.error());
  }
  fmt::print("\n{}the piles:   {}/spread.csv\n", formatSpread(*piles), out.string());
  if (auto written = writeFile(out / "spread.csv", spreadCsv(*piles)); !written) {
    return refuse(written.error());
  }
  return ExitStatus::kOk;
}

Result<void> prepare(const BenchFidelityArguments& arguments, const std::string& out) {
  return checkGnuplot().and_then([&] { return prepareOutputFolder(out); }).and_then([&] {
    return prepareCsv(arguments.bench);
  });
}

// The figure first: it makes the folder.
Result<void> write(const std::vector<WorldFigures>& worlds, const std::filesystem::path& out) {
  const auto figure = drawFidelity(worlds, out);
  if (!figure) {
    return tl::unexpected(figure.error());
  }
  fmt::print("the figure:  {}/{}.svg\n", out.string(), figure->name);
  fmt::print("the numbers: {}/fidelity.csv\n", out.string());
  return writeFile(out / "fidelity.csv", worldFiguresCsv(worlds));
}

ExitStatus study(const BenchFidelityArguments& arguments) {
  const auto options = makeComparison(arguments);
  if (!options) {
    return refuse(options.error());
  }
  const std::string out = arguments.out.value_or("out/" + arguments.scene + "-fidelity");
  if (auto prepared = prepare(arguments, out); !prepared) {
    return refuse(prepared.error());
  }
  bool started = false;
  const auto comparison = [&] {
    const auto progress = benchProgress(arguments.bench, arguments.scene);
    return compareWorlds(*options, [&](const CompareProgress& inside) {
      started = true;
      progress(inside);
    });
  }();
  if (!comparison) {
    return started ? failed(comparison.error()) : refuse(comparison.error());
  }
  const std::vector<WorldFigures> worlds = worldFigures(*comparison);
  const ExitStatus status = report(arguments.bench, formatWorldFigures(worlds), worldFiguresCsv(worlds));
  if (auto written = write(worlds, out); !written) {
    return refuse(written.error());
  }
  const auto piles = studyPiles(arguments, out);
  if (!piles) {
    return failed(piles.error());
  }
  return *piles == ExitStatus::kOk ? status : *piles;
}

}  // namespace

Command addBenchFidelityCommand(CLI::App& bench) {
  CLI::App* command = bench.add_subcommand(
      "fidelity",
      "How true contacts are at several budgets, as numbers and a figure of fidelity against budget");
  auto arguments = std::make_shared<BenchFidelityArguments>();
  command->add_option("SCENE", arguments->scene, "The scene's name, as `scatter list` shows it")->required();
  command->add_option("--budgets", arguments->budgets, "Milliseconds that a frame's physics is governed to")
      ->type_name("MS,MS")
      ->delimiter(',')
      ->capture_default_str();
  addRepeatArgument(*command, arguments->repeat);
  command
      ->add_option(
          "--seeds", arguments->seeds,
          "Seeds over which the pile's size and energy are compared with the standard world's; 0: not")
      ->check(CLI::Range(0, 1000))
      ->type_name("N")
      ->capture_default_str();
  addFidelityArgument(*command, arguments->fidelityEvery);
  command->add_option("--out", arguments->out, "The folder for numbers and figure [out/SCENE-fidelity]")
      ->type_name("DIR");
  addBenchArguments(*command, arguments->bench);
  return {command, [arguments] { return study(*arguments); }};
}

}  // namespace scatter::app
