#pragma once

#include <scatter/io/model.h>
#include <scatter/result.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>

namespace scatter {

/// The models of a scene file, each read once.
class SceneModels {
 public:
  /// `folder` is that of the scene file.
  explicit SceneModels(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// A model of the library, or, if the name has a '/' or ends like a model file, a file relative to the
  /// folder.
  [[nodiscard]] Result<std::shared_ptr<const Model>> load(const std::string& name);

 private:
  [[nodiscard]] Result<std::shared_ptr<const Model>> read(const std::string& name) const;

  std::filesystem::path folder_;
  std::map<std::string, std::shared_ptr<const Model>> models_;
};

}  // namespace scatter
