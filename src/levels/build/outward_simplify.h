#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "levels/build/mirror.h"
#include "levels/mesh/triangle_hull.h"

namespace scatter::levels {

struct SimplifyDef {
  int maxVertices = 16;
  std::optional<Mirror>
      mirror{};  ///< If the result is to be its own image, to within rounding, as the hull is.
};

/// Points whose hull has at most `maxVertices` vertices, holds `hull` to within rounding and exceeds it
/// little; nothing if rounding defeats it.
[[nodiscard]] std::optional<TriangleHull> simplifyOutward(HullBuilder& builder, const TriangleHull& hull,
                                                          const SimplifyDef& definition);

}  // namespace scatter::levels
