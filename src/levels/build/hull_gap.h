#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "levels/mesh/triangle_hull.h"

namespace scatter::levels {

/// The largest value of `gapAt(point)`, a distance to something, on the surface of a hull, sampled at
/// distances of about `spacing`. As a distance changes by at most the way gone, times `steepness`, samples
/// are needed only where it can exceed the largest one so far.
template <class GapAt>
[[nodiscard]] double largestOnSurface(const TriangleHull& hull, double spacing, const GapAt& gapAt,
                                      double steepness = 1.0) {
  using Corners = std::array<glm::dvec3, 3>;
  struct Patch {
    Corners corners{};
    double bound = 0.0;
  };
  double largest = 0.0;
  std::vector<Patch> open;
  const auto sample = [&](const Corners& corners) {
    const glm::dvec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    const double gap = gapAt(middle);
    largest = std::max(largest, gap);
    double squared = 0.0;
    for (const glm::dvec3& corner : corners) {
      squared = std::max(squared, glm::dot(corner - middle, corner - middle));
    }
    const double size = std::sqrt(squared);
    const double bound = gap + steepness * size;
    if (size > spacing && bound > largest) open.push_back({corners, bound});
  };
  for (const Triangle& t : hull.triangles) {
    sample({hull.vertices[t[0]], hull.vertices[t[1]], hull.vertices[t[2]]});
  }
  while (!open.empty()) {
    const Patch patch = open.back();
    open.pop_back();
    if (patch.bound <= largest) continue;
    const auto& [a, b, c] = patch.corners;
    const double ab = glm::dot(b - a, b - a);
    const double bc = glm::dot(c - b, c - b);
    const double ca = glm::dot(a - c, a - c);
    const Corners longestFirst = ab >= bc && ab >= ca ? Corners{a, b, c}
                                 : bc >= ca           ? Corners{b, c, a}
                                                      : Corners{c, a, b};
    const glm::dvec3 half = 0.5 * (longestFirst[0] + longestFirst[1]);
    sample({longestFirst[0], half, longestFirst[2]});
    sample({half, longestFirst[1], longestFirst[2]});
  }
  return largest;
}

/// The largest value of `valueAt(point)`, a signed distance, in the inside of a hull, where it exceeds
/// `atLeast`; else that. Looked for in the middles of boxes that are halved, and left alone where they cannot
/// hold more.
template <class ValueAt>
[[nodiscard]] double largestInside(const TriangleHull& hull, double atLeast, const ValueAt& valueAt,
                                   double steepness = 1.0) {
  // Of the box around the hull: hollows wider than an eighth of it are found.
  constexpr int kHalvings = 3;
  struct Cell {
    glm::dvec3 middle{0.0};
    glm::dvec3 half{0.0};
    int halvings = 0;
  };
  const auto distanceOutside = [&hull](const glm::dvec3& point) {
    double furthest = -std::numeric_limits<double>::infinity();
    for (const HalfSpace& plane : hull.planes) furthest = std::max(furthest, plane.signedDistance(point));
    return furthest;
  };
  double largest = atLeast;
  std::vector<Cell> open{
      {0.5 * (hull.bounds.min + hull.bounds.max), 0.5 * (hull.bounds.max - hull.bounds.min), kHalvings}};
  while (!open.empty()) {
    const Cell cell = open.back();
    open.pop_back();
    const double value = valueAt(cell.middle);
    const double reach = glm::length(cell.half);
    if (value + steepness * reach <= largest) continue;
    const double outside = distanceOutside(cell.middle);
    if (outside > reach) continue;
    if (outside <= 0.0) largest = std::max(largest, value);
    if (cell.halvings == 0) continue;
    for (unsigned child = 0; child < 8; ++child) {
      const glm::dvec3 side{(child & 1U) != 0 ? 0.5 : -0.5, (child & 2U) != 0 ? 0.5 : -0.5,
                            (child & 4U) != 0 ? 0.5 : -0.5};
      open.push_back({cell.middle + side * cell.half, 0.5 * cell.half, cell.halvings - 1});
    }
  }
  return largest;
}

/// The largest value of `valueAt(point)`, a signed distance, on the surface of a hull and inside of it, where
/// it exceeds `atLeast`; else that. A hollow that the hull fills may be closed, or wider within than where
/// the hull shuts it.
template <class ValueAt>
[[nodiscard]] double largestGap(const TriangleHull& hull, double spacing, const ValueAt& valueAt,
                                double atLeast = 0.0, double steepness = 1.0) {
  const auto gapAt = [&valueAt](const glm::dvec3& point) { return std::max(0.0, valueAt(point)); };
  const double onSurface = largestOnSurface(hull, spacing, gapAt, steepness);
  return largestInside(hull, std::max(atLeast, onSurface), valueAt, steepness);
}

}  // namespace scatter::levels
