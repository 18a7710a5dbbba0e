#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace scatter::io {

/// Where files of one kind lie, such as models.
struct DataKind {
  const char* variable;   ///< An environment variable with folders, separated by colons.
  const char* folder;     ///< The name of the folder below `share/scatter`.
  const char* source;     ///< The folder in the source tree.
  const char* installed;  ///< The folder in the install prefix.
  const char* extension;  ///< Such as ".dae".
};

/// Best first: those of the variable, that beside the program's `bin` folder, so that an installed tree has
/// its own wherever it is moved to, the source tree's, that in the install prefix, and that of a system's
/// package.
[[nodiscard]] std::vector<std::filesystem::path> dataFolders(const DataKind& kind);

/// The names of the files in these folders, without extension, sorted.
[[nodiscard]] std::vector<std::string> dataNames(const DataKind& kind);

/// The best file of that name, or an empty path. A name with folders in it names nothing.
[[nodiscard]] std::filesystem::path findData(const DataKind& kind, std::string_view name);

}  // namespace scatter::io
