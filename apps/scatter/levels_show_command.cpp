#include <scatter/io/file.h>
#include <scatter/levels/measure_levels.h>
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "command.h"
#include "lab/level_picture.h"
#include "level_arguments.h"
#include "level_file.h"
#include "level_report.h"
#include "mesh_arguments.h"
#include "messages.h"

namespace scatter::app {

namespace {

struct LevelsShowArguments {
  std::string file;
  std::string mesh;
  MeshArguments reading;
  std::string interior = "automatic";
  std::string json;
  std::string picture;
};

/// Gives the only model another mesh, if the user did.
Result<std::vector<LevelModel>> readModels(const LevelsShowArguments& arguments) {
  auto models = readLevelFile(arguments.file);
  if (!models || arguments.mesh.empty()) return models;
  if (models->size() > 1) {
    return fail(
        fmt::format("{}: has {} models; --mesh can stand for one only", arguments.file, models->size()));
  }
  Result<MeshFile> mesh = readMesh(arguments.mesh, arguments.reading);
  if (!mesh) return fail(mesh.error().message);
  printNotes(mesh->warnings);
  models->front().mesh = std::move(mesh->mesh);
  return models;
}

Result<std::vector<LevelMeasures>> measure(const LevelsShowArguments& arguments,
                                           const std::vector<LevelModel>& models) {
  const Result<MeshInterior> interior = parseInterior(arguments.interior);
  if (!interior) return fail(interior.error().message);
  std::vector<LevelMeasures> all;
  for (const LevelModel& model : models) {
    if (model.mesh.triangles.empty()) {
      return fail(arguments.file + ": " + model.name +
                  " has no mesh to measure against; give it with --mesh");
    }
    Result<LevelMeasures> measures = measureLevels(*model.levels, model.mesh, {.interior = *interior});
    if (!measures) return fail(arguments.file + ": " + measures.error().message);
    if (measures->isInsideOut && *interior == MeshInterior::kAutomatic) {
      printNote(arguments.file + ": " + model.name +
                " has a mesh that is inside out and is measured as a solid; if it is a room, give --interior "
                "surface");
    }
    all.push_back(std::move(*measures));
  }
  return all;
}

/// Several models go into files of their own: "x.png", "x-2.png" and so on.
std::string pictureName(const std::string& file, std::size_t model) {
  if (model == 0) return file;
  const std::filesystem::path path(file);
  const std::string name = fmt::format("{}-{}{}", path.stem().string(), model + 1, path.extension().string());
  return (path.parent_path() / name).string();
}

lab::LevelPicture pictureOf(const LevelModel& model, const LevelMeasures& measures) {
  lab::LevelPicture picture{model.name, model.levels.get(), &model.mesh, {}};
  picture.captions.push_back(fmt::format("mesh\n{} triangles", model.mesh.triangles.size()));
  for (std::size_t i = 0; i < measures.levels.size(); ++i) {
    const LevelFigures& level = measures.levels[i];
    picture.captions.push_back(
        fmt::format("level {}: {} part{}\ngap: p95 {:.2f} %, max {:.2f} % of the diagonal", i + 1,
                    level.parts, level.parts == 1 ? "" : "s", 100.0 * level.p95Gap / measures.diagonal,
                    100.0 * level.maxGap / measures.diagonal));
  }
  return picture;
}

Result<void> drawPictures(const LevelsShowArguments& arguments, const std::vector<LevelModel>& models,
                          const std::vector<LevelMeasures>& measures) {
  for (std::size_t i = 0; i < models.size() && !arguments.picture.empty(); ++i) {
    const auto drawn = lab::drawLevels(pictureOf(models[i], measures[i]), pictureName(arguments.picture, i));
    if (!drawn) return drawn;
  }
  return {};
}

ExitStatus run(const LevelsShowArguments& arguments) {
  const auto models = readModels(arguments);
  if (!models) return refuse(models.error());
  const auto measures = measure(arguments, *models);
  if (!measures) return refuse(measures.error());
  if (auto drawn = drawPictures(arguments, *models, *measures); !drawn) return refuse(drawn.error());
  if (!arguments.json.empty()) {
    if (auto written = writeFile(arguments.json, figuresJson(*models, *measures)); !written) {
      return refuse(written.error());
    }
  }
  for (std::size_t i = 0; i < models->size(); ++i) {
    fmt::print("{}{}{}\n{}", i > 0 ? "\n" : "", describeMesh((*models)[i], (*measures)[i]),
               describeMass((*models)[i], (*measures)[i]), formatFigures((*measures)[i]));
  }
  return ExitStatus::kOk;
}

}  // namespace

Command addLevelsShowCommand(CLI::App& levels) {
  CLI::App* command = levels.add_subcommand(
      "show", "Measure each level: parts, vertices, volume, distance to the mesh, predicted cost");
  auto arguments = std::make_shared<LevelsShowArguments>();
  command->add_option("FILE", arguments->file, "COLLADA or glTF physics file with levels")->required();
  command->add_option("--mesh", arguments->mesh, "Measure against this mesh instead of the one in FILE")
      ->type_name("MESH");
  addMeshArguments(*command, arguments->reading);
  command
      ->add_option("--interior", arguments->interior,
                   "What is inside of the mesh, as for build: solid, surface or automatic")
      ->type_name("KIND")
      ->capture_default_str();
  command->add_option("--json", arguments->json, "Write the figures to this file")->type_name("FILE");
  command
      ->add_option("--picture", arguments->picture, "Draw mesh and levels side by side: a .png or .svg file")
      ->type_name("FILE");
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace scatter::app
