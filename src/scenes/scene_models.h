#pragma once

#include <scatter/io/model.h>
#include <scatter/io/scene_file.h>
#include <scatter/result.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace scatter {

/// The models of a scene file, each read once.
class SceneModels {
 public:
  /// `folder` is that of the scene file.
  explicit SceneModels(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// A model of the library, or, if the name has a '/' or ends like a model file, a file relative to the
  /// folder. Fails also if it has fewer levels than are asked for.
  [[nodiscard]] Result<std::shared_ptr<const Model>> load(const SceneFileModel& model);

 private:
  [[nodiscard]] Result<std::shared_ptr<const Model>> read(const std::string& name) const;

  std::filesystem::path folder_;

  /// By name and number of levels; 0: all.
  std::map<std::pair<std::string, std::size_t>, std::shared_ptr<const Model>> models_;
};

}  // namespace scatter
