#include "scenes/scene_models.h"

#include <scatter/io/collada.h>
#include <scatter/io/gltf.h>
#include <scatter/io/model_library.h>

#include <utility>

#include "scenes/document_mass.h"

namespace scatter {
namespace {

Result<std::shared_ptr<const LevelSet>> levelsOf(const DocumentModel& model) {
  if (model.levels) return model.levels;
  LevelSetDef def;
  def.name = model.name;
  def.levels.emplace_back();
  for (const DocumentShape& shape : model.shapes) {
    const auto* convex = std::get_if<ConvexShape>(&shape.geometry);
    if (convex == nullptr) return fail("a model is made of convex shapes, not of planes or meshes");
    def.levels.front().parts.push_back({.shape = *convex, .pose = shape.pose});
  }
  return LevelSet::create(std::move(def));
}

/// The one rigid body of a document.
Result<Model> modelOf(const PhysicsDocument& document) {
  if (document.models.size() != 1) {
    return fail("a model file has one rigid body, not " + std::to_string(document.models.size()));
  }
  const DocumentModel& given = document.models.front();
  Model model;
  model.name = given.name;
  model.mesh = given.mesh;
  auto levels = levelsOf(given);
  if (!levels) return tl::unexpected(levels.error());
  model.levels = std::move(*levels);
  const auto mass = documentMass(given, {});
  if (!mass) return tl::unexpected(mass.error());
  model.mass = *mass;
  const auto material = given.material ? given.material : given.shapes.front().material;
  if (material) {
    model.friction = document.materials[*material].dynamicFriction;
    model.restitution = document.materials[*material].restitution;
  }
  return model;
}

Result<Model> readModel(const std::filesystem::path& file) {
  if (file.extension() == ".dae") return readCollada(file);
  const auto document = readGltfDocument(file);
  if (!document) return tl::unexpected(document.error());
  auto model = modelOf(*document);
  return model ? std::move(model) : fail(file.string() + ": " + model.error().message);
}

/// The same model with so many of its levels, from the finest on.
Result<std::shared_ptr<const Model>> withLevels(const Model& whole, std::size_t count) {
  const LevelSet& all = *whole.levels;
  const int wanted = static_cast<int>(count);
  if (wanted > all.count()) {
    return fail("the model " + all.name() + " has " + std::to_string(all.count()) + " levels, not " +
                std::to_string(count));
  }
  LevelSetDef def{.name = all.name(), .levels = {}, .hullMargin = all.hullMargin(), .mass = all.mass()};
  for (int level = all.count() - wanted + 1; level <= all.count(); ++level) {
    def.levels.push_back(all.level(level));
  }
  auto levels = LevelSet::create(std::move(def));
  if (!levels) return tl::unexpected(levels.error());
  auto model = std::make_shared<Model>(whole);
  model->levels = std::move(*levels);
  return model;
}

}  // namespace

Result<std::shared_ptr<const Model>> SceneModels::load(const SceneFileModel& wanted) {
  const std::pair key(wanted.name, wanted.levels);
  if (const auto known = models_.find(key); known != models_.end()) return known->second;
  auto model = read(wanted.name);
  if (model && wanted.levels > 0) model = withLevels(**model, wanted.levels);
  if (model) models_.emplace(key, *model);
  return model;
}

Result<std::shared_ptr<const Model>> SceneModels::read(const std::string& name) const {
  const std::filesystem::path file(name);
  const std::filesystem::path extension = file.extension();
  const bool isModelFile = extension == ".dae" || extension == ".gltf" || extension == ".glb";
  if (!file.has_parent_path() && !isModelFile) return loadModel(name);
  if (!isModelFile) return fail("a model file ends in .dae, .gltf or .glb, unlike \"" + name + "\"");
  return readModel(folder_ / file).map([](Model model) -> std::shared_ptr<const Model> {
    return std::make_shared<Model>(std::move(model));
  });
}

}  // namespace scatter
