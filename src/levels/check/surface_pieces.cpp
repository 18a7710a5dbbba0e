#include "levels/check/surface_pieces.h"

#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>

namespace scatter::levels {
namespace {

/// Rounding of the cutting, as a share of the widening's scale: see cutAway().
constexpr double kEpsilonShare = 1e-3;

/// The parts of a piece on both sides of a plane; those without extent across it are empty.
struct Split {
  Piece inside;
  Piece outside;
};

Split split(const Piece& piece, const HalfSpace& plane, double epsilon) {
  std::vector<double> heights;
  heights.reserve(piece.size());
  for (const glm::dvec3& corner : piece) heights.push_back(plane.signedDistance(corner));
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  if (*high <= epsilon) return {piece, {}};
  if (*low >= -epsilon) return {{}, piece};
  Split parts;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const std::size_t next = i + 1 < piece.size() ? i + 1 : 0;
    const double a = heights[i];
    const double b = heights[next];
    if (a <= 0.0) parts.inside.push_back(piece[i]);
    if (a >= 0.0) parts.outside.push_back(piece[i]);
    if ((a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0)) {
      const glm::dvec3 crossing = piece[i] + a / (a - b) * (piece[next] - piece[i]);
      parts.inside.push_back(crossing);
      parts.outside.push_back(crossing);
    }
  }
  return parts;
}

/// Halves a piece until each half is in one of some convex parts, or one of its corners is in none.
class Halving {
 public:
  Halving(std::span<const SolidPart* const> parts, double widening, double resolution)
      : parts_(parts), widening_(widening), resolution_(resolution) {}

  void cover(const Piece& piece, std::vector<Piece>& outside) const {
    for (const SolidPart* part : parts_) {
      if (part->depthOutside(piece) <= widening_) return;
    }
    const bool isOut = std::any_of(piece.begin(), piece.end(), [this](const glm::dvec3& corner) {
      return std::all_of(parts_.begin(), parts_.end(),
                         [&](const SolidPart* part) { return part->depthOutside(corner) > widening_; });
    });
    if (isOut) {
      outside.push_back(piece);
      return;
    }
    if (radiusOf(piece).first < resolution_) return;
    const auto [first, second] = halves(piece);
    cover(first, outside);
    cover(second, outside);
  }

 private:
  std::span<const SolidPart* const> parts_;
  double widening_;
  double resolution_;
};

}  // namespace

double areaOf(const Piece& piece) {
  glm::dvec3 sum{0.0};
  for (std::size_t i = 1; i + 1 < piece.size(); ++i) {
    sum += glm::cross(piece[i] - piece[0], piece[i + 1] - piece[0]);
  }
  return 0.5 * glm::length(sum);
}

std::pair<double, glm::dvec3> radiusOf(const Piece& piece) {
  glm::dvec3 mean{0.0};
  for (const glm::dvec3& corner : piece) mean += corner / static_cast<double>(piece.size());
  double radius = 0.0;
  for (const glm::dvec3& corner : piece) radius = std::max(radius, glm::length(corner - mean));
  return {radius, mean};
}

std::pair<Piece, Piece> halves(const Piece& piece) {
  double longest = -1.0;
  HalfSpace plane;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    // Not only edges: a slim quadrilateral is cut across its diagonal.
    for (std::size_t k = 0; k < i; ++k) {
      const glm::dvec3 line = piece[i] - piece[k];
      const double length = glm::length(line);
      if (length <= longest) continue;
      longest = length;
      plane.normal = length > 0.0 ? line / length : glm::dvec3(1.0, 0.0, 0.0);
      plane.offset = glm::dot(plane.normal, 0.5 * (piece[i] + piece[k]));
    }
  }
  Split parts = split(piece, plane, 0.0);
  return {std::move(parts.inside), std::move(parts.outside)};
}

std::vector<Piece> cutAway(const Piece& piece, const SolidPart& part, double widening, double epsilon) {
  std::vector<Piece> outside;
  Piece inside = piece;
  for (const HalfSpace& plane : part.planes()) {
    Split parts = split(inside, plane.movedOut(widening), epsilon);
    if (parts.inside.empty()) return {piece};
    if (!parts.outside.empty()) outside.push_back(std::move(parts.outside));
    inside = std::move(parts.inside);
  }
  return outside;
}

std::vector<Piece> cutAway(const Piece& piece, std::span<const SolidPart* const> parts, double widening,
                           double resolution) {
  std::vector<Piece> left{piece};
  std::vector<const SolidPart*> round;
  for (const SolidPart* part : parts) {
    if (!part->isFlatSided()) {
      round.push_back(part);
      continue;
    }
    std::vector<Piece> next;
    for (const Piece& one : left) {
      for (Piece& rest : cutAway(one, *part, widening, kEpsilonShare * widening))
        next.push_back(std::move(rest));
    }
    left = std::move(next);
  }
  if (round.empty()) return left;
  std::vector<Piece> outside;
  const Halving halving(round, widening, resolution);
  for (const Piece& one : left) halving.cover(one, outside);
  return outside;
}

}  // namespace scatter::levels
