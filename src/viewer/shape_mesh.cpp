#include "viewer/shape_mesh.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "levels/part_geometry.h"
#include "levels/polytope.h"
#include "viewer/drawing/surface_shading.h"

namespace scatter::viewer {
namespace {

constexpr float kPi = 3.14159265F;
constexpr float kPlaneSize = 200.0F;
constexpr int kSides = 28;
constexpr int kArcs = 8;  // of a quarter of a circle

std::uint32_t addVertex(MeshData& mesh, const Vec3& position, const Vec3& normal) {
  mesh.positions.push_back(position);
  mesh.normals.push_back(normal);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

void addFlat(MeshData& mesh, const levels::Polytope& solid) {
  for (const levels::Polytope::Face& face : solid.faces()) {
    const auto loop = solid.loop(face);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const std::uint32_t vertex : loop) {
      addVertex(mesh, Vec3(solid.vertices()[vertex]), Vec3(face.plane.normal));
    }
    for (std::uint32_t i = 2; i < loop.size(); ++i) {
      mesh.indices.insert(mesh.indices.end(), {first, first + i - 1, first + i});
    }
  }
}

/// A point of the outline of a solid of revolution about y.
struct Outline {
  float radius = 0.0F;
  float height = 0.0F;
  float normalOut = 1.0F;
  float normalUp = 0.0F;
};

/// From the bottom to the top.
void addRevolved(MeshData& mesh, const std::vector<Outline>& outline, const Transform& pose) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Outline& point : outline) {
    for (int side = 0; side <= kSides; ++side) {
      const float angle = 2.0F * kPi * static_cast<float>(side) / kSides;
      const Vec3 out(std::cos(angle), 0.0F, std::sin(angle));
      const Vec3 up(0.0F, 1.0F, 0.0F);
      addVertex(mesh, pose(point.radius * out + point.height * up),
                pose.rotation * glm::normalize(point.normalOut * out + point.normalUp * up));
    }
  }
  constexpr std::uint32_t kRow = kSides + 1;
  for (std::uint32_t row = 0; row + 1 < outline.size(); ++row) {
    for (std::uint32_t side = 0; side < kSides; ++side) {
      const std::uint32_t a = first + row * kRow + side;
      mesh.indices.insert(mesh.indices.end(), {a, a + kRow, a + 1, a + 1, a + kRow, a + kRow + 1});
    }
  }
}

/// Two half circles; `halfHeight` between their centres.
std::vector<Outline> roundEnds(float radius, float halfHeight) {
  std::vector<Outline> outline;
  for (int i = -kArcs; i <= kArcs; ++i) {
    const float angle = 0.5F * kPi * static_cast<float>(i) / kArcs;
    const float out = std::cos(angle);
    const float up = std::sin(angle);
    if (i == 0 && halfHeight > 0.0F) outline.push_back({radius, -halfHeight, 1.0F, 0.0F});
    outline.push_back({radius * out, radius * up + (i < 0 ? -halfHeight : halfHeight), out, up});
  }
  return outline;
}

std::vector<Outline> flatEnds(float radius, float halfHeight) {
  return {{0.0F, -halfHeight, 0.0F, -1.0F},  {radius, -halfHeight, 0.0F, -1.0F},
          {radius, -halfHeight, 1.0F, 0.0F}, {radius, halfHeight, 1.0F, 0.0F},
          {radius, halfHeight, 0.0F, 1.0F},  {0.0F, halfHeight, 0.0F, 1.0F}};
}

void addPart(MeshData& mesh, const ConvexPart& part) {
  if (const auto* sphere = std::get_if<Sphere>(&part.shape)) {
    addRevolved(mesh, roundEnds(sphere->radius, 0.0F), part.pose);
  } else if (const auto* capsule = std::get_if<Capsule>(&part.shape)) {
    addRevolved(mesh, roundEnds(capsule->radius, capsule->halfHeight), part.pose);
  } else if (const auto* cylinder = std::get_if<Cylinder>(&part.shape)) {
    addRevolved(mesh, flatEnds(cylinder->radius, cylinder->halfHeight), part.pose);
  } else if (const auto core = levels::flatSidedCore(part); core && *core) {
    addFlat(mesh, **core);
  }
}

MeshData planeMesh(const Plane& plane) {
  const Vec3 normal = glm::normalize(plane.normal);
  const Vec3 other = std::abs(normal.y) < 0.9F ? Vec3(0.0F, 1.0F, 0.0F) : Vec3(1.0F, 0.0F, 0.0F);
  const Vec3 right = kPlaneSize * glm::normalize(glm::cross(other, normal));
  const Vec3 up = glm::cross(normal, right);
  const Vec3 center = normal * plane.offset;
  MeshData mesh;
  for (const Vec3& corner : {-right - up, right - up, right + up, -right + up}) {
    addVertex(mesh, center + corner, normal);
  }
  mesh.indices = {0, 1, 2, 0, 2, 3};
  mesh.twoSided = true;
  return mesh;
}

MeshData surfaceMesh(const TriangleMesh& triangles) {
  MeshData mesh = shadeSurface({triangles.vertices, triangles.triangles});
  mesh.twoSided = true;
  return mesh;
}

}  // namespace

MeshData meshOf(const Level& level) {
  MeshData mesh;
  for (const ConvexPart& part : level.parts) addPart(mesh, part);
  return mesh;
}

MeshData meshOf(const Shape& shape) {
  if (const auto* levels = std::get_if<std::shared_ptr<const LevelSet>>(&shape))
    return meshOf((*levels)->finest());
  if (const auto* compound = std::get_if<Compound>(&shape)) return meshOf(Level{compound->parts});
  if (const auto* plane = std::get_if<Plane>(&shape)) return planeMesh(*plane);
  if (const auto* triangles = std::get_if<std::shared_ptr<const TriangleMesh>>(&shape)) {
    return surfaceMesh(**triangles);
  }
  if (const auto* field = std::get_if<std::shared_ptr<const HeightField>>(&shape)) {
    return surfaceMesh(trianglesOf(**field));
  }
  return std::visit(
      [](const auto& convex) -> MeshData {
        if constexpr (std::is_constructible_v<ConvexShape, decltype(convex)>) {
          return meshOf(Level{{ConvexPart{convex, {}}}});
        } else {
          return {};
        }
      },
      shape);
}

MeshData unitSphere() {
  return meshOf(Level{{ConvexPart{Sphere{1.0F}, {}}}});
}

MeshData unitBox() {
  return meshOf(Level{{ConvexPart{Box{Vec3(1.0F)}, {}}}});
}

}  // namespace scatter::viewer
