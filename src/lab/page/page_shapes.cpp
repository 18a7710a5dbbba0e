#include "lab/page/page_shapes.h"

#include <utility>
#include <variant>

#include "recording/bytes.h"
#include "recording/export/body_surface.h"

namespace scatter::lab {

namespace {

using Levels = std::shared_ptr<const LevelSet>;

std::string bytesOf(const SurfaceMesh& surface) {
  recording::ByteWriter bytes;
  for (const Vec3& vertex : surface.vertices) bytes.fixed(vertex);
  for (const auto& triangle : surface.triangles) bytes.fixed(triangle);
  return bytes.take();
}

}  // namespace

PageShapes::Look PageShapes::lookOf(const BodyDef& def) {
  const void* model = recording::modelOf(def);
  if (const auto known = knownModels_.find(model); model != nullptr && known != knownModels_.end()) {
    return known->second;
  }
  const Look look = makeLook(def);
  if (model != nullptr) knownModels_.emplace(model, look);
  return look;
}

PageShapes::Look PageShapes::makeLook(const BodyDef& def) {
  if (!def.mesh) {
    if (const auto* box = std::get_if<Box>(&def.shape)) {
      return {.shape = shapeOf({{"is", "box"}}), .scale = box->halfExtents};
    }
    if (const auto* sphere = std::get_if<Sphere>(&def.shape)) {
      return {.shape = shapeOf({{"is", "sphere"}}), .scale = Vec3(sphere->radius)};
    }
  }
  const auto* levels = std::get_if<Levels>(&def.shape);
  const int count = levels != nullptr ? (*levels)->count() : 1;
  Json collision = Json::array();
  for (int level = 1; level <= count; ++level) {
    collision.push_back(meshOf(recording::collisionSurfaceOf(def, level)));
  }
  Json shape{{"is", std::holds_alternative<Plane>(def.shape) ? "plane" : "mesh"},
             {"look", meshOf(recording::surfaceOf(def))},
             {"levels", std::move(collision)}};
  return {.shape = shapeOf(shape), .levels = count};
}

std::size_t PageShapes::meshOf(const SurfaceMesh& surface) {
  std::string bytes = bytesOf(surface);
  const auto [known, isNew] = knownMeshes_.emplace(std::move(bytes), meshes_.size());
  if (isNew) {
    meshes_.push_back({{"at", bytes_.size()},
                       {"vertices", surface.vertices.size()},
                       {"triangles", surface.triangles.size()}});
    bytes_ += known->first;
  }
  return known->second;
}

std::size_t PageShapes::shapeOf(const Json& shape) {
  const auto [known, isNew] = knownShapes_.emplace(shape.dump(), shapes_.size());
  if (isNew) shapes_.push_back(shape);
  return known->second;
}

Json PageShapes::finish(PageBlobs& blobs) const {
  return {{"shapes", shapes_}, {"meshes", meshes_}, {"blob", blobs.add(bytes_)}, {"bytes", bytes_.size()}};
}

}  // namespace scatter::lab
