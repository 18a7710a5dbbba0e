#pragma once

#include <scatter/math.h>

#include <array>
#include <cstdint>
#include <vector>

namespace scatter {

/// Triangles in the model's frame, metres, counter-clockwise seen from outside. It may be open, hold
/// several shells and repeat vertices.
struct SurfaceMesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Indices into `vertices`.
};

}  // namespace scatter
