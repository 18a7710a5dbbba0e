#pragma once

#include <scatter/io/mesh_file.h>
#include <scatter/result.h>

#include <filesystem>
#include <string>
#include <vector>

namespace scatter::io {

/// Reads a mesh through Assimp, which may crash or hang on a damaged file. `extension` is one of
/// meshExtensions(). Error and warnings are phrases without the file's name.
[[nodiscard]] Result<MeshFile> readWithAssimp(const std::filesystem::path& path, const std::string& extension,
                                              const MeshOptions& options);

/// Of all formats that Assimp was built with, lower case, without dots, in order.
[[nodiscard]] std::vector<std::string> assimpExtensions();

}  // namespace scatter::io
