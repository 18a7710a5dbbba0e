#include "levels/measure/gap_over_mesh.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "levels/part_geometry.h"

namespace scatter::levels {
namespace {

/// Of the diagonal, by which parts are widened: places lie on their surfaces, and parts side by side touch.
constexpr double kTouch = 1e-5;

constexpr double kPlanar = 1e-9;

/// Of the diagonal: the first step away from a place, and half of how near the mesh is where it comes again.
constexpr double kStep = 1e-3;

struct Span {
  double from = 0.0;
  double to = 0.0;
  double margin = 0.0;
};

/// Where a ray is between all sides.
std::optional<Span> spanOf(const std::vector<HalfSpace>& sides, const glm::dvec3& from,
                           const glm::dvec3& direction) {
  Span span{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (const HalfSpace& side : sides) {
    const double speed = glm::dot(side.normal, direction);
    const double beyond = side.signedDistance(from);
    if (speed > 0.0) {
      span.to = std::min(span.to, -beyond / speed);
    } else if (speed < 0.0) {
      span.from = std::max(span.from, -beyond / speed);
    } else if (beyond > 0.0) {
      return std::nullopt;
    }
  }
  if (span.from > span.to) return std::nullopt;
  return span;
}

/// The largest distance between steps of which that at `way` was the largest, about.
template <class DistanceAt>
double nearby(const DistanceAt& distanceAt, double way, double largest, double end) {
  constexpr int kHalvings = 5;
  double step = 0.5 * largest;
  for (int i = 0; i < kHalvings; ++i, step *= 0.5) {
    for (const double other : {way - step, way + step}) {
      if (!(other > 0.0 && other < end)) continue;
      const double distance = distanceAt(other);
      if (distance <= largest) continue;
      largest = distance;
      way = other;
    }
  }
  return largest;
}

}  // namespace

GapOverMesh::GapOverMesh(const Level& level, double hullMargin, const MeshSpace& space)
    : space_(space), tolerance_(kTouch * space.mesh.diagonal) {
  const glm::dvec3 origin(space.mesh.origin);
  for (const ConvexPart& part : level.parts) {
    const Polytope solid = outerPolytope(part, 0.0, {}, kPlanar * space.mesh.diagonal);
    Part known;
    known.margin = marginOf(part, hullMargin);
    const DoubleBounds bounds = solid.bounds();
    known.center = 0.5 * (bounds.min + bounds.max) - origin;
    known.radius = 0.5 * glm::length(bounds.max - bounds.min) + 2.0 * tolerance_;
    for (const Polytope::Face& face : solid.faces()) {
      HalfSpace side = face.plane;
      side.offset += tolerance_ - glm::dot(side.normal, origin);
      known.sides.push_back(side);
    }
    parts_.push_back(std::move(known));
  }
}

GapOverMesh::End GapOverMesh::endOf(const glm::dvec3& from, const glm::dvec3& direction) const {
  std::vector<Span> spans;
  for (const Part& part : parts_) {
    const glm::dvec3 offset = part.center - from;
    const double way = glm::dot(offset, direction);
    const double reach = part.radius;
    if (way < -reach || glm::dot(offset, offset) - way * way > reach * reach) continue;
    if (auto span = spanOf(part.sides, from, direction)) {
      span->margin = part.margin;
      spans.push_back(*span);
    }
  }
  std::sort(spans.begin(), spans.end(), [](const Span& a, const Span& b) { return a.from < b.from; });
  End end;
  for (const Span& span : spans) {
    if (span.from > end.way) break;
    if (span.to > end.way) end = {span.to, span.margin};
  }
  return end;
}

double GapOverMesh::along(const glm::dvec3& from, const glm::dvec3& direction) const {
  const End end = endOf(from, direction);
  if (!(end.way > 0.0)) return 0.0;
  const double step = kStep * space_.mesh.diagonal;
  const auto distanceAt = [&](double way) { return space_.tree.distance(from + way * direction); };
  double furthest = 0.0;
  double largest = 0.0;
  // The mesh is no nearer than it is said to be, so that one may go as far at once.
  for (double way = step; way < end.way;) {
    const double distance = distanceAt(way);
    if (distance < 0.5 * step) return nearby(distanceAt, furthest, largest, way);
    if (distance > largest) {
      largest = distance;
      furthest = way;
    }
    way += distance;
  }
  return std::max(nearby(distanceAt, furthest, largest, end.way), distanceAt(end.way) + end.margin);
}

double GapOverMesh::at(const glm::dvec3& place, const glm::dvec3& normal) const {
  const glm::dvec3 from = place - glm::dvec3(space_.mesh.origin);
  return space_.isSolid ? along(from, normal) : std::max(along(from, normal), along(from, -normal));
}

glm::dvec3 outward(const MeshSpace& space, const glm::dvec3& place, const glm::dvec3& normal) {
  if (!space.isSolid) return normal;
  const glm::dvec3 beside =
      place - glm::dvec3(space.mesh.origin) + 0.1 * kStep * space.mesh.diagonal * normal;
  return space.isInside(beside) ? -normal : normal;
}

}  // namespace scatter::levels
