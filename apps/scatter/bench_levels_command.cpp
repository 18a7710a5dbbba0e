#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench_arguments.h"
#include "interrupt.h"
#include "level_bench.h"
#include "mesh_arguments.h"
#include "number_checks.h"
#include "progress_line.h"

namespace scatter::app {

namespace {

struct BenchLevelsArguments {
  std::vector<std::string> meshes;
  MeshArguments reading;
  std::optional<std::string> csv;
  std::optional<std::string> piles;
  int repeat = 3;
  int seconds = 120;
  bool othersOnly = false;
  std::vector<std::string> programs;
  bool quiet = false;
};

std::optional<int> countIn(const std::string& text) {
  const auto count = parseNumber<int>(text);
  return count && *count > 0 ? count : std::nullopt;
}

/// NAME[@PARTS[xVERTICES]]=COMMAND.
Result<LevelMethod> parseProgram(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::string asked = text.substr(0, equals);
  const std::size_t at = asked.find('@');
  const std::size_t times = at == std::string::npos ? at : asked.find('x', at);
  const std::string parts = at == std::string::npos ? "64" : asked.substr(at + 1, times - at - 1);
  const std::optional<int> count = countIn(parts);
  const std::optional<int> vertices = times == std::string::npos ? 0 : countIn(asked.substr(times + 1));
  const bool hasPlaces =
      text.find("{mesh}") != std::string::npos && text.find("{hulls}") != std::string::npos;
  if (equals == std::string::npos || asked.substr(0, at).empty() || !count || !vertices || !hasPlaces) {
    return fail("--program: \"" + text +
                "\" is not understood; give NAME=COMMAND, NAME@PARTS=COMMAND or NAME@PARTSxVERTICES=COMMAND, "
                "with {mesh} and {hulls} in the command");
  }
  return LevelMethod{
      asked.substr(0, at), {*count}, *vertices, *vertices == 0 && *count == 64, text.substr(equals + 1)};
}

Result<LevelBenchDef> makeDefinition(const BenchLevelsArguments& arguments) {
  LevelBenchDef definition;
  if (!arguments.othersOnly) definition.methods = ownLevelMethods();
  for (const std::string& text : arguments.programs) {
    auto program = parseProgram(text);
    if (!program) return tl::unexpected(program.error());
    definition.methods.push_back(std::move(*program));
  }
  if (definition.methods.empty()) return fail("--others-only leaves nothing to measure without --program");
  definition.piles = arguments.piles.has_value();
  definition.repeat = arguments.repeat;
  definition.limitSeconds = arguments.seconds;
  auto line = std::make_shared<ProgressLine>(arguments.quiet);
  definition.tick = throwIfInterrupted;
  definition.piling = [line](const CompareProgress& progress) {
    throwIfInterrupted();
    line->update(fmt::format("pile of {}, run {} of {}", progress.label, progress.run + 1, progress.runs),
                 progress.inside);
  };
  return definition;
}

Result<std::vector<MeshFile>> readMeshes(const BenchLevelsArguments& arguments) {
  std::vector<MeshFile> files;
  for (const std::string& path : arguments.meshes) {
    auto file = readMesh(path, arguments.reading);
    if (!file) return tl::unexpected(file.error());
    files.push_back(std::move(*file));
  }
  return files;
}

Result<void> prepareFiles(const BenchLevelsArguments& arguments) {
  auto prepared = prepareCsv("--csv", arguments.csv);
  return prepared ? prepareCsv("--piles", arguments.piles) : prepared;
}

/// After each mesh: a study of many takes long, and may be ended before the last.
Result<void> writeTables(const BenchLevelsArguments& arguments, const LevelBenchTables& tables) {
  auto written = putCsv(arguments.csv, tables.levels);
  return written ? putCsv(arguments.piles, tables.piles) : written;
}

void sayWhereTablesAre(const BenchLevelsArguments& arguments) {
  if (arguments.csv) fmt::print("the levels: {}\n", *arguments.csv);
  if (arguments.piles) fmt::print("the piles: {}\n", *arguments.piles);
}

ExitStatus measureLevelsOf(const BenchLevelsArguments& arguments) {
  const auto definition = makeDefinition(arguments);
  if (!definition) return refuse(definition.error());
  const auto files = readMeshes(arguments);
  if (!files) return refuse(files.error());
  if (auto prepared = prepareFiles(arguments); !prepared) return refuse(prepared.error());
  LevelBenchTables tables;
  const auto print = [](const std::string& line) {
    fmt::print("{}\n", line);
    std::fflush(stdout);
  };
  for (const MeshFile& file : *files) {
    if (auto measured = benchLevels(file, *definition, tables, print); !measured)
      return failed(measured.error());
    if (auto written = writeTables(arguments, tables); !written) return refuse(written.error());
  }
  sayWhereTablesAre(arguments);
  return tables.passed ? ExitStatus::kOk : ExitStatus::kFailed;
}

}  // namespace

Command addBenchLevelsCommand(CLI::App& bench) {
  CLI::App* command = bench.add_subcommand(
      "levels",
      "How close levels are to their mesh, what they cost in a pile, and others' parts beside them");
  auto arguments = std::make_shared<BenchLevelsArguments>();
  command->add_option("MESH", arguments->meshes, "Mesh files")->required()->type_name("MESH");
  addMeshArguments(*command, arguments->reading);
  command->add_option("--csv", arguments->csv, "Write a row for each level into this file")
      ->type_name("FILE");
  command
      ->add_option("--piles", arguments->piles,
                   "Let thirty bodies of 32 and of 64 parts fall into a pit, in plain Bullet and in ours, "
                   "and write into this file what a step of the heap costs")
      ->type_name("FILE");
  addRepeatArgument(*command, arguments->repeat);
  command
      ->add_option("--program", arguments->programs,
                   "NAME=COMMAND, of a program that is installed: the shell runs it in an empty folder; it "
                   "reads {mesh} and writes {hulls}, .obj files, the second with an object for each hull. "
                   "NAME@PARTSxVERTICES=COMMAND fills in {parts}, else 64, and {vertices}, else 0. Several "
                   "times for several programs")
      ->allow_extra_args(false)
      ->type_name("NAME=COMMAND");
  command->add_flag("--others-only", arguments->othersOnly, "Only what programs make");
  command->add_option("--seconds", arguments->seconds, "Processor time for each decomposition by a program")
      ->check(wholeNumber<int>(1))
      ->type_name("S")
      ->capture_default_str();
  command->add_flag("--quiet", arguments->quiet, "No progress on standard error");
  return {command, [arguments] { return measureLevelsOf(*arguments); }};
}

}  // namespace scatter::app
