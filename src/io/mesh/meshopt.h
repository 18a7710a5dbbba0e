#pragma once

#include <string>
#include <string_view>

#include "io/gltf/json.h"

namespace scatter::io {

/// The bytes of a buffer view that EXT_meshopt_compression has made `bytes` of, as `compression`, the
/// extension's object, tells: at most 64 times as many. Throws GltfFailure.
[[nodiscard]] std::string decompressMeshopt(const JsonPlace& compression, std::string_view bytes);

}  // namespace scatter::io
