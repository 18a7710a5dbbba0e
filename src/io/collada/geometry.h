#pragma once

#include "io/collada/frame.h"

#include <scatter/io/model.h>

#include <pugixml.hpp>
#include <vector>

namespace scatter::io {

/// The `<mesh>` or `<convex_mesh>` of a `<geometry>` that has the vertices, behind any number of
/// convex_hull_of.
[[nodiscard]] Result<pugi::xml_node> findMeshElement(const ColladaFrame& frame, pugi::xml_node geometry);

/// The vertices of a `<geometry>` that holds a `<convex_mesh>`, in metres, in the file's axes. Follows
/// convex_hull_of to other geometries.
[[nodiscard]] Result<std::vector<Vec3>> readConvexMesh(const ColladaFrame& frame,
                                                       const pugi::xml_node& geometry);

/// The triangles of a `<mesh>` or `<convex_mesh>`, in metres, y up. Polygons are cut into fans; lines are
/// ignored.
[[nodiscard]] Result<VisualMesh> readMesh(const ColladaFrame& frame, const pugi::xml_node& mesh);

}  // namespace scatter::io
