#pragma once

#include <scatter/levels/level_set.h>
#include <scatter/levels/level_symmetry.h>
#include <scatter/levels/mesh_region.h>
#include <scatter/levels/surface_mesh.h>
#include <scatter/result.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scatter {

/// What counts as inside of a mesh. Inside, levels may fill space at no cost.
enum class MeshInterior {
  /// Solid if the triangles enclose a volume well enough to tell, else Surface. If it is inside out as a
  /// whole, it may be a room or a mistake: buildLevels() refuses to choose.
  kAutomatic,
  kSolid,    ///< What the triangles wind around; small holes are bridged.
  kSurface,  ///< Nothing: bowls, sheets and tubes stay hollow, and so do rooms.
};

/// What is made of a mesh that is mirror symmetric.
enum class MeshSymmetry {
  kIgnore,     ///< Levels are as near to the mesh as they can be, and mostly not symmetric.
  kAutomatic,  ///< Each level is symmetric if the mesh is.
  kRequired,   ///< The same, and other meshes are refused.
};

/// A limit to the gap: how far the surface of a level may be from the mesh. The two are alternatives.
struct GapLimit {
  std::optional<float> metres;
  std::optional<float> ofDiagonal;  ///< As a share of the diagonal of the mesh's bounds.
};

/// What to make of a mesh.
struct LevelBuildDef {
  std::string name = "model";

  /// Parts of each level, coarsest first, increasing, such as 1, 8, 64. If empty, `levels` of them from one
  /// part to the finest level's, in about equal ratios.
  std::vector<int> partCounts;
  int levels = 3;
  int finestParts = 64;  ///< Used if `partCounts` is empty and there is no `finestGap`.

  /// The finest level has as few parts as keep the largest gap, margins of hulls counted, below this. Only
  /// without `partCounts`.
  std::optional<GapLimit> finestGap;
  int maxParts = 1024;  ///< Of the finest level, whatever `finestGap` asks for.

  int maxVertices = 16;  ///< Of a hull, 8 to 64.

  /// Collision margin around hulls, metres. If absent, the least of 0.02, 0.05 % of the diagonal and a
  /// quarter of `finestGap`. If `finestGap` is given, less than that.
  std::optional<float> hullMargin;

  /// The least thickness of the plates that stand for sheets, metres; half of it on either side of the mesh.
  /// Of meshes that are taken as a surface only. If absent, see kSheetThickness.
  std::optional<float> thickness;

  /// Makes a hull a box, sphere or capsule where that holds the same and its gap is not noticeably larger.
  bool fitPrimitives = true;

  MeshInterior interior = MeshInterior::kAutomatic;

  /// Of the mesh about a plane across an axis, through the middle of its bounds: corners have their mirror
  /// image on the mesh, to within 1e-4 of the diagonal, middles of edges and triangles to within 5e-3, as
  /// quadrangles may be cut along either diagonal. Parts of symmetric levels are symmetric, or come in pairs.
  /// Regions count on both sides then: one and its image are one.
  MeshSymmetry symmetry = MeshSymmetry::kIgnore;

  /// Where detail is worth more or less than elsewhere: parts go where they save the largest gap times
  /// weight. `finestGap` is that of a weight of 1.
  std::vector<MeshRegion> regions;

  /// Meshes with more triangles are grouped by cell and facing first, which makes the parts follow the mesh
  /// a little less closely. Nothing is left out.
  std::size_t maxTriangles = 200'000;
};

/// Plates are at least so thick, metres, if LevelBuildDef does not say: a ball of 3 cm that comes at 7 m/s,
/// 12 cm in a step of 1/60 s, is found before its middle is past that of the plate, wherever it was the step
/// before. At most a twentieth of the mesh's diagonal, and half of `finestGap`.
inline constexpr float kSheetThickness = 0.21F;

/// Nested levels, and what a user should know about the mesh they were made from.
struct BuiltLevels {
  std::shared_ptr<const LevelSet> levels;
  bool isSolid = true;         ///< Whether the mesh was taken as solid.
  bool hasMassOfMesh = false;  ///< Else mass properties are those of the finest level: see `notes`.

  /// Of the mesh. Of a mesh with more triangles than LevelBuildDef::maxTriangles only if symmetric levels
  /// were asked for, since it takes time.
  std::optional<SymmetryPlane> symmetry{};
  std::vector<std::string> notes;  ///< What was mended or done differently, one line each.
};

/// Told what is being done ("distances", "merging", …) and how much of it is done, 0 to 1.
using BuildProgress = std::function<void(std::string_view stage, double share)>;

/// Makes nested levels of hulls around the mesh: every triangle lies inside a part of the finest level, its
/// margin not counted, and every part inside one part of the next coarser level, margins counted. Both are
/// proven for the vertices that are returned, rounding included. The same input gives the same bits, on one
/// core as on two. `progress` is called on the caller's thread and may throw, which ends the build. Takes any
/// triangles: open, inside-out, several shells, degenerate, flat. Fails on a mesh without triangles, an index
/// out of range, a coordinate that is not finite, a mesh of a single point, one that is inside out unless
/// `interior` says what it is, a region with nothing of the mesh, one that is not symmetric if it must be,
/// and counts that make no sense.
[[nodiscard]] Result<BuiltLevels> buildLevels(const SurfaceMesh& mesh, const LevelBuildDef& definition,
                                              const BuildProgress& progress = {});

}  // namespace scatter
