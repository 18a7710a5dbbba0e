#pragma once

#include <scatter/levels/level_set.h>

#include <optional>
#include <vector>

namespace scatter {

/// A plane across a coordinate axis of the model's frame.
struct SymmetryPlane {
  int axis = 0;
  float offset = 0.0F;  ///< The coordinate of its points, metres.
};

/// How the parts of a level are their own mirror image together.
struct SymmetricParts {
  int pairs = 0;  ///< Of parts that are each other's image.
  int own = 0;    ///< Parts that are their own image.
};

struct LevelSymmetry {
  SymmetryPlane plane;
  std::vector<SymmetricParts> levels;  ///< The coarsest first.
};

/// The plane that all levels are mirror symmetric about: every part has its image among the parts of its
/// level, to within 1e-6 of the diagonal. Planes go through the middle of the finest level's bounds; of
/// several, that across x comes first, then z. Nothing if there is none.
[[nodiscard]] std::optional<LevelSymmetry> symmetryOf(const LevelSet& levels);

}  // namespace scatter
