#pragma once

#include <scatter/levels/build_levels.h>
#include <scatter/levels/mass_properties.h>

#include "levels/mesh/mesh_tree.h"
#include "levels/mesh/work_mesh.h"

namespace scatter::levels {

/// A mesh whose inside is known.
struct MeshSpace {
  WorkMesh mesh;
  MeshTree tree;
  bool isClosed = false;  ///< Every edge has as many triangles on one side as on the other.
  bool isSolid = false;   ///< Whether points inside count as inside; see MeshInterior.

  /// Whether it encloses a volume, and was turned as a whole to do so: as given, its outside was within.
  bool wasInsideOut = false;

  /// Whether no triangle, of a sample, has the inside on both of its sides, as where shells overlap.
  [[nodiscard]] bool isSimple() const;

  /// 0 inside, if there is an inside.
  [[nodiscard]] double distance(const glm::dvec3& point) const;
  [[nodiscard]] bool isInside(const glm::dvec3& point) const;
};

/// Of what a closed mesh encloses; see massOfMesh(const SurfaceMesh&).
[[nodiscard]] Result<SolidMass> massOfMesh(const MeshSpace& space);

/// Turns the triangles of each shell the same way round and shells inside-out, but leaves cavities; then
/// decides whether the mesh has an inside. Adds to the notes of the mesh.
[[nodiscard]] MeshSpace makeMeshSpace(WorkMesh mesh, MeshInterior interior);

}  // namespace scatter::levels
