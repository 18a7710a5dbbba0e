#include "scenes/scene_models.h"

#include <scatter/io/collada.h>
#include <scatter/io/model_file.h>
#include <scatter/io/model_library.h>

#include <utility>

namespace scatter {
namespace {

Result<Model> readModel(const std::filesystem::path& file) {
  if (file.extension() == ".dae") return readCollada(file);
  return readModelFile(file).map([](FileModel read) { return std::move(read.model); });
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
