#pragma once

#include <scatter/levels/build_levels.h>
#include <scatter/levels/level_set.h>
#include <scatter/levels/mass_properties.h>
#include <scatter/levels/mesh_region.h>
#include <scatter/levels/surface_mesh.h>
#include <scatter/result.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace scatter {

/// Distances from a level to a mesh, metres.
struct GapFigures {
  double mean = 0.0;
  double p95 = 0.0;
  double max = 0.0;
  std::size_t samples = 0;  ///< On how many points the first two rest.
};

/// One level against the mesh it stands for.
struct LevelFigures {
  int parts = 0;
  int vertices = 0;      ///< Of all hulls; a box counts 8, round parts none.
  int mostVertices = 0;  ///< Of one hull.

  /// What the parts fill together; nothing if one of them has no volume.
  std::optional<SolidMass> mass{};

  double partVolume = 0.0;   ///< Sum over the parts, cubic metres; where parts overlap, counted once each.
  double unionVolume = 0.0;  ///< Of their union, estimated by sampling, good to about 1 %.
  double volumeRatio = 0.0;  ///< Union to mesh; 0 if the mesh has no volume.

  /// In how many parts a point lies that lies in any; 0 if none does.
  [[nodiscard]] double overlap() const { return unionVolume > 0.0 ? partVolume / unionVolume : 0.0; }

  /// The gap: distances to the mesh from the part of the level's surface that is exposed, which is what is
  /// not inside another part of the level and not inside the mesh (one-sided Hausdorff distance). The
  /// surface is that at which an engine collides, margins of hulls counted. The largest one counts what a
  /// level fills of the mesh's hollows too, also where they are closed. Metres.
  double meanGap = 0.0;
  double p95Gap = 0.0;
  double maxGap = 0.0;

  /// The same where what the mesh has nearest is in each of MeasureDef::regions, and at last where it is in
  /// none of them; empty if there are no regions.
  std::vector<GapFigures> regionGaps;

  /// What a contact with this level costs relative to one with a single box.
  double predictedCost = 0.0;
};

struct LevelMeasures {
  double diagonal = 0.0;    ///< Of the mesh's bounds, metres: gaps are often given as a share of it.
  double meshVolume = 0.0;  ///< Cubic metres; 0 if the mesh is not solid.
  std::optional<SolidMass> meshMass{};  ///< Of what the mesh encloses, if massOfMesh() can tell.
  bool isSolid = true;                  ///< Whether the mesh was taken as solid.
  bool isInsideOut = false;             ///< Taken as solid only by turning all of it: it may be a room.
  std::vector<LevelFigures> levels;     ///< Coarsest first.
};

struct MeasureDef {
  std::size_t surfaceSamples = 20'000;  ///< Per level.
  std::size_t volumeSamples = 60'000;   ///< Per level.
  MeshInterior interior = MeshInterior::kAutomatic;
  std::vector<MeshRegion> regions{};
};

/// Measures the levels against the mesh. Deterministic. Fails on a mesh or regions that buildLevels() would
/// refuse.
[[nodiscard]] Result<LevelMeasures> measureLevels(const LevelSet& levels, const SurfaceMesh& mesh,
                                                  const MeasureDef& definition = {});

}  // namespace scatter
