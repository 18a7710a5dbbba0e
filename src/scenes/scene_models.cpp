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

}  // namespace

Result<std::shared_ptr<const Model>> SceneModels::load(const std::string& name) {
  if (const auto known = models_.find(name); known != models_.end()) return known->second;
  auto model = read(name);
  if (model) models_.emplace(name, *model);
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
