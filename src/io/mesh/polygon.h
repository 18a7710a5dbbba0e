#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace scatter::io {

/// Cuts a polygon of at least three corners, which may be concave and need not be quite flat, into triangles
/// of its corners (indices into `corners`), with the same winding. They cover all of a simple polygon.
/// Polygons that cross themselves or have more than 256 corners become a fan around the first corner, which
/// covers concave ones as well, but reaches beyond them.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const glm::dvec3> corners);

}  // namespace scatter::io
