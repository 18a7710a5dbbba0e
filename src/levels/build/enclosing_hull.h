#pragma once

#include <scatter/math.h>

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "levels/build/mirror.h"
#include "levels/mesh/triangle_hull.h"

namespace scatter::levels {

struct EnclosingHullDef {
  double diagonal = 1.0;  ///< Of the mesh; tolerances are shares of it.
  int maxVertices = 16;

  /// If the hull is to be its own image, as the points are.
  std::optional<Mirror> mirror{};
};

/// A hull of few vertices, rounded to single precision, that strictly holds all points, proven by
/// provesInside(). It is at least 1e-4 of the diagonal thick.
[[nodiscard]] TriangleHull encloseInHull(HullBuilder& builder, std::span<const glm::dvec3> points,
                                         const EnclosingHullDef& definition);

}  // namespace scatter::levels
