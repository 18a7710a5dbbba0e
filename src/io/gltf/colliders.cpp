#include "io/gltf/colliders.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "io/gltf/check.h"

namespace scatter::io {
namespace {

/// Whether a node's plane is that of the notes.
bool agrees(const PlaneNotes& notes, const DocumentPlane& plane, const Transform& pose) {
  const Vec3 normal = pose.rotation * plane.normal;
  const Vec3 noted = notes.pose.rotation * notes.plane.normal;
  const Vec3 point = notes.pose(notes.plane.normal * notes.plane.offset);
  const float reach = 1.0F + glm::length(point);
  return glm::distance(normal, noted) < 1e-4F &&
         std::abs(glm::dot(normal, point - pose.position)) < 1e-4F * reach;
}

}  // namespace

std::optional<DocumentShape> GltfColliders::shapeOf(const GltfCollider& collider) {
  const JsonPlace place = nodes_->json(collider.node).at("extensions").at(kRigidBodies).at("collider");
  auto scaled = buildGeometry(collider, place);
  if (!scaled) {
    return std::nullopt;
  }
  if (!scaled->note.empty()) {
    file_->warn(place, scaled->note);
  }
  DocumentShape shape;
  shape.geometry = std::move(scaled->geometry);
  shape.pose = collider.placement.rigid();
  if (const auto defect = findShapeDefect(shape, kGltfBounds)) {
    file_->warn(place, "cannot be used: " + *defect + "; it is left out");
    return std::nullopt;
  }
  if (const auto* plane = std::get_if<DocumentPlane>(&shape.geometry)) {
    const auto noted = readPlaneNotes(nodes_->json(collider.node));
    if (noted && agrees(*noted, *plane, shape.pose)) {
      shape.geometry = noted->plane;
      shape.pose = noted->pose;
    }
  }
  return shape;
}

std::optional<ScaledShape> GltfColliders::buildGeometry(const GltfCollider& collider,
                                                        const JsonPlace& place) {
  std::optional<GltfShape> shape;
  if (collider.implicit) {
    auto found = shapes_.find(collider.source);
    if (found == shapes_.end()) {
      const JsonPlace list = file_->root().at("extensions").at(kImplicitShapes).at("shapes");
      found = shapes_.emplace(collider.source, readGltfShape(*file_, list[collider.source])).first;
    }
    shape = found->second;
  } else if (collider.hull) {
    shape = meshHull(collider, place);
  } else {
    GltfPlacement scale;
    scale.stretch = collider.placement.stretch;
    VisualMesh mesh = meshOf(collider, scale, place);
    if (mesh.triangles.empty()) {
      file_->warn(place, "its mesh has no triangles; it is left out");
      return std::nullopt;
    }
    return ScaledShape{std::move(mesh), ""};
  }
  if (!shape) {
    return std::nullopt;
  }
  auto scaled = scaleShape(*shape, collider.placement.stretch);
  if (!scaled) {
    file_->warn(place, "its node is scaled to nothing; it is left out");
  }
  return scaled;
}

VisualMesh GltfColliders::meshOf(const GltfCollider& collider, const GltfPlacement& base,
                                 const JsonPlace& place) {
  VisualMesh mesh;
  std::vector<std::pair<std::size_t, GltfPlacement>> waiting{{collider.source, base}};
  while (!waiting.empty()) {
    const auto [node, placement] = waiting.back();
    waiting.pop_back();
    file_->budget().spend(1, place);
    const JsonPlace json = nodes_->json(node);
    if (const auto reference = json.find("mesh")) {
      meshes_->append(*reference, placement, mesh);
    }
    const std::vector<std::size_t>& children = (*nodes_)[node].children;
    for (std::size_t i = children.size(); i-- > 0;) {
      waiting.emplace_back(children[i], placement * (*nodes_)[children[i]].local);
    }
  }
  return mesh;
}

std::optional<GltfShape> GltfColliders::meshHull(const GltfCollider& collider, const JsonPlace& place) {
  ConvexHull hull{meshOf(collider, {}, place).vertices};
  const auto extras = nodes_->json(collider.source).find("extras");
  if (extras && extras->isObject() && extras->find("scatter_keep_vertices")) {
    return hull;
  }
  auto corners = hullCorners(hull.vertices);
  if (!corners) {
    file_->warn(
        place, "its mesh has no convex hull with a volume (" + corners.error().message + "); it is left out");
    return std::nullopt;
  }
  return ConvexHull{std::move(*corners)};
}

}  // namespace scatter::io
