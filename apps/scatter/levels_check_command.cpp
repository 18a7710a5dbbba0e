#include <scatter/levels/level_check.h>
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

#include "command.h"
#include "level_file.h"
#include "level_report.h"
#include "mesh_arguments.h"
#include "messages.h"
#include "number_checks.h"

namespace scatter::app {

namespace {

struct LevelsCheckArguments {
  std::string file;
  std::string mesh;
  MeshArguments reading;
  std::optional<double> tolerance;
};

/// One model; the mesh is the user's, the model's own, or none.
Result<bool> checkModel(const LevelModel& model, const SurfaceMesh& mesh, const LevelCheckDef& definition) {
  std::vector<Level> levels;
  for (int i = 1; i <= model.levels->count(); ++i) levels.push_back(model.levels->level(i));
  const Result<LevelCheck> check =
      checkLevels(levels, model.levels->hullMargin(), mesh.triangles.empty() ? nullptr : &mesh, definition);
  if (!check) return fail(model.name + ": " + check.error().message);
  fmt::print("{}: {} levels, tolerance {}{}\n{}", model.name, levels.size(), lengthText(check->tolerance),
             mesh.triangles.empty() ? ", no mesh to check" : "", describe(*check, model.levels->count()));
  return check->passed();
}

ExitStatus run(const LevelsCheckArguments& arguments) {
  const auto models = readLevelFile(arguments.file);
  if (!models) return refuse(models.error());
  std::optional<MeshFile> mesh;
  if (!arguments.mesh.empty()) {
    Result<MeshFile> read = readMesh(arguments.mesh, arguments.reading);
    if (!read) return refuse(read.error());
    if (models->size() > 1) {
      printError(
          fmt::format("{}: has {} models; --mesh can stand for one only", arguments.file, models->size()));
      return ExitStatus::kBadInput;
    }
    printNotes(read->warnings);
    mesh = std::move(*read);
  }
  bool passed = true;
  for (const LevelModel& model : *models) {
    const Result<bool> one =
        checkModel(model, mesh ? mesh->mesh : model.mesh, {.tolerance = arguments.tolerance});
    if (!one) return refuse(Error{arguments.file + ": " + one.error().message});
    passed = passed && *one;
  }
  if (!passed) printError(arguments.file + ": the levels do not enclose what they should; see above");
  return passed ? ExitStatus::kOk : ExitStatus::kFailed;
}

}  // namespace

Command addLevelsCheckCommand(CLI::App& levels) {
  CLI::App* command = levels.add_subcommand(
      "check",
      "Prove that the mesh lies in the finest level and each level in the coarser one, or say where not");
  auto arguments = std::make_shared<LevelsCheckArguments>();
  command->add_option("FILE", arguments->file, "COLLADA or glTF physics file with levels")->required();
  command->add_option("--mesh", arguments->mesh, "Check this mesh instead of the one in FILE")
      ->type_name("MESH");
  addMeshArguments(*command, arguments->reading);
  command
      ->add_option("--tolerance", arguments->tolerance,
                   "Metres by which something may stick out [a hundred-thousandth of the diagonal]")
      ->check(numberAbove(0.0))
      ->type_name("M");
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace scatter::app
