#pragma once

#include "levels/line_moments.h"
#include "levels/mesh/work_mesh.h"

namespace scatter::levels {

/// Of what a closed mesh winds around at least once, about `origin`, both in the mesh's own frame: what
/// several shells fill counts once. By 512 x 512 columns through its bounds, exact along each.
[[nodiscard]] EstimatedMoments columnMoments(const WorkMesh& mesh, const glm::dvec3& origin);

}  // namespace scatter::levels
