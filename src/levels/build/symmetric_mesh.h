#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "levels/build/mirror.h"
#include "levels/build/pre_merge.h"
#include "levels/mesh/work_mesh.h"

namespace scatter::levels {

/// Corners of a mesh that are further from it in the mirror are not symmetric, as a share of the diagonal.
inline constexpr double kSymmetryTolerance = 1e-4;

/// The same for middles of edges and triangles: quadrangles need not be flat, and may be cut along either
/// diagonal.
inline constexpr double kBulgeTolerance = 5e-3;

/// A plane across an axis of a work mesh's frame.
struct MirrorPlane {
  int axis = 0;
  double offset = 0.0;
};

/// The plane through the middle of the mesh's bounds that it is symmetric about. Of several, that across x
/// comes first, then z. A plane through the model's origin is preferred to the middle's if that is within the
/// tolerance.
[[nodiscard]] std::optional<MirrorPlane> findMirrorPlane(const WorkMesh& mesh);

/// Moves the work mesh so that the plane goes through zero.
[[nodiscard]] Mirror moveToPlane(const MirrorPlane& plane, WorkMesh& mesh);

/// A mesh whose triangles have mirror images: those they had, or new ones where another diagonal cuts a
/// quadrangle.
struct SymmetricMesh {
  Mirror mirror;
  WorkMesh mesh;  ///< Vertices are moved by less than the tolerance, so that images match exactly.

  /// For each vertex, where it was, and where the image of its image was.
  std::vector<std::vector<glm::dvec3>> places;
  std::vector<std::uint32_t> imageOf;  ///< Of each triangle; its own if it is symmetric.
  std::vector<bool> isAcross;          ///< Reaches over the plane, or lies in it.

  [[nodiscard]] Cluster imageOfAll(const Cluster& triangles) const;

  /// What regions that count on both sides say about each triangle, from what they say about those of the
  /// mesh that this one is made of: the same about a triangle and its image.
  [[nodiscard]] TriangleRegions regions(const TriangleRegions& ofMesh) const;

  /// Patches of one side of the plane, and those across it, which are symmetric. Their neighbours are those
  /// of the same kind. `regions`: of its own triangles.
  [[nodiscard]] Patches patches(const TriangleRegions& regions, std::size_t count,
                                std::size_t maxTriangles) const;
};

/// Of a mesh with the mirror's plane through zero.
[[nodiscard]] SymmetricMesh makeSymmetric(const WorkMesh& mesh, const Mirror& mirror);

}  // namespace scatter::levels
