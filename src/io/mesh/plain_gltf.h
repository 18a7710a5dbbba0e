#pragma once

#include <scatter/result.h>

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace scatter::io {

/// A glTF file in numbers that every program knows.
struct PlainGltf {
  std::string glb;                      ///< A file of its own.
  std::vector<std::string> warnings{};  ///< Phrases without the file's name.
};

/// Makes one of the bytes of a .gltf or .glb file, for KHR_mesh_quantization and EXT_meshopt_compression: the
/// scene's nodes, meshes with positions, indices and bones, names of materials. Nothing else of it is kept.
/// `file` is its path; buffers beside it are read if `allows` them. The error is without the file's name.
[[nodiscard]] Result<PlainGltf> makePlainGltf(
    std::string_view bytes, const std::filesystem::path& file,
    const std::function<bool(const std::filesystem::path&)>& allows);

}  // namespace scatter::io
