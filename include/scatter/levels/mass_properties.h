#pragma once

#include <scatter/levels/convex_part.h>
#include <scatter/levels/surface_mesh.h>
#include <scatter/result.h>

#include <vector>

namespace scatter {

/// Of a homogeneous solid, per kilogram: multiply the inertia by the body's mass.
struct MassProperties {
  float volume = 0.0F;      ///< Cubic metres.
  Vec3 centerOfMass{0.0F};  ///< In the model's frame.
  Mat3 inertia{0.0F};       ///< Square metres, about the centre of mass, along the model's axes.
};

/// MassProperties of what parts or shells fill together, and how well they are known.
struct SolidMass {
  MassProperties properties{};
  float shared = 0.0F;  ///< The volume that they have in common with others, as a share of what they fill.
  float error = 0.0F;   ///< Of the volume, as a share, estimated. 0: nothing overlaps, all is exact.
};

/// What several parts fill counts once. Each part is exact (closed forms; hulls by tetrahedra, without their
/// margin), and so is their sum; where they overlap, columns through them are integrated: some milliseconds
/// for each part that does. Fails if a part has no volume or is not finite, naming the part, counted from 1.
[[nodiscard]] Result<SolidMass> massOfUnion(const std::vector<ConvexPart>& parts);

/// massOfUnion() without how well it is known.
[[nodiscard]] Result<MassProperties> massProperties(const std::vector<ConvexPart>& parts);

/// Of what a closed mesh encloses: signed tetrahedra over its triangles, exact but for rounding (Mirtich 1996
/// has the same integrals), or columns through it where shells overlap, so that what several fill counts
/// once. Shells that are inside-out are turned; cavities stay empty. Fails if the mesh is open or encloses
/// nothing.
[[nodiscard]] Result<SolidMass> massOfMesh(const SurfaceMesh& mesh);

}  // namespace scatter
