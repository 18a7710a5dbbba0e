#include "levels/part_geometry.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <numbers>
#include <utility>
#include <variant>

#include "levels/convex_hull.h"

namespace scatter::levels {
namespace {

/// Sides of the polytopes that stand for round shapes, and for the rounding of a hull by its margin.
constexpr int kRoundSegments = 32;
constexpr int kMarginSegments = 12;

/// Unit vectors on a grid of meridians and parallels around the y axis.
std::vector<glm::dvec3> ballDirections(int segments) {
  std::vector<glm::dvec3> directions{{0.0, 1.0, 0.0}, {0.0, -1.0, 0.0}};
  const double step = 2.0 * std::numbers::pi / segments;
  for (int ring = 1; ring < segments / 2; ++ring) {
    for (int side = 0; side < segments; ++side) {
      const double around = std::sin(ring * step);
      directions.emplace_back(around * std::cos(side * step), std::cos(ring * step),
                              around * std::sin(side * step));
    }
  }
  return directions;
}

/// By how much the grid must grow to hold the unit ball. Half a cell's diagonal is at most
/// √2 π / segments, so that a circle through the corners of an empty cell lies at its cosine.
double circumscribing(int segments) {
  return 1.0 / std::cos(std::numbers::sqrt2 * std::numbers::pi / segments);
}

/// The corners of a regular polygon; those across an axis are exact images of each other.
std::vector<glm::dvec2> polygonPoints(double radius, int sides) {
  assert(sides % 4 == 0);
  std::vector<glm::dvec2> points{{radius, 0.0}, {-radius, 0.0}, {0.0, radius}, {0.0, -radius}};
  for (int side = 1; side < sides / 4; ++side) {
    const double angle = 2.0 * std::numbers::pi * side / sides;
    const double x = radius * std::cos(angle);
    const double y = radius * std::sin(angle);
    points.insert(points.end(), {{x, y}, {-x, y}, {x, -y}, {-x, -y}});
  }
  return points;
}

std::vector<glm::dvec3> prismPoints(double radius, double halfHeight, int sides, const DoublePose& pose) {
  std::vector<glm::dvec3> points;
  for (const glm::dvec2& rim : polygonPoints(radius, sides)) {
    for (const double y : {-halfHeight, halfHeight}) points.push_back(pose({rim.x, y, rim.y}));
  }
  return points;
}

/// Empty if the points span no volume.
Polytope hullOrNothing(std::span<const glm::dvec3> points) {
  Result<Polytope> hull = convexHull(points);
  return hull ? std::move(*hull) : Polytope();
}

/// The hull of balls, or rather of polytopes in (scale 1) or around them, at the given points.
Polytope hullOfBalls(std::span<const glm::dvec3> centers, double radius, int segments,
                     const glm::dmat3& rotation) {
  const std::vector<glm::dvec3> directions = ballDirections(segments);
  std::vector<glm::dvec3> points;
  points.reserve(centers.size() * directions.size());
  for (const glm::dvec3& center : centers) {
    for (const glm::dvec3& direction : directions) points.push_back(center + radius * (rotation * direction));
  }
  return hullOrNothing(points);
}

/// Every face of the hull moved out by the margin, the slopes between them left straight.
Polytope withFlatMargin(const Polytope& core, double margin) {
  std::vector<glm::dvec3> points;
  for (const Polytope::Face& face : core.faces()) {
    for (const std::uint32_t vertex : core.loop(face)) {
      points.push_back(core.vertices()[vertex] + margin * face.plane.normal);
    }
  }
  return hullOrNothing(points);
}

struct RoundedHullOf {
  const DoublePose& pose;
  double hullMargin;

  RoundedHull operator()(const Box& box) const {
    return {Polytope::box(pose.position, pose.rotation, glm::dvec3(box.halfExtents)).vertices(), 0.0};
  }
  RoundedHull operator()(const Sphere& sphere) const { return {{pose.position}, toDouble(sphere.radius)}; }
  RoundedHull operator()(const Capsule& capsule) const {
    const double h = toDouble(capsule.halfHeight);
    return {{pose({0.0, -h, 0.0}), pose({0.0, h, 0.0})}, toDouble(capsule.radius)};
  }
  RoundedHull operator()(const Cylinder& cylinder) const { return {prismAround(cylinder, pose), 0.0}; }
  RoundedHull operator()(const ConvexHull& hull) const {
    std::vector<glm::dvec3> points;
    points.reserve(hull.vertices.size());
    for (const Vec3& vertex : hull.vertices) points.push_back(pose(glm::dvec3(vertex)));
    return {std::move(points), hullMargin};
  }
};

/// Along a direction in the part's own frame, from its own origin.
struct SupportOf {
  const glm::dvec3& direction;
  double hullMargin;

  double operator()(const Box& box) const {
    return glm::dot(glm::abs(direction), glm::dvec3(box.halfExtents));
  }
  double operator()(const Sphere& sphere) const { return toDouble(sphere.radius); }
  double operator()(const Capsule& capsule) const {
    return std::abs(direction.y) * toDouble(capsule.halfHeight) + toDouble(capsule.radius);
  }
  double operator()(const Cylinder& cylinder) const {
    return std::abs(direction.y) * toDouble(cylinder.halfHeight) +
           std::hypot(direction.x, direction.z) * toDouble(cylinder.radius);
  }
  double operator()(const ConvexHull& hull) const {
    double furthest = -std::numeric_limits<double>::infinity();
    for (const Vec3& vertex : hull.vertices) {
      furthest = std::max(furthest, glm::dot(direction, glm::dvec3(vertex)));
    }
    return furthest + hullMargin;
  }
};

/// Along the part's own axes.
Polytope boundingBox(const ConvexPart& part, double hullMargin) {
  const glm::dmat3 axes = DoublePose(part.pose).rotation;
  glm::dvec3 center{0.0};
  glm::dvec3 half{0.0};
  for (int axis = 0; axis < 3; ++axis) {
    const double up = support(part, hullMargin, axes[axis]);
    const double down = -support(part, hullMargin, -axes[axis]);
    center += 0.5 * (up + down) * axes[axis];
    half[axis] = 0.5 * (up - down);
  }
  return Polytope::box(center, axes, half);
}

struct InnerPolytopeOf {
  const ConvexPart& part;
  const DoublePose& pose;
  double hullMargin;
  double inset;

  Polytope operator()(const Box& box) const {
    const glm::dvec3 half = glm::dvec3(box.halfExtents) - glm::dvec3(inset);
    if (!(half.x > 0.0 && half.y > 0.0 && half.z > 0.0)) return {};
    return Polytope::box(pose.position, pose.rotation, half);
  }
  Polytope operator()(const Sphere&) const { return balls(); }
  Polytope operator()(const Capsule&) const { return balls(); }
  Polytope operator()(const Cylinder& cylinder) const {
    const double radius = toDouble(cylinder.radius) - inset;
    const double halfHeight = toDouble(cylinder.halfHeight) - inset;
    if (!(radius > 0.0 && halfHeight > 0.0)) return {};
    return hullOrNothing(prismPoints(radius, halfHeight, kRoundSegments, pose));
  }
  Polytope operator()(const ConvexHull& hull) const {
    Result<Polytope> core = placedHull(hull, part.pose);
    if (!core) return {};
    if (!(inset < hullMargin)) return std::move(*core);
    Polytope widened = withFlatMargin(*core, hullMargin);
    return widened.isEmpty() ? std::move(*core) : std::move(widened);
  }

 private:
  [[nodiscard]] Polytope balls() const {
    const RoundedHull exact = roundedHull(part, hullMargin);
    if (!(exact.radius > inset)) return {};
    return hullOfBalls(exact.points, exact.radius - inset, kRoundSegments, pose.rotation);
  }
};

}  // namespace

DoublePose::DoublePose(const Transform& pose)
    : position(pose.position), rotation(glm::mat3_cast(glm::normalize(glm::dquat(pose.rotation)))) {}

Result<Polytope> placedHull(const ConvexHull& hull, const Transform& pose) {
  float largest = 0.0F;
  for (const Vec3& v : hull.vertices)
    largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  const double rounding = 4.0 * toDouble(std::numeric_limits<float>::epsilon() * largest);
  Result<Polytope> polytope = convexHull(RoundedHullOf{DoublePose(pose), 0.0}(hull).points, rounding);
  if (!polytope) return fail("convex hull: " + polytope.error().message);
  return polytope;
}

std::vector<glm::dvec3> prismAround(const Cylinder& cylinder, const DoublePose& pose) {
  const double around = toDouble(cylinder.radius) / std::cos(std::numbers::pi / kRoundSegments);
  return prismPoints(around, toDouble(cylinder.halfHeight), kRoundSegments, pose);
}

std::vector<glm::dvec3> prismIn(const Cylinder& cylinder, int sides, const DoublePose& pose) {
  return prismPoints(toDouble(cylinder.radius), toDouble(cylinder.halfHeight), sides, pose);
}

RoundedHull roundedHull(const ConvexPart& part, double hullMargin) {
  const DoublePose pose(part.pose);
  return std::visit(RoundedHullOf{pose, hullMargin}, part.shape);
}

double support(const ConvexPart& part, double hullMargin, const glm::dvec3& direction) {
  const DoublePose pose(part.pose);
  const glm::dvec3 local = direction * pose.rotation;
  return glm::dot(direction, pose.position) + std::visit(SupportOf{local, hullMargin}, part.shape);
}

Result<std::optional<Polytope>> flatSidedCore(const ConvexPart& part) {
  const DoublePose pose(part.pose);
  if (const Box* box = std::get_if<Box>(&part.shape)) {
    return Polytope::box(pose.position, pose.rotation, glm::dvec3(box->halfExtents));
  }
  const ConvexHull* hull = std::get_if<ConvexHull>(&part.shape);
  if (hull == nullptr) return std::optional<Polytope>{};
  Result<Polytope> polytope = placedHull(*hull, part.pose);
  if (!polytope) return fail(polytope.error().message);
  return std::move(*polytope);
}

Polytope outerPolytope(const ConvexPart& part, double hullMargin, std::span<const glm::dvec3> tangents,
                       double epsilon) {
  const bool isHull = std::holds_alternative<ConvexHull>(part.shape);
  const bool isFlatSided = isHull || std::holds_alternative<Box>(part.shape);
  const RoundedHull exact = roundedHull(part, hullMargin);
  Polytope outer;
  if (exact.radius > 0.0) {
    const int segments = isHull ? kMarginSegments : kRoundSegments;
    outer = hullOfBalls(exact.points, exact.radius * circumscribing(segments), segments,
                        DoublePose(part.pose).rotation);
  } else {
    outer = hullOrNothing(exact.points);
    if (isFlatSided && !outer.isEmpty()) return outer;
  }
  // Rounding could only defeat the hull of an extremely thin part: the box around it will do.
  if (outer.isEmpty()) outer = boundingBox(part, hullMargin);
  for (const glm::dvec3& normal : tangents) {
    outer = outer.clipped({normal, support(part, hullMargin, normal)}, epsilon);
  }
  return outer;
}

Polytope innerPolytope(const ConvexPart& part, double hullMargin, double inset) {
  const DoublePose pose(part.pose);
  return std::visit(InnerPolytopeOf{part, pose, hullMargin, inset}, part.shape);
}

}  // namespace scatter::levels
