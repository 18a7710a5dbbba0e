#include <scatter/levels/mass_properties.h>

#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <variant>

#include "levels/part_check.h"
#include "levels/part_geometry.h"
#include "levels/point_inertia.h"

namespace scatter {
namespace levels {
namespace {

glm::dmat3 diagonal(double x, double y, double z) {
  return {x, 0.0, 0.0, 0.0, y, 0.0, 0.0, 0.0, z};
}

/// Of a solid centred on its own frame, turned and moved by `pose`.
SolidMoments placed(double volume, const glm::dmat3& inertia, const Transform& pose) {
  const DoublePose place(pose);
  return {volume, place.position, place.rotation * inertia * glm::transpose(place.rotation)};
}

Result<SolidMoments> momentsOf(const Box& box, const Transform& pose) {
  const glm::dvec3 h(box.halfExtents);
  const glm::dvec3 s = h * h / 3.0;
  return placed(8.0 * h.x * h.y * h.z, diagonal(s.y + s.z, s.z + s.x, s.x + s.y), pose);
}

Result<SolidMoments> momentsOf(const Sphere& sphere, const Transform& pose) {
  const auto r = static_cast<double>(sphere.radius);
  return placed(4.0 / 3.0 * std::numbers::pi * r * r * r, glm::dmat3(0.4 * r * r), pose);
}

Result<SolidMoments> momentsOf(const Capsule& capsule, const Transform& pose) {
  const auto r = static_cast<double>(capsule.radius);
  const auto h = static_cast<double>(capsule.halfHeight);
  const double middle = 2.0 * std::numbers::pi * r * r * h;
  const double ends = 4.0 / 3.0 * std::numbers::pi * r * r * r;
  const double volume = middle + ends;
  // A half ball's centre lies 3r/8 from its flat side, which gives the mixed term 3rh/4.
  const double across =
      (middle * (r * r / 4.0 + h * h / 3.0) + ends * (0.4 * r * r + h * h + 0.75 * r * h)) / volume;
  const double along = (middle * 0.5 * r * r + ends * 0.4 * r * r) / volume;
  return placed(volume, diagonal(across, along, across), pose);
}

Result<SolidMoments> momentsOf(const Cylinder& cylinder, const Transform& pose) {
  const auto r = static_cast<double>(cylinder.radius);
  const auto h = static_cast<double>(cylinder.halfHeight);
  const double across = r * r / 4.0 + h * h / 3.0;
  return placed(2.0 * std::numbers::pi * r * r * h, diagonal(across, 0.5 * r * r, across), pose);
}

Result<SolidMoments> momentsOf(const ConvexHull& hull, const Transform& pose) {
  const Result<Polytope> polytope = placedHull(hull, pose);
  if (!polytope) return fail(polytope.error().message);
  return polytope->moments();
}

/// Fails with a phrase that does not name the part.
Result<SolidMoments> momentsOf(const ConvexPart& part) {
  if (const std::optional<std::string> defect = findDefect(part)) return fail(*defect);
  Result<SolidMoments> moments =
      std::visit([&part](const auto& shape) { return momentsOf(shape, part.pose); }, part.shape);
  if (!moments) return moments;
  const auto volume = static_cast<float>(moments->volume);
  if (!std::isfinite(volume) || !(volume > 0.0F))
    return fail("volume is too small or too large for single precision");
  return moments;
}

bool hasFiniteValues(const MassProperties& mass) {
  bool finite = std::isfinite(mass.volume) && isFinite(mass.centerOfMass);
  for (int column = 0; column < 3; ++column) finite = finite && isFinite(Vec3(mass.inertia[column]));
  return finite;
}

}  // namespace
}  // namespace levels

Result<MassProperties> massProperties(const std::vector<ConvexPart>& parts) {
  if (parts.empty()) return fail("a solid needs at least one part");
  std::vector<levels::SolidMoments> solids;
  double volume = 0.0;
  glm::dvec3 center{0.0};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Result<levels::SolidMoments> solid = levels::momentsOf(parts[i]);
    if (!solid) return fail("part " + std::to_string(i + 1) + ": " + solid.error().message);
    solids.push_back(*solid);
    volume += solid->volume;
    center += solid->volume * solid->center;
  }
  center /= volume;
  glm::dmat3 inertia{0.0};
  for (const levels::SolidMoments& solid : solids) {
    inertia += solid.volume / volume * (solid.inertia + levels::pointInertia(solid.center - center));
  }
  const MassProperties mass{static_cast<float>(volume), Vec3(center), Mat3(inertia)};
  if (!levels::hasFiniteValues(mass)) return fail("the parts together are too large for single precision");
  return mass;
}

}  // namespace scatter
