#pragma once

#include <scatter/io/model.h>
#include <scatter/result.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace scatter {

/// The folders that hold models, best first: those of $SCATTER_MODEL_PATH (separated by colons),
/// `share/scatter/models` beside the program's `bin` folder, the source tree's `models`, and
/// `share/scatter/models` in the install prefix and in /usr.
[[nodiscard]] std::vector<std::filesystem::path> modelFolders();

/// The names that findModel knows, sorted.
[[nodiscard]] std::vector<std::string> modelNames();

/// The file of a model, such as "hunter" for `hunter.dae`. Fails on an unknown name, listing the known ones.
[[nodiscard]] Result<std::filesystem::path> findModel(std::string_view name);

/// Finds and reads a model. Nothing is cached: keep the result for as long as bodies are made from it.
[[nodiscard]] Result<std::shared_ptr<const Model>> loadModel(std::string_view name);

}  // namespace scatter
