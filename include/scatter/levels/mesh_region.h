#pragma once

#include <scatter/math.h>

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace scatter {

/// A part of a mesh where detail is worth more, or less, than elsewhere. Where several overlap, the largest
/// weight counts; where there is none, it is 1.
struct MeshRegion {
  std::string name;  ///< In messages.

  /// A box in the model's frame, or triangles, by their indices. In the box is what of the mesh is in it,
  /// also of triangles that reach beyond.
  std::variant<Bounds, std::vector<std::uint32_t>> extent;

  /// A gap of g metres between a level and this part of the mesh counts as weight times g; 0.01 to 100.
  float weight = 1.0F;

  /// Parts that hold triangles of this region hold no others, while parts last. A triangle is in a box if its
  /// middle is.
  bool isKept = false;
};

/// Of a region that is to be as close as the finest parts allow, unless somebody knows better.
inline constexpr float kKeptWeight = 8.0F;

}  // namespace scatter
