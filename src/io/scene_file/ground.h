#pragma once

#include <scatter/io/scene_file.h>

#include <string_view>

#include "io/scene_file/table.h"

namespace scatter::io {

/// Such as "a plane" for a shape that can only be static; empty for all others.
[[nodiscard]] std::string_view staticKind(const SceneFileShape& shape);

/// The terrain below the key `terrain` of an object.
[[nodiscard]] SceneFileTerrain readTerrain(const SceneTable& object);

}  // namespace scatter::io
