#pragma once

#include "io/collada/frame.h"

#include <scatter/io/physics_document.h>
#include <scatter/levels/level_set.h>

#include <optional>

namespace scatter::io {

/// The `<shape>` children of an element as convex parts, in metres, y up. Fails if there are none, or on one
/// that is not convex.
[[nodiscard]] Result<Level> readShapes(const ColladaFrame& frame, const pugi::xml_node& parent);

/// A `<shape>` of any kind, without its material. Nothing, and a note, if its kind is not supported.
[[nodiscard]] Result<std::optional<DocumentShape>> readShape(const ColladaFrame& frame,
                                                             const pugi::xml_node& shape);

}  // namespace scatter::io
