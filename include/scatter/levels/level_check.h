#pragma once

#include <scatter/levels/level_set.h>
#include <scatter/levels/surface_mesh.h>
#include <scatter/result.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace scatter {

/// The place where something sticks out of a level furthest.
struct Protrusion {
  std::size_t index = 0;  ///< Of the mesh's triangle, or of the finer level's part.
  Vec3 point{0.0F};       ///< In the model's frame.
  double distance = 0.0;  ///< From the level to the point, metres; at least 99.9 % of the largest one.
};

/// Whether one level holds what it should.
struct EnclosureCheck {
  std::size_t count = 0;    ///< Triangles, or parts of the finer level.
  std::size_t outside = 0;  ///< How many of them stick out.

  /// How many lie in no single part but in several together.
  std::size_t shared = 0;

  /// How far inside the others are at least, metres: the least, over them, of their distance from the
  /// surface of the part that holds them best. Negative if that is within the tolerance; 0 without any.
  double clearance = 0.0;
  double areaOutside = 0.0;  ///< Of the mesh that sticks out, as a share of its area; 0 for parts.
  std::optional<Protrusion> worst{};
};

struct LevelCheckDef {
  /// Metres by which something may stick out; if absent, a hundred-thousandth of the finest level's diagonal.
  std::optional<double> tolerance{};
};

/// The proof that levels are nested, or where they are not.
struct LevelCheck {
  double tolerance = 0.0;                ///< Metres.
  std::optional<EnclosureCheck> mesh{};  ///< In the finest level without its margin; absent without mesh.

  /// Each level in the next coarser one, margins counted: levels[0] is level 2 in level 1.
  std::vector<EnclosureCheck> levels{};

  [[nodiscard]] bool passed() const;
};

/// Proves, without regard to how the levels were made, that `mesh` (if not null) lies inside the finest
/// level and each level inside the coarser one, or says where not. Nothing is sampled: a triangle is inside
/// if all its corners are in one part, or if cutting it along the planes of the parts leaves nothing; what
/// several round parts hold together is cut in halves down to a ten-thousandth of the diagonal. Levels are
/// given coarsest first and need not be nested. Fails on a part that is no solid, a mesh with an index out of
/// range or a coordinate that is not finite, and a tolerance or margin that is negative or not finite.
[[nodiscard]] Result<LevelCheck> checkLevels(const std::vector<Level>& levels, float hullMargin,
                                             const SurfaceMesh* mesh, const LevelCheckDef& definition = {});

}  // namespace scatter
