#include "collision/reference_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <utility>

namespace scatter::testing {

namespace {

using Corners = std::vector<glm::dvec3>;

// Gaussian elimination with pivots; nothing if the corners do not span a simplex.
std::optional<std::array<double, 3>> solve(std::array<std::array<double, 4>, 3> rows, std::size_t count) {
  for (std::size_t column = 0; column < count; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column + 1; row < count; ++row) {
      if (std::abs(rows[row][column]) > std::abs(rows[pivot][column])) pivot = row;
    }
    if (rows[pivot][column] == 0.0) return std::nullopt;
    std::swap(rows[pivot], rows[column]);
    for (std::size_t row = 0; row < count; ++row) {
      if (row == column) continue;
      const double factor = rows[row][column] / rows[column][column];
      for (std::size_t k = column; k < 4; ++k) rows[row][k] -= factor * rows[column][k];
    }
  }
  std::array<double, 3> solution{};
  for (std::size_t i = 0; i < count; ++i) solution[i] = rows[i][3] / rows[i][i];
  return solution;
}

// The point of the corners' plane (or line) that is nearest to the origin, if it is between the corners.
std::optional<glm::dvec3> nearestBetween(const Corners& corners) {
  const std::size_t edges = corners.size() - 1;
  std::array<std::array<double, 4>, 3> rows{};
  for (std::size_t i = 0; i < edges; ++i) {
    const glm::dvec3 edge = corners[i + 1] - corners[0];
    for (std::size_t j = 0; j < edges; ++j) rows[i][j] = glm::dot(edge, corners[j + 1] - corners[0]);
    rows[i][3] = -glm::dot(edge, corners[0]);
  }
  const auto weights = solve(rows, edges);
  if (!weights) return std::nullopt;
  double sum = 0.0;
  glm::dvec3 point = corners[0];
  for (std::size_t i = 0; i < edges; ++i) {
    const double weight = (*weights)[i];
    if (!(weight >= 0.0)) return std::nullopt;
    sum += weight;
    point += weight * (corners[i + 1] - corners[0]);
  }
  return sum <= 1.0 ? std::optional(point) : std::nullopt;
}

// Leaves the corners that hold the nearest point.
glm::dvec3 nearestOf(Corners& corners) {
  double best2 = std::numeric_limits<double>::max();
  glm::dvec3 best(0.0);
  Corners kept;
  for (unsigned subset = 1; subset < 1U << corners.size(); ++subset) {
    Corners some;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if ((subset >> i & 1U) != 0) some.push_back(corners[i]);
    }
    const auto point = nearestBetween(some);
    if (!point || glm::dot(*point, *point) >= best2) continue;
    best2 = glm::dot(*point, *point);
    best = *point;
    kept = std::move(some);
  }
  corners = kept;
  return best;
}

const glm::dvec3& furthest(const Points& points, const glm::dvec3& direction) {
  const auto isLess = [&](const glm::dvec3& p, const glm::dvec3& q) {
    return glm::dot(p, direction) < glm::dot(q, direction);
  };
  return *std::max_element(points.begin(), points.end(), isLess);
}

}  // namespace

DistanceBounds referenceDistance(const Points& a, const Points& b) {
  Corners corners{a[0] - b[0]};
  DistanceBounds bounds{0.0, std::numeric_limits<double>::max(), glm::dvec3(0.0)};
  constexpr int kMaxIterations = 200;
  for (int i = 0; i < kMaxIterations; ++i) {
    const glm::dvec3 nearest = nearestOf(corners);
    const double distance = glm::length(nearest);
    bounds.upper = std::min(bounds.upper, distance);
    if (corners.size() == 4 || distance == 0.0) break;
    const glm::dvec3 axis = -nearest / distance;
    const glm::dvec3 next = furthest(a, axis) - furthest(b, -axis);
    const double proven = -glm::dot(axis, next);
    if (proven > bounds.lower) {
      bounds.lower = proven;
      bounds.axis = axis;
    }
    const bool isAgain = std::find(corners.begin(), corners.end(), next) != corners.end();
    if (isAgain || bounds.upper - bounds.lower <= 1e-13 * bounds.upper) break;
    corners.push_back(next);
  }
  return bounds;
}

glm::dvec3 placed(const Frame& frame, const Vec3& point) {
  const glm::dvec3 p(point);
  const auto row = [&](int i) { return glm::dot(glm::dvec3(frame.row[i]), p); };
  return glm::dvec3(row(0), row(1), row(2)) + glm::dvec3(frame.origin);
}

Points placed(const Frame& frame, const PolytopeView& polytope) {
  Points points;
  for (int i = 0; i < polytope.count; ++i) points.push_back(placed(frame, polytope.vertex(i)));
  return points;
}

}  // namespace scatter::testing
