#pragma once

#include <scatter/levels/convex_part.h>
#include <scatter/levels/level_set.h>

#include <array>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

namespace scatter {

/// The half-space normal · x <= offset is solid. Static bodies only.
struct Plane {
  Vec3 normal{0.0F, 1.0F, 0.0F};
  float offset = 0.0F;
};

/// Static bodies only.
struct TriangleMesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Heights above a grid of points whose middle is the origin. Static bodies only. A cell is two triangles;
/// they share the edge from its corner with the least x and the largest z to the one across.
struct HeightField {
  std::uint32_t columns = 2;   ///< Points along x, at least 2.
  std::uint32_t rows = 2;      ///< Points along z, at least 2.
  float spacingX = 1.0F;       ///< Metres from one column to the next.
  float spacingZ = 1.0F;       ///< Metres from one row to the next.
  std::vector<float> heights;  ///< Metres along y; row after row, each from the least x on.

  /// The point in this column and row, counted from 0.
  [[nodiscard]] Vec3 point(std::uint32_t column, std::uint32_t row) const;
};

/// The surface of a height field; its triangles are counter-clockwise seen from above.
[[nodiscard]] TriangleMesh trianglesOf(const HeightField& field);

/// Several convex parts that move as one body.
struct Compound {
  std::vector<ConvexPart> parts;
};

/// What a body collides with. A LevelSet makes the body a hybrid; in a standard world it simply is its
/// finest level.
using Shape = std::variant<Box, Sphere, Capsule, Cylinder, ConvexHull, Plane, Compound,
                           std::shared_ptr<const TriangleMesh>, std::shared_ptr<const HeightField>,
                           std::shared_ptr<const LevelSet>>;

}  // namespace scatter
