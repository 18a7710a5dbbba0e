#pragma once

#include <scatter/levels/surface_mesh.h>
#include <scatter/result.h>

#include <cstddef>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "levels/mesh/triangle_hull.h"
#include "levels/polytope.h"

namespace scatter::levels {

/// A mesh made fit for work: equal vertices are one, triangles are neither repeated nor mere parts of
/// others. Encloses what the mesh it was made from encloses, and nothing is moved.
struct WorkMesh {
  /// Subtracted from all vertices, so that they lie around zero and keep their digits; zero if they do
  /// anyway.
  Vec3 origin{0.0F};

  std::vector<glm::dvec3> vertices;
  std::vector<Triangle> triangles;
  DoubleBounds bounds;
  double diagonal = 0.0;
  std::vector<std::string> notes;  ///< What was mended, one line each.
};

/// Fails on a mesh that encloses nothing or cannot be read: see buildLevels().
[[nodiscard]] Result<WorkMesh> makeWorkMesh(const SurfaceMesh& mesh);

}  // namespace scatter::levels
