#include <scatter/levels/build_levels.h>
#include <scatter/levels/level_check.h>
#include <scatter/levels/measure_levels.h>
#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "build_progress.h"
#include "command.h"
#include "interrupt.h"
#include "level_arguments.h"
#include "level_cache.h"
#include "level_file.h"
#include "level_report.h"
#include "mesh_arguments.h"
#include "messages.h"
#include "number_checks.h"
#include "region_arguments.h"

namespace scatter::app {

namespace {

struct LevelsBuildArguments {
  std::vector<std::string> meshes;
  MeshArguments reading;
  std::string output;
  std::string folder;
  std::string format = "dae";
  bool anew = false;
  std::string parts;
  std::string gap;
  RegionArguments regions;
  std::string interior = "automatic";
  std::string symmetric = "off";
  LevelBuildDef build;
  std::optional<double> margin;
  std::optional<double> thickness;
  std::string name;
  double mass = 1.0;
  std::optional<double> density;
  double friction = 0.5;
  double restitution = 0.0;
};

Result<LevelBuildDef> definitionOf(const LevelsBuildArguments& arguments, const std::string& meshName) {
  LevelBuildDef def = arguments.build;
  def.name = arguments.name.empty() ? meshName : arguments.name;
  if (!arguments.parts.empty()) {
    Result<std::vector<int>> counts = parsePartCounts(arguments.parts);
    if (!counts) return fail(counts.error().message);
    def.partCounts = std::move(*counts);
  }
  if (!arguments.gap.empty()) {
    const Result<GapLimit> gap = parseGap(arguments.gap);
    if (!gap) return fail(gap.error().message);
    def.finestGap = *gap;
  }
  const Result<MeshInterior> interior = parseInterior(arguments.interior);
  if (!interior) return fail(interior.error().message);
  def.interior = *interior;
  const Result<MeshSymmetry> symmetry = parseSymmetry(arguments.symmetric);
  if (!symmetry) return fail(symmetry.error().message);
  def.symmetry = *symmetry;
  if (arguments.margin) def.hullMargin = static_cast<float>(*arguments.margin);
  if (arguments.thickness) def.thickness = static_cast<float>(*arguments.thickness);
  if (auto sound = checkRegions(arguments.regions); !sound) return fail(sound.error().message);
  return def;
}

Result<BuiltLevels> build(const SurfaceMesh& mesh, const LevelBuildDef& definition, const std::string& file) {
  BuildProgressLine line(file);
  return buildLevels(mesh, definition, [&line](std::string_view stage, double share) {
    throwIfInterrupted();
    line.update(stage, share);
  });
}

/// What was built is proven before anything is written.
Result<LevelCheck> prove(const LevelSet& levels, const SurfaceMesh& mesh) {
  std::vector<Level> all;
  for (int i = 1; i <= levels.count(); ++i) all.push_back(levels.level(i));
  Result<LevelCheck> check = checkLevels(all, levels.hullMargin(), &mesh);
  if (!check || check->passed()) return check;
  return fail("the levels do not pass the check, and nothing was written: " +
              describe(*check, levels.count()));
}

/// A file that was written.
struct BuiltFile {
  LevelModel model;
  LevelCheck check;
  std::vector<MeshRegion> regions;
};

ExitStatus report(const std::string& file, const BuiltFile& built, MeshInterior interior) {
  const LevelModel& model = built.model;
  const Result<LevelMeasures> measures =
      measureLevels(*model.levels, model.mesh, {.interior = interior, .regions = built.regions});
  if (!measures) return failed(measures.error());
  fmt::print("{}{}{}\n{}{}\n{}\n{}: written\n", describeMesh(model, *measures),
             describeMass(model, *measures), describeSymmetry(*model.levels), formatFigures(*measures),
             formatRegions(*measures, built.regions), describe(built.check, model.levels->count()), file);
  return ExitStatus::kOk;
}

double massOf(const LevelsBuildArguments& arguments, const LevelSet& levels) {
  return arguments.density ? *arguments.density * static_cast<double>(levels.mass().volume) : arguments.mass;
}

/// Who did not ask for symmetric levels may want them.
void noteSymmetry(const std::string& mesh, const BuiltLevels& built) {
  if (!built.symmetry) return;
  const std::optional<LevelSymmetry> known = symmetryOf(*built.levels);
  if (known && known->plane.axis == built.symmetry->axis) return;
  printNote(
      fmt::format("{}: the mesh is symmetric about {}, its levels are not symmetric about it; --symmetric on "
                  "makes them so",
                  mesh, describe(*built.symmetry)));
}

/// Builds, proves and writes; says itself what is wrong.
ExitStatus buildFile(const LevelsBuildArguments& arguments, const std::string& mesh,
                     const std::string& output, std::optional<BuiltFile>& result) {
  Result<MeshFile> file = readMesh(mesh, arguments.reading);
  if (!file) return refuse(file.error());
  LevelBuildDef definition = *definitionOf(arguments, file->name);
  Result<std::vector<MeshRegion>> regions = findRegions(arguments.regions, *file);
  if (!regions) return refuse(Error{mesh + ": " + regions.error().message});
  definition.regions = std::move(*regions);
  const Result<BuiltLevels> built = build(file->mesh, definition, mesh);
  if (!built) return refuse(Error{mesh + ": " + built.error().message});
  Result<LevelCheck> check = prove(*built->levels, file->mesh);
  if (!check) return failed(Error{mesh + ": " + check.error().message});

  Model model;
  model.name = built->levels->name();
  model.mesh = {file->mesh.vertices, file->mesh.triangles};
  model.levels = built->levels;
  model.mass = static_cast<float>(massOf(arguments, *built->levels));
  model.friction = static_cast<float>(arguments.friction);
  model.restitution = static_cast<float>(arguments.restitution);
  if (auto written = writeLevelFile(model, output); !written) return refuse(written.error());
  printNotes(file->warnings);
  for (const std::string& note : built->notes) printNote(mesh + ": " + note);
  if (definition.symmetry == MeshSymmetry::kIgnore) noteSymmetry(mesh, *built);
  result = BuiltFile{
      {model.name, model.levels, std::move(file->mesh)}, std::move(*check), std::move(definition.regions)};
  return ExitStatus::kOk;
}

ExitStatus runOne(const LevelsBuildArguments& arguments) {
  if (auto known = checkLevelFileName(arguments.output); !known) return refuse(known.error());
  std::optional<BuiltFile> built;
  const ExitStatus status = buildFile(arguments, arguments.meshes.front(), arguments.output, built);
  if (!built) return status;
  return report(arguments.output, *built, *parseInterior(arguments.interior));
}

/// What the result depends on beside the mesh, in words.
std::string optionsOf(const LevelsBuildArguments& a) {
  const LevelBuildDef& b = a.build;
  const auto given = [](const std::optional<double>& number) {
    return number ? fmt::format("{}", *number) : "-";
  };
  return fmt::format("{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}", a.reading.unit, a.reading.up,
                     a.parts, a.gap, a.interior, b.levels, b.maxParts, b.maxVertices, b.fitPrimitives,
                     given(a.margin), given(a.thickness), a.symmetric, a.name, a.mass, given(a.density),
                     a.friction, a.restitution, fmt::join(a.regions.kept, "\n"),
                     fmt::join(a.regions.importance, "\n"));
}

std::string outputName(const LevelsBuildArguments& arguments, const std::string& mesh) {
  return std::filesystem::path(mesh).stem().string() + "." + arguments.format;
}

Result<void> checkBatch(const LevelsBuildArguments& arguments) {
  std::map<std::string, std::string> names;
  for (const std::string& mesh : arguments.meshes) {
    const auto [known, isNew] = names.emplace(outputName(arguments, mesh), mesh);
    if (!isNew) {
      return fail(mesh + " and " + known->second + " would both become " + known->first +
                  "; rename one, or give it a folder of its own");
    }
  }
  if (arguments.meshes.size() > 1 && !arguments.name.empty())
    return fail("--name: one name for several meshes");
  std::error_code error;
  std::filesystem::create_directories(arguments.folder, error);
  if (error) return fail("cannot make the folder " + arguments.folder + ": " + error.message());
  return {};
}

std::string partCountsOf(const LevelSet& levels) {
  std::string text;
  for (int level = levels.count(); level >= 1; --level) {
    text += (text.empty() ? "" : ", ") + std::to_string(levels.level(level).parts.size());
  }
  return text;
}

/// Several files into a folder; those that would come out the same are left alone.
ExitStatus runBatch(const LevelsBuildArguments& arguments) {
  if (auto sound = checkBatch(arguments); !sound) return refuse(sound.error());
  LevelCache cache(arguments.folder);
  const std::string options = optionsOf(arguments);
  int unchanged = 0;
  int written = 0;
  ExitStatus worst = ExitStatus::kOk;
  for (const std::string& mesh : arguments.meshes) {
    const std::string name = outputName(arguments, mesh);
    const std::string output = (std::filesystem::path(arguments.folder) / name).string();
    const Result<std::string> key = levelKey(mesh, options);
    if (key && !arguments.anew && cache.isCurrent(name, *key)) {
      ++unchanged;
      continue;
    }
    std::optional<BuiltFile> built;
    ExitStatus status = key ? buildFile(arguments, mesh, output, built) : refuse(key.error());
    if (built) {
      ++written;
      fmt::print("{}: {} parts: written\n", output, partCountsOf(*built->model.levels));
      std::fflush(stdout);
      if (auto noted = cache.remember(name, *key); !noted) status = refuse(noted.error());
    }
    if (status != ExitStatus::kOk && worst != ExitStatus::kFailed) worst = status;
  }
  fmt::print("{} of {} meshes written, {} unchanged, {} failed\n", written, arguments.meshes.size(),
             unchanged, static_cast<int>(arguments.meshes.size()) - written - unchanged);
  return worst;
}

ExitStatus run(const LevelsBuildArguments& arguments) {
  if (arguments.output.empty() == arguments.folder.empty()) {
    return refuse(Error{"give --output FILE for one mesh, or --folder DIR for several"});
  }
  if (arguments.folder.empty() && arguments.meshes.size() > 1) {
    return refuse(
        Error{fmt::format("{} meshes do not go into one file; give --folder DIR", arguments.meshes.size())});
  }
  // Wrong options are told before a large mesh is read.
  if (auto sound = definitionOf(arguments, ""); !sound) return refuse(sound.error());
  return arguments.folder.empty() ? runOne(arguments) : runBatch(arguments);
}

void addLevelOptions(CLI::App& command, LevelsBuildArguments& arguments) {
  LevelBuildDef& build = arguments.build;
  CLI::Option* levels = command
                            .add_option("--levels", build.levels,
                                        "Number of levels; part counts fall from the finest one's to one")
                            ->check(wholeNumber(1))
                            ->type_name("N")
                            ->capture_default_str();
  CLI::Option* parts = command.add_option("--parts", arguments.parts, "Parts of each level, such as 64,8,1")
                           ->type_name("N,N,...");
  CLI::Option* gap =
      command
          .add_option("--gap", arguments.gap,
                      "Largest gap between finest level and mesh, such as 0.5% of the diagonal or "
                      "0.01m; takes as few parts as keep it [64 parts]")
          ->type_name("GAP");
  parts->excludes(levels)->excludes(gap);
  command.add_option("--max-parts", build.maxParts, "Parts of the finest level that --gap may ask for")
      ->check(wholeNumber(1))
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--max-vertices", build.maxVertices, "Vertices of a hull, 8 to 64")
      ->check(CLI::Range(8, 64))
      ->type_name("N")
      ->capture_default_str();
  command.add_flag("--primitives,!--no-primitives", build.fitPrimitives,
                   "Make parts boxes, spheres or capsules where they fit as well [on]");
}

void addRegionOptions(CLI::App& command, RegionArguments& regions) {
  command
      .add_option(
          "--keep", regions.kept,
          "As close as the finest parts allow, in parts of its own: a material, an object or a vertex "
          "group, by its name in the mesh file, or box:X0,Y0,Z0,X1,Y1,Z1 in the file's unit and axes; "
          "several times for several regions")
      ->allow_extra_args(false)
      ->type_name("REGION");
  command
      .add_option(
          "--importance", regions.importance,
          "A gap of g in this region counts as WEIGHT times g, 0.01 to 100; elsewhere it counts once, "
          "and 8 times where --keep says nothing else")
      ->allow_extra_args(false)
      ->type_name("REGION=WEIGHT");
}

void addBodyOptions(CLI::App& command, LevelsBuildArguments& arguments) {
  command.add_option("--name", arguments.name, "Name of the model [the file's]")->type_name("NAME");
  CLI::Option* mass = command.add_option("--mass", arguments.mass, "Mass in kilograms")
                          ->check(numberAbove(0.0))
                          ->type_name("KG")
                          ->capture_default_str();
  command
      .add_option("--density", arguments.density,
                  "Instead: kilograms per cubic metre of what the mesh encloses, or of what the finest level "
                  "fills if the mesh is open")
      ->check(numberAbove(0.0))
      ->type_name("KG/M3")
      ->excludes(mass);
  command.add_option("--friction", arguments.friction, "Friction coefficient")
      ->check(CLI::Range(0.0, 100.0))
      ->type_name("X")
      ->capture_default_str();
  command.add_option("--restitution", arguments.restitution, "0 no bounce, 1 full bounce")
      ->check(CLI::Range(0.0, 1.0))
      ->type_name("X")
      ->capture_default_str();
}

}  // namespace

Command addLevelsBuildCommand(CLI::App& levels) {
  CLI::App* command =
      levels.add_subcommand("build",
                            "Make nested levels around a mesh (obj, stl, ply, fbx, dae, gltf, glb and all "
                            "else that Assimp reads), prove them and write them");
  auto arguments = std::make_shared<LevelsBuildArguments>();
  command->add_option("MESH", arguments->meshes, "The mesh file, or several of them")->required();
  CLI::Option* output =
      command->add_option("-o,--output", arguments->output, "Physics file to write: .dae, .gltf or .glb")
          ->type_name("FILE");
  CLI::Option* folder =
      command
          ->add_option("--folder", arguments->folder,
                       "Instead: write a file for each mesh into this folder, named after it. Those "
                       "whose mesh and options are as they were are left alone")
          ->type_name("DIR")
          ->excludes(output);
  command->add_option("--format", arguments->format, "Of the files in --folder: dae, gltf or glb")
      ->check(CLI::IsMember({"dae", "gltf", "glb"}))
      ->needs(folder)
      ->type_name("FORMAT")
      ->capture_default_str();
  command->add_flag("--anew", arguments->anew, "Make all files in --folder again")->needs(folder);
  addLevelOptions(*command, *arguments);
  addRegionOptions(*command, arguments->regions);
  addMeshArguments(*command, arguments->reading);
  command
      ->add_option(
          "--interior", arguments->interior,
          "What is inside of the mesh: solid, surface (nothing: bowls, sheets and rooms stay hollow) or "
          "automatic")
      ->type_name("KIND")
      ->capture_default_str();
  command
      ->add_option(
          "--symmetric", arguments->symmetric,
          "Make every level mirror symmetric, so that bodies do not pull to one side: on, auto (if the "
          "mesh is symmetric about a plane across x, y or z) or off; regions count on both sides then")
      ->type_name("WHEN")
      ->capture_default_str();
  command
      ->add_option("--margin", arguments->margin,
                   "Collision margin around hulls, metres [the least of 0.02, 0.05 % of the diagonal and a "
                   "quarter of --gap]")
      ->check(CLI::Range(0.0, 1e6))
      ->type_name("M");
  command
      ->add_option(
          "--thickness", arguments->thickness,
          "Least thickness of plates that stand for sheets, metres [0.21, 5 % of the diagonal or half of "
          "--gap, whichever is least]")
      ->check(CLI::Range(0.0, 1e6))
      ->type_name("M");
  addBodyOptions(*command, *arguments);
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace scatter::app
