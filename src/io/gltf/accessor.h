#pragma once

#include <scatter/math.h>
#include <cstdint>
#include <vector>

#include "io/gltf/file.h"

namespace scatter::io {

/// The values of the accessor that `reference` names, each spent from the file's budget. Throws GltfFailure.
/// @{
[[nodiscard]] std::vector<Vec3> readPositions(GltfFile& file, const JsonPlace& reference);
[[nodiscard]] std::vector<std::uint32_t> readIndices(GltfFile& file, const JsonPlace& reference);

/// Elements of `width` numbers, one after the other; `type` is what the accessor should be, such as "VEC4".
[[nodiscard]] std::vector<float> readFloats(GltfFile& file, const JsonPlace& reference, const char* type,
                                            std::size_t width);
/// @}

}  // namespace scatter::io
