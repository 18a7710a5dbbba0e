#include "viewer/body_looks.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "viewer/drawing/surface_shading.h"
#include "viewer/mesh_occlusion.h"
#include "viewer/shape_mesh.h"

namespace scatter::viewer {
namespace {

using Levels = std::shared_ptr<const LevelSet>;

/// A triangle mesh or a height field, which several bodies may share; null if it is neither.
std::shared_ptr<const void> sharedSurface(const Shape& shape) {
  if (const auto* mesh = std::get_if<std::shared_ptr<const TriangleMesh>>(&shape)) return *mesh;
  if (const auto* field = std::get_if<std::shared_ptr<const HeightField>>(&shape)) return *field;
  return nullptr;
}

Item itemOf(MeshId mesh) {
  Item item;
  item.mesh = mesh;
  return item;
}

float reachOf(const MeshData& mesh) {
  float reach = 0.0F;
  for (const Vec3& position : mesh.positions) reach = std::max(reach, glm::length(position));
  return reach;
}

}  // namespace

std::optional<MeshId> BodyLooks::find(const void* key, int variant) const {
  const auto found = known_.find({key, variant});
  if (found == known_.end()) return std::nullopt;
  return found->second.mesh;
}

MeshId BodyLooks::shared(const void* key, int variant, const std::shared_ptr<const void>& owner,
                         const MeshData& mesh) {
  const MeshId id = renderer_.addMesh(mesh);
  known_.emplace(std::pair(key, variant), Known{id, owner});
  return id;
}

void BodyLooks::clear() {
  for (const auto& [key, known] : known_) renderer_.removeMesh(known.mesh);
  for (const auto& [body, mesh] : own_) renderer_.removeMesh(mesh);
  known_.clear();
  own_.clear();
  radius_.clear();
  modelRadius_.clear();
  surfaces_.clear();
  modelSurfaces_.clear();
}

Item BodyLooks::drawn(BodyId body, const BodyDef& def) {
  if (!def.mesh) return shape(body, def);
  if (const auto known = find(def.mesh.get(), 0)) return itemOf(*known);
  MeshData mesh = shadeSurface(*def.mesh);
  mesh.occlusion = bakeOcclusion(mesh);
  return itemOf(shared(def.mesh.get(), 0, def.mesh, mesh));
}

Item BodyLooks::level(const Levels& levels, int level) {
  if (const auto known = find(levels.get(), level)) return itemOf(*known);
  return itemOf(shared(levels.get(), level, levels, meshOf(levels->level(level))));
}

Item BodyLooks::shape(BodyId body, const BodyDef& def) {
  if (const auto* levels = std::get_if<Levels>(&def.shape)) return level(*levels, (*levels)->count());
  if (const auto* box = std::get_if<Box>(&def.shape)) {
    if (!box_) box_ = renderer_.addMesh(unitBox());
    Item item = itemOf(*box_);
    item.scale = box->halfExtents;
    return item;
  }
  if (const auto* sphere = std::get_if<Sphere>(&def.shape)) {
    if (!sphere_) sphere_ = renderer_.addMesh(unitSphere());
    Item item = itemOf(*sphere_);
    item.scale = Vec3(sphere->radius);
    return item;
  }
  if (const auto surface = sharedSurface(def.shape)) {
    if (const auto known = find(surface.get(), 0)) return itemOf(*known);
    return itemOf(shared(surface.get(), 0, surface, meshOf(def.shape)));
  }
  const auto known = own_.find(body);
  if (known != own_.end()) return itemOf(known->second);
  return itemOf(own_.emplace(body, renderer_.addMesh(meshOf(def.shape))).first->second);
}

float BodyLooks::radius(BodyId body, const BodyDef& def) {
  const auto* levels = std::get_if<Levels>(&def.shape);
  float& radius = levels != nullptr ? modelRadius_[levels->get()] : radius_[body];
  if (radius == 0.0F) radius = reachOf(meshOf(def.shape));
  return radius;
}

const RayTree& BodyLooks::surface(BodyId body, const BodyDef& def) {
  const auto* levels = std::get_if<Levels>(&def.shape);
  std::unique_ptr<RayTree>& surface = levels != nullptr ? modelSurfaces_[levels->get()] : surfaces_[body];
  if (!surface) surface = std::make_unique<RayTree>(meshOf(def.shape));
  return *surface;
}

}  // namespace scatter::viewer
