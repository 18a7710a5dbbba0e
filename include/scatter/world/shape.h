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

/// Several convex parts that move as one body.
struct Compound {
  std::vector<ConvexPart> parts;
};

/// What a body collides with. A LevelSet makes the body a hybrid; in a standard world it simply is its
/// finest level.
using Shape = std::variant<Box, Sphere, Capsule, Cylinder, ConvexHull, Plane, Compound,
                           std::shared_ptr<const TriangleMesh>, std::shared_ptr<const LevelSet>>;

}  // namespace scatter
