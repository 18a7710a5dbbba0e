#include <scatter/io/file.h>
#include <scatter/io/scene_file.h>

#include <glm/geometric.hpp>
#include <utility>

#include "io/scene_file/events.h"
#include "io/scene_file/names.h"
#include "io/scene_file/objects.h"
#include "io/scene_file/table.h"

namespace scatter {
namespace {

using io::SceneNames;
using io::SceneTable;

void readWorld(const SceneTable& file, SceneFile& scene) {
  const auto table = file.table("scene", "scene");
  if (!table) return;
  table->read("summary", scene.summary);
  table->readWhole("frames", scene.frames);
  table->readWhole("seed", scene.seed);
  table->read("gravity", scene.gravity);
  if (table->has("solver_iterations"))
    table->readWhole("solver_iterations", scene.solverIterations.emplace());
}

std::vector<SceneFileMaterial> readMaterials(const SceneTable& file, SceneNames& names) {
  std::vector<SceneFileMaterial> materials;
  for (const SceneTable& table : file.tables("material", "material")) {
    table.demand("name");
    names.define(table, "material", io::readName(table, "name"), materials.size());
    readSurface(table, materials.emplace_back());
    if (table.problem().any()) break;
  }
  return materials;
}

void readField(const SceneTable& table, SceneFile& scene, SceneNames& names) {
  using Kind = SceneFileField::Kind;
  SceneFileField field;
  field.line = table.line();
  field.name = io::readName(table, "name");
  if (!field.name.empty()) names.define(table, "field", field.name, scene.fields.size());
  if (table.choose("kind", {"point", "uniform"}) == std::size_t{1}) field.kind = Kind::kUniform;
  table.keepToKind("kind", field.kind == Kind::kPoint ? "point" : "uniform");
  table.need("acceleration", field.acceleration);
  table.read("on", field.on);
  if (field.kind == Kind::kPoint) {
    table.read("center", field.center);
    table.need("radius", field.radius);
  } else {
    table.needDirection("direction", field.direction);
  }
  scene.fields.push_back(std::move(field));
}

void readRegion(const SceneTable& table, SceneFile& scene, SceneNames& names) {
  using Kind = SceneFileRegion::Kind;
  static const std::vector<std::string_view> kKinds{"shell", "ball", "box"};
  SceneFileRegion region;
  table.demand("name");
  region.name = io::readName(table, "name");
  names.define(table, "region", region.name, scene.regions.size());
  const auto kind = table.needKind("kind", kKinds);
  if (!kind) return;
  region.kind = static_cast<Kind>(*kind);
  table.read("center", region.center);
  table.read("clearance", region.clearance);
  if (region.kind == Kind::kShell) {
    table.need("inner", region.inner);
    table.need("outer", region.outer);
    if (region.inner > region.outer) table.report("inner", R"("inner" in [[region]] is above "outer")");
  } else if (region.kind == Kind::kBall) {
    table.need("radius", region.outer);
  } else {
    table.need("size", region.size);
  }
  scene.regions.push_back(std::move(region));
}

void readFile(const SceneTable& file, SceneFile& scene, io::SceneProblem& problem) {
  SceneNames names(problem);
  readWorld(file, scene);
  const std::vector<SceneFileMaterial> materials = readMaterials(file, names);
  for (const SceneTable& table : file.tables("field", "field")) {
    readField(table, scene, names);
    if (problem.any()) return;
  }
  for (const SceneTable& table : file.tables("region", "region")) {
    readRegion(table, scene, names);
    if (problem.any()) return;
  }
  if (problem.any()) return;
  readObjects(file, scene, materials, names);
  if (problem.any()) return;
  if (scene.objects.empty()) problem.report(1, "the scene has no [[object]]");
  readJoints(file, scene, names);
  if (!problem.any()) readEvents(file, scene, names);
}

}  // namespace

Result<SceneFile> parseSceneFile(std::string_view toml, const std::filesystem::path& path) {
  auto parsed = io::parseToml(toml, path.string());
  if (!parsed) return tl::unexpected(parsed.error());
  io::TomlNode root;
  root.value = std::move(*parsed);
  root.line = 1;
  io::SceneProblem problem(path.string());
  const SceneTable file(root, "file", problem);
  SceneFile scene;
  scene.path = path;
  if (!problem.any()) readFile(file, scene, problem);
  if (problem.any()) return tl::unexpected(problem.error());
  return scene;
}

Result<SceneFile> readSceneFile(const std::filesystem::path& path) {
  const auto text = readFile(path);
  if (!text) return tl::unexpected(text.error());
  return parseSceneFile(*text, path);
}

}  // namespace scatter
