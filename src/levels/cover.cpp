#include "levels/cover.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <utility>

namespace scatter::levels {
namespace {

/// Cosine between a corner's or edge's mean normal and its faces below which it needs a plane of its own:
/// faces moved out by d meet at d divided by this.
constexpr double kSharp = 0.5;

/// Bisection stops at this share of the distance.
constexpr double kDistancePrecision = 1e-3;

/// Takes covers away from a solid, cutting it into convex pieces, until one piece is left over or none.
class Subtraction {
 public:
  Subtraction(std::span<const Cover* const> covers, double widening, double epsilon)
      : covers_(covers), widening_(widening), epsilon_(epsilon) {}

  /// A piece that no cover reaches.
  std::optional<Polytope> firstOutside(const Polytope& solid) {
    subtract(solid, 0);
    return std::move(rest_);
  }

 private:
  void subtract(const Polytope& piece, std::size_t first) {
    if (rest_) return;
    const DoubleBounds bounds = piece.bounds();
    for (std::size_t i = first; i < covers_.size(); ++i) {
      if (reaches(i, bounds) && covers_[i]->depthOutside(piece.vertices()) <= widening_ + epsilon_) return;
    }
    for (std::size_t i = first; i < covers_.size(); ++i) {
      if (!reaches(i, bounds)) continue;
      const std::optional<std::vector<Polytope>> outside = cutAway(piece, *covers_[i]);
      if (!outside) continue;
      for (const Polytope& part : *outside) subtract(part, i + 1);
      return;
    }
    rest_ = piece;
  }

  [[nodiscard]] bool reaches(std::size_t cover, const DoubleBounds& bounds) const {
    return covers_[cover]->bounds().overlaps(bounds, widening_);
  }

  /// The pieces outside the cover; nothing if all of the piece is.
  [[nodiscard]] std::optional<std::vector<Polytope>> cutAway(const Polytope& piece,
                                                             const Cover& cover) const {
    std::vector<std::pair<double, HalfSpace>> cuts;
    for (const HalfSpace& face : cover.planes()) {
      const HalfSpace plane = face.movedOut(widening_);
      const auto [low, high] = rangeAlong(piece, plane);
      if (low >= -epsilon_) return std::nullopt;
      if (high > epsilon_) cuts.emplace_back(high, plane);
    }
    // The deepest cuts come first: what they leave needs few others.
    std::stable_sort(cuts.begin(), cuts.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<Polytope> outside;
    Polytope inside = piece;
    for (const auto& [depth, plane] : cuts) {
      const auto [low, high] = rangeAlong(inside, plane);
      if (low >= -epsilon_) return std::nullopt;
      if (high <= epsilon_) continue;
      Polytope beyond = inside.clipped(plane.flipped(), epsilon_);
      if (!beyond.isEmpty()) outside.push_back(std::move(beyond));
      inside = inside.clipped(plane, epsilon_);
      if (inside.isEmpty()) return std::nullopt;
    }
    return outside;
  }

  static std::pair<double, double> rangeAlong(const Polytope& piece, const HalfSpace& plane) {
    std::pair<double, double> range{std::numeric_limits<double>::infinity(),
                                    -std::numeric_limits<double>::infinity()};
    for (const glm::dvec3& vertex : piece.vertices()) {
      const double distance = plane.signedDistance(vertex);
      range = {std::min(range.first, distance), std::max(range.second, distance)};
    }
    return range;
  }

  std::span<const Cover* const> covers_;
  double widening_;
  double epsilon_;
  std::optional<Polytope> rest_;
};

std::optional<Polytope> firstOutside(const Polytope& solid, std::span<const Cover* const> covers,
                                     double widening, double epsilon) {
  return Subtraction(covers, widening, epsilon).firstOutside(solid);
}

double overlapVolume(const DoubleBounds& a, const DoubleBounds& b) {
  const glm::dvec3 size = glm::max(glm::min(a.max, b.max) - glm::max(a.min, b.min), glm::dvec3(0.0));
  return size.x * size.y * size.z;
}

/// Those that take most away come first, so that few pieces arise.
std::vector<const Cover*> inOrderOfOverlap(std::span<const Cover> covers, const DoubleBounds& bounds) {
  std::vector<std::pair<double, const Cover*>> ranked;
  for (const Cover& cover : covers) ranked.emplace_back(overlapVolume(cover.bounds(), bounds), &cover);
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<const Cover*> ordered;
  ordered.reserve(ranked.size());
  for (const auto& [volume, cover] : ranked) ordered.push_back(cover);
  return ordered;
}

/// How far the nearest cover's planes must move out to hold all points.
double depthOutside(std::span<const glm::dvec3> points, std::span<const Cover* const> covers) {
  double least = std::numeric_limits<double>::infinity();
  for (const Cover* cover : covers) least = std::min(least, cover->depthOutside(points));
  return least;
}

double distanceToUnion(const glm::dvec3& point, std::span<const Cover* const> covers) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Cover* cover : covers) {
    if (cover->depthOutside(point) < nearest) nearest = std::min(nearest, cover->solid().distance(point));
  }
  return nearest;
}

/// Searches for the point of a solid that is furthest from the union of the covers: the last to be covered
/// when all of them are widened together.
class FurthestPoint {
 public:
  FurthestPoint(std::span<const Cover* const> covers, double epsilon) : covers_(covers), epsilon_(epsilon) {}

  /// `outside` is any piece of the solid outside the covers widened by `low`.
  Uncovered find(const Polytope& solid, const Polytope& outside, double low) {
    low = std::max(low, tryVertices(outside));
    low = std::max(low, tryVertices(solid));
    double high = depthOutside(solid.vertices(), covers_);
    while (high - low > kDistancePrecision * high + epsilon_) {
      const double middle = 0.5 * (low + high);
      const std::optional<Polytope> piece = firstOutside(solid, covers_, middle, epsilon_);
      if (piece)
        low = std::max(middle, tryVertices(*piece));
      else
        high = middle;
    }
    return furthest_;
  }

 private:
  /// Their largest depth.
  double tryVertices(const Polytope& piece) {
    double depth = 0.0;
    for (const glm::dvec3& vertex : piece.vertices()) {
      depth = std::max(depth, depthOutside(std::span(&vertex, 1), covers_));
      const double distance = distanceToUnion(vertex, covers_);
      if (distance > furthest_.distance) furthest_ = {vertex, distance};
    }
    return depth;
  }

  std::span<const Cover* const> covers_;
  double epsilon_;
  Uncovered furthest_{glm::dvec3(0.0), -1.0};
};

}  // namespace

Cover::Cover(Polytope solid) : solid_(std::move(solid)), bounds_(solid_.bounds()) {
  assert(!solid_.isEmpty());
  for (const Polytope::Face& face : solid_.faces()) planes_.push_back(face.plane);
  addBevels();
}

void Cover::addBevels() {
  // An edge is listed under its two vertices, a corner under one vertex twice.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<glm::dvec3>> normals;
  for (const Polytope::Face& face : solid_.faces()) {
    const auto corners = solid_.loop(face);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::uint32_t next = corners[i + 1 < corners.size() ? i + 1 : 0];
      normals[std::minmax({corners[i], next})].push_back(face.plane.normal);
      normals[{corners[i], corners[i]}].push_back(face.plane.normal);
    }
  }
  for (const auto& [feature, around] : normals) {
    glm::dvec3 mean{0.0};
    for (const glm::dvec3& normal : around) mean += normal;
    if (!(glm::length(mean) > 0.0)) continue;
    mean = glm::normalize(mean);
    const bool isSharp = std::any_of(around.begin(), around.end(), [&mean](const glm::dvec3& normal) {
      return glm::dot(mean, normal) < kSharp;
    });
    if (!isSharp) continue;
    double offset = -std::numeric_limits<double>::infinity();
    for (const glm::dvec3& vertex : solid_.vertices()) offset = std::max(offset, glm::dot(mean, vertex));
    planes_.push_back({mean, offset});
  }
}

double Cover::depthOutside(const glm::dvec3& point) const {
  double depth = -std::numeric_limits<double>::infinity();
  for (const HalfSpace& plane : planes_) depth = std::max(depth, plane.signedDistance(point));
  return depth;
}

double Cover::depthOutside(std::span<const glm::dvec3> points) const {
  double depth = -std::numeric_limits<double>::infinity();
  for (const glm::dvec3& point : points) depth = std::max(depth, depthOutside(point));
  return depth;
}

bool isCovered(const Polytope& solid, std::span<const Cover> covers, double tolerance, double epsilon) {
  assert(!solid.isEmpty() && !covers.empty());
  return !firstOutside(solid, inOrderOfOverlap(covers, solid.bounds()), tolerance, epsilon);
}

std::optional<Uncovered> findUncovered(const Polytope& solid, std::span<const Cover> covers, double tolerance,
                                       double epsilon) {
  assert(!solid.isEmpty() && !covers.empty());
  const std::vector<const Cover*> ordered = inOrderOfOverlap(covers, solid.bounds());
  const std::optional<Polytope> outside = firstOutside(solid, ordered, tolerance, epsilon);
  if (!outside) return std::nullopt;
  return FurthestPoint(ordered, epsilon).find(solid, *outside, tolerance);
}

}  // namespace scatter::levels
