#pragma once

#include <scatter/levels/level_set.h>

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "levels/mesh/triangle_hull.h"
#include "levels/part_geometry.h"

namespace scatter::levels {

/// The surface of a level to be sampled: hulls without their margin. Places are relative to an origin.
class LevelSurface {
 public:
  LevelSurface(const Level& level, const glm::dvec3& origin);

  struct Sample {
    glm::dvec3 point{0.0};
    std::size_t part = 0;
    glm::dvec3 normal{0.0};  ///< Of the face, outward; zero at a corner, which has none.
  };

  /// Evenly spread over the surfaces of all parts.
  [[nodiscard]] std::vector<Sample> samples(std::size_t count) const;

  /// The corners of boxes and hulls.
  [[nodiscard]] std::vector<Sample> corners() const;

  /// By how much an engine widens the part, metres.
  [[nodiscard]] double marginOf(std::size_t part, double hullMargin) const {
    return levels::marginOf(parts_[part].part, hullMargin);
  }

  /// Whether a part other than `except` holds the point with `depth` to spare.
  [[nodiscard]] bool isCovered(const glm::dvec3& point, double depth, std::size_t except) const;

  /// Points that fill the box around the level evenly, and of those the ones in some part.
  struct Filling {
    std::vector<glm::dvec3> points;
    double volume = 0.0;  ///< Of the union of the parts, by how many of the box's points it holds.
  };
  [[nodiscard]] Filling filling(std::size_t sampleCount) const;

 private:
  struct PartSurface {
    ConvexPart part;
    DoublePose pose;
    TriangleHull hull;  ///< Of a round part, a polytope with its corners on the surface.
  };

  [[nodiscard]] static bool holds(const PartSurface& surface, const glm::dvec3& point, double depth);

  std::vector<PartSurface> parts_;
};

}  // namespace scatter::levels
