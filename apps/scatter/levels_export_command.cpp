#include <scatter/io/level_export.h>
#include <scatter/io/model_file.h>
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <memory>
#include <string>

#include "command.h"
#include "messages.h"
#include "number_checks.h"

namespace scatter::app {

namespace {

struct LevelsExportArguments {
  std::string file;
  std::string body;
  std::string output;
  int level = 0;  ///< 0: the finest.
};

using WriteLevel = Result<void> (*)(const Model& model, int level, const std::filesystem::path& path);

struct ExportFormat {
  const char* extension;
  WriteLevel write;
};

constexpr std::array<ExportFormat, 3> kExportFormats{
    {{".obj", writeObj}, {".urdf", writeUrdf}, {".xml", writeMjcf}}};

Result<WriteLevel> writerOf(const std::string& path) {
  const std::filesystem::path file(path);
  for (const ExportFormat& format : kExportFormats) {
    if (file.extension() == format.extension) return format.write;
  }
  return fail(
      "--output: " + path +
      " tells no format; its name should end in .obj, .urdf or .xml (MuJoCo); scatter convert writes .dae, "
      ".gltf and .glb");
}

ExitStatus run(const LevelsExportArguments& arguments) {
  const Result<WriteLevel> write = writerOf(arguments.output);
  if (!write) return refuse(write.error());
  const Result<FileModel> file = readModelFile(arguments.file, arguments.body);
  if (!file) return refuse(file.error());
  printNotes(file->warnings);
  const Model& model = file->model;
  const int level = arguments.level > 0 ? arguments.level : model.levels->count();
  if (auto written = (*write)(model, level, arguments.output); !written) return refuse(written.error());
  fmt::print("{}: level {} of {}, {} parts, {:.6g} kg: written\n", arguments.output, level, model.name,
             model.levels->level(level).parts.size(), model.mass);
  return ExitStatus::kOk;
}

}  // namespace

Command addLevelsExportCommand(CLI::App& levels) {
  CLI::App* command = levels.add_subcommand(
      "export", "Write one level for programs that know no levels: OBJ, URDF or MuJoCo's MJCF");
  auto arguments = std::make_shared<LevelsExportArguments>();
  command->add_option("FILE", arguments->file, "COLLADA or glTF physics file with levels")->required();
  command
      ->add_option(
          "-o,--output", arguments->output,
          "File to write: .obj, an object for each part; .urdf, and a folder of meshes beside it; .xml, MJCF")
      ->required()
      ->type_name("FILE");
  command->add_option("--level", arguments->level, "Which one, 1 the coarsest [the finest]")
      ->check(wholeNumber(1))
      ->type_name("N");
  command->add_option("--body", arguments->body, "Which body, if FILE has several")->type_name("NAME");
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace scatter::app
