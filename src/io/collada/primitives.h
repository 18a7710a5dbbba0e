#pragma once

#include "io/collada/frame.h"

#include <scatter/io/model.h>

namespace scatter::io {

/// Adds the triangles of a primitive such as `<triangles>` or `<polylist>` to the mesh, whose vertices are
/// known. Polygons are cut into fans; lines and what is no primitive add nothing.
[[nodiscard]] Result<void> addPrimitive(const ColladaFrame& frame, const pugi::xml_node& primitive,
                                        VisualMesh& mesh);

}  // namespace scatter::io
