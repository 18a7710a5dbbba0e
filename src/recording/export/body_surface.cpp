#include "recording/export/body_surface.h"

#include <array>
#include <glm/gtc/quaternion.hpp>

#include "io/export/export_parts.h"
#include "recording/checks.h"

namespace scatter::recording {

namespace {

constexpr float kPlaneHalf = 100.0F;  // metres

void append(const SurfaceMesh& part, SurfaceMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
  for (const auto& triangle : part.triangles) {
    mesh.triangles.push_back({first + triangle[0], first + triangle[1], first + triangle[2]});
  }
}

SurfaceMesh surfaceOf(const std::vector<ConvexPart>& parts) {
  SurfaceMesh mesh;
  for (const ConvexPart& part : parts) {
    // What has no volume is not seen.
    if (const auto surface = io::surfaceOf(part)) append(*surface, mesh);
  }
  return mesh;
}

SurfaceMesh surfaceOf(const Plane& plane) {
  const float length = glm::length(plane.normal);
  if (!(length > 0.0F)) return {};
  const Vec3 normal = plane.normal / length;
  const Vec3 other = std::abs(normal.x) < 0.7F ? Vec3(1.0F, 0.0F, 0.0F) : Vec3(0.0F, 0.0F, 1.0F);
  const Vec3 right = kPlaneHalf * glm::normalize(glm::cross(other, normal));
  const Vec3 up = glm::cross(normal, right);
  const Vec3 middle = normal * (plane.offset / length);
  return {{middle - right - up, middle + right - up, middle + right + up, middle - right + up},
          {{0, 1, 2}, {0, 2, 3}}};
}

SurfaceMesh surfaceOf(const TriangleMesh& mesh) {
  return {mesh.vertices, mesh.triangles};
}

struct SurfaceOfShape {
  SurfaceMesh operator()(const Plane& plane) const { return surfaceOf(plane); }
  SurfaceMesh operator()(const Compound& compound) const { return surfaceOf(compound.parts); }
  SurfaceMesh operator()(const std::shared_ptr<const LevelSet>& levels) const {
    return surfaceOf(levels->finest().parts);
  }
  SurfaceMesh operator()(const std::shared_ptr<const TriangleMesh>& mesh) const { return surfaceOf(*mesh); }
  SurfaceMesh operator()(const std::shared_ptr<const HeightField>& field) const {
    return surfaceOf(trianglesOf(*field));
  }
  template <class Convex>
  SurfaceMesh operator()(const Convex& convex) const {
    return surfaceOf(std::vector<ConvexPart>{{convex, {}}});
  }
};

struct ModelOfShape {
  template <class T>
  const void* operator()(const std::shared_ptr<const T>& model) const {
    return model.get();
  }
  template <class T>
  const void* operator()(const T& /*shape*/) const {
    return nullptr;
  }
};

std::string_view stemOf(std::string_view name) {
  const std::size_t last = name.find_last_not_of("0123456789-_ ");
  return name.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

}  // namespace

SurfaceMesh surfaceOf(const BodyDef& def) {
  return def.mesh && !def.mesh->triangles.empty() ? *def.mesh : std::visit(SurfaceOfShape{}, def.shape);
}

SurfaceMesh collisionSurfaceOf(const BodyDef& def, int level) {
  if (const auto* levels = std::get_if<std::shared_ptr<const LevelSet>>(&def.shape)) {
    return surfaceOf((*levels)->level(level).parts);
  }
  return std::visit(SurfaceOfShape{}, def.shape);
}

const void* modelOf(const BodyDef& def) {
  return def.mesh ? def.mesh.get() : std::visit(ModelOfShape{}, def.shape);
}

Vec3 colorOf(const BodyDef& def) {
  static constexpr std::array<std::array<float, 3>, 6> kColors{{{0.24F, 0.42F, 0.65F},
                                                                {0.75F, 0.32F, 0.13F},
                                                                {0.36F, 0.30F, 0.25F},
                                                                {0.36F, 0.52F, 0.24F},
                                                                {0.60F, 0.45F, 0.17F},
                                                                {0.45F, 0.27F, 0.47F}}};
  if (def.motion == Motion::kStatic) return {0.20F, 0.22F, 0.25F};
  const auto& color = kColors[hashOf(stemOf(def.name)) % kColors.size()];
  return {color[0], color[1], color[2]};
}

}  // namespace scatter::recording
