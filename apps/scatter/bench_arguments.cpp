#include "bench_arguments.h"

#include <scatter/io/file.h>
#include <scatter/lab/output_folder.h>
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <numeric>
#include <utility>

#include "interrupt.h"
#include "number_checks.h"
#include "progress_line.h"
#include "run_arguments.h"

namespace scatter::app {

void addBenchArguments(CLI::App& command, BenchArguments& arguments) {
  command.add_option("--frames", arguments.frames, "Steps of 1/60 s [as many as the scene's story takes]")
      ->check(wholeNumber<int>(1))
      ->type_name("N");
  command.add_option("--csv", arguments.csv, "Write the numbers into this file")->type_name("FILE");
  command.add_flag("--quiet", arguments.quiet, "No progress on standard error");
}

void addRepeatArgument(CLI::App& command, int& repeat) {
  command.add_option("--repeat", repeat, "Runs of each world, interleaved; figures are medians over them")
      ->check(CLI::Range(1, 1000))
      ->type_name("N")
      ->capture_default_str();
}

void addSceneArgument(CLI::App& command, std::string& scene) {
  command.add_option("--scene", scene, "The scene's name, as `scatter list` shows it, or a file")
      ->type_name("NAME")
      ->capture_default_str();
}

Result<RunOptions> makeBenchRun(const BenchArguments& arguments, const std::string& scene,
                                const std::string& world) {
  RunArguments run;
  run.scene = scene;
  run.frames = arguments.frames;
  auto runs = makeRuns(run, {world});
  if (!runs) {
    return tl::unexpected(runs.error());
  }
  return std::move(runs->front());
}

std::vector<std::uint64_t> seedsUpTo(int count) {
  std::vector<std::uint64_t> seeds(static_cast<std::size_t>(count));
  std::iota(seeds.begin(), seeds.end(), std::uint64_t{1});
  return seeds;
}

Result<void> prepareCsv(const BenchArguments& arguments) {
  return prepareCsv("--csv", arguments.csv);
}

Result<void> prepareCsv(const std::string& name, const std::optional<std::string>& csv) {
  if (!csv) {
    return {};
  }
  const std::filesystem::path file(*csv);
  if (!file.has_filename() || std::filesystem::is_directory(file)) {
    return fail(name + " \"" + *csv + "\" does not name a file; give it a name such as table.csv");
  }
  return prepareOutputFolder(file.has_parent_path() ? file.parent_path() : ".");
}

Result<void> putCsv(const std::optional<std::string>& csv, const std::string& text) {
  if (!csv) {
    return {};
  }
  const std::filesystem::path file(*csv);
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  return writeFile(file, text);
}

ExitStatus writeCsv(const std::optional<std::string>& csv, const std::string& what, const std::string& text) {
  if (!csv) {
    return ExitStatus::kOk;
  }
  if (auto written = putCsv(csv, text); !written) {
    return refuse(written.error());
  }
  fmt::print("{}: {}\n", what, *csv);
  return ExitStatus::kOk;
}

ExitStatus report(const BenchArguments& arguments, const std::string& table, const std::string& csv) {
  fmt::print("{}", table);
  return writeCsv(arguments.csv, "the numbers", csv);
}

std::function<void(const CompareProgress&)> benchProgress(const BenchArguments& arguments, std::string work) {
  auto line = std::make_shared<ProgressLine>(arguments.quiet);
  return [line = std::move(line), work = std::move(work)](const CompareProgress& progress) {
    throwIfInterrupted();
    line->update(fmt::format("{}, {}, run {} of {}", work, progress.label, progress.run + 1, progress.runs),
                 progress.inside);
  };
}

}  // namespace scatter::app
