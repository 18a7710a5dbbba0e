#pragma once

#include <scatter/result.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace scatter {

/// The folders that hold scene files, best first: those of $SCATTER_SCENE_PATH (separated by colons),
/// `share/scatter/scenes` beside the program's `bin` folder, the source tree's `scenes`, and
/// `share/scatter/scenes` in the install prefix and in /usr.
[[nodiscard]] std::vector<std::filesystem::path> sceneFolders();

/// The names of the scene files in these folders, without ".toml", sorted.
[[nodiscard]] std::vector<std::string> sceneFileNames();

/// The file of a scene, such as "duel" for `duel.toml`. Fails on an unknown name.
[[nodiscard]] Result<std::filesystem::path> findSceneFile(std::string_view name);

}  // namespace scatter
