#include "levels/check/furthest_outside.h"

#include <algorithm>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <queue>
#include <utility>

namespace scatter::levels {
namespace {

constexpr double kPrecision = 1e-3;

/// Ends the search where parts without number meet; what was found till then stands.
constexpr std::size_t kMostPieces = 20'000;

double distanceFromBounds(const DoubleBounds& bounds, const glm::dvec3& point) {
  return glm::length(glm::max(glm::max(bounds.min - point, point - bounds.max), glm::dvec3(0.0)));
}

/// At least the distance of every point of the piece from the union: distances from one part are convex, so
/// that none exceeds the largest one of the corners.
double boundOf(const Piece& piece, std::span<const SolidPart> parts) {
  double bound = std::numeric_limits<double>::infinity();
  for (const SolidPart& part : parts) {
    double largest = 0.0;
    for (const glm::dvec3& corner : piece) {
      largest = std::max(largest, distanceFromBounds(part.bounds(), corner));
    }
    if (largest >= bound) continue;
    for (const glm::dvec3& corner : piece) {
      if (largest < bound) largest = std::max(largest, part.distance(corner));
    }
    bound = std::min(bound, largest);
  }
  return bound;
}

/// A piece and a bound to the distance of all its points.
struct Candidate {
  double bound = 0.0;
  Piece piece;

  bool operator<(const Candidate& other) const { return bound < other.bound; }
};

}  // namespace

double distanceFrom(std::span<const SolidPart> parts, const glm::dvec3& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const SolidPart& part : parts) {
    if (distanceFromBounds(part.bounds(), point) < nearest) nearest = std::min(nearest, part.distance(point));
  }
  return nearest;
}

void findFurthest(const std::vector<Piece>& pieces, std::span<const SolidPart> parts, double resolution,
                  FarPoint& furthest) {
  std::priority_queue<Candidate> queue;
  const auto examine = [&](Piece piece) {
    if (piece.empty()) return;
    const double bound = boundOf(piece, parts);
    if (bound <= furthest.distance * (1.0 + kPrecision) + resolution) return;
    for (const glm::dvec3& corner : piece) {
      const double distance = distanceFrom(parts, corner);
      if (distance > furthest.distance) furthest = {corner, distance};
    }
    queue.push({bound, std::move(piece)});
  };
  for (const Piece& piece : pieces) examine(piece);
  for (std::size_t count = 0; !queue.empty() && count < kMostPieces; ++count) {
    const Candidate widest = queue.top();
    queue.pop();
    if (widest.bound <= furthest.distance * (1.0 + kPrecision) + resolution) return;
    auto [first, second] = halves(widest.piece);
    examine(std::move(first));
    examine(std::move(second));
  }
}

}  // namespace scatter::levels
