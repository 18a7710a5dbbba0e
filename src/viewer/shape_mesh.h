#pragma once

#include <scatter/levels/level_set.h>
#include <scatter/levels/surface_mesh.h>
#include <scatter/world/shape.h>

#include "viewer/renderer.h"

namespace scatter::viewer {

/// With normals that are smooth where the surface is: faces that meet at less than 40 degrees share them.
[[nodiscard]] MeshData meshOf(const SurfaceMesh& mesh);

/// Convex parts with flat sides, round ones as smooth surfaces; hull margins are left out.
[[nodiscard]] MeshData meshOf(const Level& level);

/// What a body collides with, at its finest level. A plane is a large square.
[[nodiscard]] MeshData meshOf(const Shape& shape);

/// Of radius 1 and of half extents 1, to be scaled.
[[nodiscard]] MeshData unitSphere();
[[nodiscard]] MeshData unitBox();

}  // namespace scatter::viewer
