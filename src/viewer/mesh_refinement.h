#pragma once

#include <cstddef>

#include "viewer/renderer.h"

namespace scatter::viewer {

/// The same surface with no edge longer than `longest` (metres), so that colours can change within what were
/// large triangles; but never more than about `maxTriangles`. Colours and occlusion are left out.
[[nodiscard]] MeshData refined(const MeshData& mesh, float longest, std::size_t maxTriangles);

}  // namespace scatter::viewer
