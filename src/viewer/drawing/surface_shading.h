#pragma once

#include <scatter/levels/surface_mesh.h>

#include "viewer/renderer.h"

namespace scatter::viewer {

/// Gives a surface normals: smooth where neighbouring triangles meet at less than `crease` (radians), with an
/// edge where they meet at more. Triangles without area are left out.
[[nodiscard]] MeshData shadeSurface(const SurfaceMesh& surface, float crease = 0.6F);

}  // namespace scatter::viewer
