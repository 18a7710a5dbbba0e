#pragma once

#include <scatter/levels/level_set.h>
#include <scatter/world/shape.h>

#include "viewer/renderer.h"

namespace scatter::viewer {

/// Convex parts with flat sides, round ones as smooth surfaces; hull margins are left out.
[[nodiscard]] MeshData meshOf(const Level& level);

/// What a body collides with, at its finest level. A plane is a large square.
[[nodiscard]] MeshData meshOf(const Shape& shape);

/// Of radius 1 and of half extents 1, to be scaled.
[[nodiscard]] MeshData unitSphere();
[[nodiscard]] MeshData unitBox();

}  // namespace scatter::viewer
