#include <scatter/io/file.h>
#include <scatter/lab/fidelity_study.h>
#include <scatter/lab/output_folder.h>
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
  std::optional<int> fidelityEvery;
  std::optional<std::string> out;
};

// Full detail first: what budgets are compared to.
Result<CompareOptions> makeComparison(const BenchFidelityArguments& arguments) {
  std::vector<std::string> worlds{"finest"};
  for (const std::string& budget : arguments.budgets) {
    worlds.push_back("hybrid@" + budget + "ms");
  }
  CompareOptions options{.repeat = arguments.repeat};
  for (const std::string& world : worlds) {
    auto run = makeBenchRun(arguments.bench, arguments.scene, world);
    if (!run) {
      return tl::unexpected(run.error());
    }
    run->fidelityEvery = arguments.fidelityEvery.value_or(kFidelityEvery);
    options.runs.push_back(std::move(*run));
  }
  return options;
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
  return status;
}

}  // namespace

Command addBenchFidelityCommand(CLI::App& bench) {
  CLI::App* command = bench.add_subcommand(
      "fidelity",
      "How true contacts are at several budgets, as numbers and a figure of fidelity against budget");
  auto arguments = std::make_shared<BenchFidelityArguments>();
  command->add_option("SCENE", arguments->scene, "The scene's name, as `scatter list` shows it")->required();
  command->add_option("--budgets", arguments->budgets, "Milliseconds that a frame's physics is governed to")
      ->type_name("MS,MS…")
      ->delimiter(',')
      ->capture_default_str();
  addRepeatArgument(*command, arguments->repeat);
  addFidelityArgument(*command, arguments->fidelityEvery);
  command->add_option("--out", arguments->out, "The folder for numbers and figure [out/SCENE-fidelity]")
      ->type_name("DIR");
  addBenchArguments(*command, arguments->bench);
  return {command, [arguments] { return study(*arguments); }};
}

}  // namespace scatter::app
