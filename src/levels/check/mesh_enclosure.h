#pragma once

#include <scatter/levels/level_check.h>
#include <scatter/levels/surface_mesh.h>

#include <span>

#include "levels/check/solid_part.h"

namespace scatter::levels {

/// Whether the union of the parts, widened by `tolerance`, holds every triangle. What several round parts
/// hold together is found down to `resolution`. Both are positive; the mesh is sound.
[[nodiscard]] EnclosureCheck checkMeshInside(const SurfaceMesh& mesh, std::span<const SolidPart> parts,
                                             double tolerance, double resolution);

}  // namespace scatter::levels
