#include "levels/check/solid_part.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "levels/part_check.h"

namespace scatter::levels {
namespace {

/// Of a point in the part's own frame: negative inside, the distance outside.
struct SignedRoundDistance {
  const glm::dvec3& p;

  double operator()(const Sphere& sphere) const { return glm::length(p) - toDouble(sphere.radius); }
  double operator()(const Capsule& capsule) const {
    const double h = toDouble(capsule.halfHeight);
    return glm::length(p - glm::dvec3(0.0, std::clamp(p.y, -h, h), 0.0)) - toDouble(capsule.radius);
  }
  double operator()(const Cylinder& cylinder) const {
    const double around = std::hypot(p.x, p.z) - toDouble(cylinder.radius);
    const double along = std::abs(p.y) - toDouble(cylinder.halfHeight);
    if (around <= 0.0 || along <= 0.0) return std::max(around, along);
    return std::hypot(around, along);
  }
  double operator()(const Box&) const { return 0.0; }
  double operator()(const ConvexHull&) const { return 0.0; }
};

/// Through the innermost corner of the face: rounding must not let the planes hold more than the corners do.
HalfSpace innerPlane(const Polytope& solid, const Polytope::Face& face) {
  HalfSpace plane = face.plane;
  for (const std::uint32_t corner : solid.loop(face)) {
    plane.offset = std::min(plane.offset, glm::dot(plane.normal, solid.vertices()[corner]));
  }
  return plane;
}

}  // namespace

Result<SolidPart> SolidPart::create(const ConvexPart& part) {
  if (const auto defect = findDefect(part)) return fail(*defect);
  Result<std::optional<Polytope>> core = flatSidedCore(part);
  if (!core) return fail(core.error().message);
  return SolidPart(part, *core ? std::move(**core) : Polytope());
}

SolidPart::SolidPart(const ConvexPart& part, Polytope core)
    : shape_(part.shape), pose_(part.pose), core_(std::move(core)) {
  for (const Polytope::Face& face : core_.faces()) planes_.push_back(innerPlane(core_, face));
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 direction{0.0};
    direction[axis] = 1.0;
    bounds_.max[axis] = support(part, 0.0, direction);
    bounds_.min[axis] = -support(part, 0.0, -direction);
  }
}

double SolidPart::depthOutside(const glm::dvec3& point) const {
  if (!isFlatSided()) {
    const glm::dvec3 local = pose_.toLocal(point);
    return std::visit(SignedRoundDistance{local}, shape_);
  }
  double depth = -std::numeric_limits<double>::infinity();
  for (const HalfSpace& plane : planes_) depth = std::max(depth, plane.signedDistance(point));
  return depth;
}

double SolidPart::depthOutside(std::span<const glm::dvec3> points) const {
  double depth = -std::numeric_limits<double>::infinity();
  for (const glm::dvec3& point : points) depth = std::max(depth, depthOutside(point));
  return depth;
}

double SolidPart::distance(const glm::dvec3& point) const {
  return isFlatSided() ? core_.distance(point) : std::max(0.0, depthOutside(point));
}

Result<std::vector<SolidPart>> solidParts(const std::vector<ConvexPart>& parts) {
  std::vector<SolidPart> solids;
  for (const ConvexPart& part : parts) {
    Result<SolidPart> solid = SolidPart::create(part);
    if (!solid) return fail("part " + std::to_string(solids.size() + 1) + ": " + solid.error().message);
    solids.push_back(std::move(*solid));
  }
  return solids;
}

}  // namespace scatter::levels
