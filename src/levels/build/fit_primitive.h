#pragma once

#include <scatter/levels/convex_part.h>

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "levels/build/mirror.h"
#include "levels/mesh/triangle_hull.h"

namespace scatter::levels {

/// A point and all within a radius of it.
struct Ball {
  glm::dvec3 center{0.0};
  double radius = 0.0;
};

struct FittedPrimitive {
  ConvexPart part;
  double volume = 0.0;
};

struct PrimitiveDef {
  double slack = 0.0;      ///< Left around what is held.
  double thickness = 0.0;  ///< Of the thinnest box.
  double maxVolume = 0.0;  ///< Larger ones are of no interest.

  /// If primitives are to be their own image, as the balls are; the origin is on its plane.
  std::optional<Mirror> mirror{};
};

/// Around what primitives are to be fitted, relative to an origin.
struct FitInput {
  std::span<const Ball> balls{};  ///< What is to be held.

  /// Their hulls: that of few vertices gives boxes and capsules directions, the tight one capsules and
  /// cylinders, which few vertices would turn. Neither is nullptr.
  const TriangleHull* few = nullptr;
  const TriangleHull* tight = nullptr;
};

/// Boxes, spheres, capsules and cylinders that strictly hold all balls, rounding included, smallest first.
[[nodiscard]] std::vector<FittedPrimitive> fitPrimitives(const FitInput& input, const Vec3& origin,
                                                         const PrimitiveDef& definition);

/// A few balls whose hull holds the part, margin included, relative to `origin`; a cylinder's is a prism.
[[nodiscard]] std::vector<Ball> ballsOf(const ConvexPart& part, const Vec3& origin, double hullMargin);

}  // namespace scatter::levels
