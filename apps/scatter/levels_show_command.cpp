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
#include "region_arguments.h"

namespace scatter::app {

namespace {

struct LevelsShowArguments {
  std::string file;
  std::string mesh;
  MeshArguments reading;
  RegionArguments regions;
  std::string interior = "automatic";
  std::string json;
  std::string picture;
};

/// What is shown, and where gaps are measured apart.
struct Shown {
  std::vector<LevelModel> models;
  std::vector<MeshRegion> regions;
};

/// Without --mesh; a level file's meshes have no names.
Result<std::vector<MeshRegion>> findBoxes(const LevelsShowArguments& arguments) {
  auto regions = findRegions(arguments.regions, {});
  if (regions) return regions;
  return fail(regions.error().message + ", or the mesh that " + arguments.file +
              " was made from, which has names, with --mesh");
}

/// Gives the only model another mesh, if the user did.
Result<Shown> readModels(const LevelsShowArguments& arguments) {
  auto models = readLevelFile(arguments.file);
  if (!models) return fail(models.error().message);
  if (arguments.mesh.empty()) {
    auto boxes = findBoxes(arguments);
    if (!boxes) return fail(boxes.error().message);
    return Shown{std::move(*models), std::move(*boxes)};
  }
  if (models->size() > 1) {
    return fail(
        fmt::format("{}: has {} models; --mesh can stand for one only", arguments.file, models->size()));
  }
  Result<MeshFile> mesh = readMesh(arguments.mesh, arguments.reading);
  if (!mesh) return fail(mesh.error().message);
  printNotes(mesh->warnings);
  auto regions = findRegions(arguments.regions, *mesh);
  if (!regions) return fail(arguments.mesh + ": " + regions.error().message);
  models->front().mesh = std::move(mesh->mesh);
  return Shown{std::move(*models), std::move(*regions)};
}

Result<std::vector<LevelMeasures>> measure(const LevelsShowArguments& arguments, const Shown& shown) {
  const Result<MeshInterior> interior = parseInterior(arguments.interior);
  if (!interior) return fail(interior.error().message);
  std::vector<LevelMeasures> all;
  for (const LevelModel& model : shown.models) {
    if (model.mesh.triangles.empty()) {
      return fail(arguments.file + ": " + model.name +
                  " has no mesh to measure against; give it with --mesh");
    }
    Result<LevelMeasures> measures =
        measureLevels(*model.levels, model.mesh, {.interior = *interior, .regions = shown.regions});
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
  const auto shown = readModels(arguments);
  if (!shown) return refuse(shown.error());
  const std::vector<LevelModel>& models = shown->models;
  const auto measures = measure(arguments, *shown);
  if (!measures) return refuse(measures.error());
  if (auto drawn = drawPictures(arguments, models, *measures); !drawn) return refuse(drawn.error());
  if (!arguments.json.empty()) {
    if (auto written = writeFile(arguments.json, figuresJson(models, *measures, shown->regions)); !written) {
      return refuse(written.error());
    }
  }
  for (std::size_t i = 0; i < models.size(); ++i) {
    fmt::print("{}{}{}{}\n{}{}", i > 0 ? "\n" : "", describeMesh(models[i], (*measures)[i]),
               describeMass(models[i], (*measures)[i]), describeSymmetry(*models[i].levels),
               formatFigures((*measures)[i]), formatRegions((*measures)[i], shown->regions));
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
      ->add_option(
          "--region", arguments->regions.watched,
          "Measure gaps in this region and elsewhere apart, given as for build --keep; names are those "
          "of --mesh. Several times for several regions")
      ->allow_extra_args(false)
      ->type_name("REGION");
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
