#include <scatter/levels/mass_properties.h>

#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <variant>

#include "levels/mesh/mesh_columns.h"
#include "levels/mesh/shells.h"
#include "levels/part_check.h"
#include "levels/part_geometry.h"
#include "levels/union_moments.h"

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

/// Of the tetrahedron of the origin and a triangle, negative if that faces the origin; the second moment is
/// V/20 (Σ vvᵀ + ΣvΣvᵀ).
RawMoments tetrahedron(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 sum = a + b + c;
  const double volume = glm::dot(a, glm::cross(b, c)) / 6.0;
  return {volume, volume / 4.0 * sum,
          volume / 20.0 *
              (glm::outerProduct(a, a) + glm::outerProduct(b, b) + glm::outerProduct(c, c) +
               glm::outerProduct(sum, sum))};
}

RawMoments rawOf(const SolidMoments& solid) {
  const glm::dmat3& inertia = solid.inertia;
  const double half = 0.5 * (inertia[0][0] + inertia[1][1] + inertia[2][2]);
  const glm::dmat3 spread = glm::dmat3(half) - inertia + glm::outerProduct(solid.center, solid.center);
  return {solid.volume, solid.volume * solid.center, solid.volume * spread};
}

MassProperties propertiesOf(const RawMoments& raw, const glm::dvec3& origin) {
  const glm::dvec3 center = raw.first / raw.volume;
  const glm::dmat3 spread = raw.second / raw.volume - glm::outerProduct(center, center);
  const double trace = spread[0][0] + spread[1][1] + spread[2][2];
  return {static_cast<float>(raw.volume), Vec3(origin + center), Mat3(glm::dmat3(trace) - spread)};
}

bool hasFiniteValues(const MassProperties& mass) {
  bool finite = std::isfinite(mass.volume) && isFinite(mass.centerOfMass);
  for (int column = 0; column < 3; ++column) finite = finite && isFinite(Vec3(mass.inertia[column]));
  return finite;
}

}  // namespace
}  // namespace levels

Result<SolidMass> massOfUnion(const std::vector<ConvexPart>& parts) {
  if (auto sound = levels::checkVolumes(parts); !sound) return fail(sound.error().message);
  // Moments about a point of the solid keep their digits, wherever it is.
  const glm::dvec3 origin(parts.front().pose.position);
  levels::RawMoments sum;
  for (const ConvexPart& part : parts) {
    levels::SolidMoments solid = *levels::momentsOf(part);
    solid.center -= origin;
    sum += levels::rawOf(solid);
  }
  SolidMass result;
  if (parts.size() > 1) {
    const levels::EstimatedMoments shared = levels::sharedMoments(parts, origin);
    sum += shared.moments.scaled(-1.0);
    result.shared = static_cast<float>(shared.moments.volume / sum.volume);
    result.error = static_cast<float>(shared.error / sum.volume);
  }
  result.properties = levels::propertiesOf(sum, origin);
  if (!levels::hasFiniteValues(result.properties))
    return fail("the parts together are too large for single precision");
  return result;
}

Result<MassProperties> massProperties(const std::vector<ConvexPart>& parts) {
  const Result<SolidMass> mass = massOfUnion(parts);
  if (!mass) return fail(mass.error().message);
  return mass->properties;
}

Result<SolidMass> massOfMesh(const SurfaceMesh& mesh) {
  Result<levels::WorkMesh> work = levels::makeWorkMesh(mesh);
  if (!work) return fail(work.error().message);
  return levels::massOfMesh(levels::makeMeshSpace(std::move(*work), MeshInterior::kAutomatic));
}

namespace levels {

Result<void> checkVolumes(const std::vector<ConvexPart>& parts) {
  if (parts.empty()) return fail("a solid needs at least one part");
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Result<SolidMoments> solid = momentsOf(parts[i]);
    if (!solid) return fail("part " + std::to_string(i + 1) + ": " + solid.error().message);
  }
  return {};
}

Result<SolidMass> massOfMesh(const MeshSpace& space) {
  if (!space.isClosed) return fail("the mesh is open");
  const WorkMesh& mesh = space.mesh;
  const glm::dvec3 middle = 0.5 * (mesh.bounds.min + mesh.bounds.max);
  RawMoments sum;
  for (const Triangle& triangle : mesh.triangles) {
    sum += tetrahedron(mesh.vertices[triangle[0]] - middle, mesh.vertices[triangle[1]] - middle,
                       mesh.vertices[triangle[2]] - middle);
  }
  const double diagonal = mesh.diagonal;
  if (!(sum.volume > 1e-9 * diagonal * diagonal * diagonal)) return fail("the mesh encloses no volume");
  SolidMass result;
  if (!space.isSimple()) {
    const EstimatedMoments once = columnMoments(mesh, middle);
    result.shared = static_cast<float>((sum.volume - once.moments.volume) / once.moments.volume);
    result.error = static_cast<float>(once.error / once.moments.volume);
    sum = once.moments;
  }
  result.properties = propertiesOf(sum, glm::dvec3(mesh.origin) + middle);
  if (!hasFiniteValues(result.properties)) return fail("the mesh is too large for single precision");
  return result;
}

}  // namespace levels

}  // namespace scatter
