#pragma once

#include <scatter/math.h>

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "levels/mesh/triangle_hull.h"

namespace scatter::levels {

struct EnclosingHullDef {
  double diagonal = 1.0;  ///< Of the mesh; tolerances are shares of it.
  int maxVertices = 16;
};

/// A hull of few vertices, rounded to single precision, that strictly holds all points, proven by
/// provesInside(). It is at least 1e-4 of the diagonal thick.
[[nodiscard]] TriangleHull encloseInHull(HullBuilder& builder, std::span<const glm::dvec3> points,
                                         const EnclosingHullDef& definition);

}  // namespace scatter::levels
