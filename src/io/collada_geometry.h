#pragma once

#include "io/collada_frame.h"

#include <scatter/io/model.h>

#include <vector>

namespace scatter::io {

/// The vertices of a `<geometry>` that holds a `<convex_mesh>`, in metres, in the file's axes. Follows one
/// convex_hull_of to another geometry.
[[nodiscard]] Result<std::vector<Vec3>> readConvexMesh(const ColladaFrame& frame,
                                                       const pugi::xml_node& geometry);

/// The triangles of a `<mesh>`, in metres, y up. Polygons of a `<polylist>` are cut into fans; lines are
/// ignored.
[[nodiscard]] Result<VisualMesh> readMesh(const ColladaFrame& frame, const pugi::xml_node& mesh);

}  // namespace scatter::io
