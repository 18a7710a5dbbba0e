#include "bullet/physics/shapes.h"

#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <type_traits>

#include "bullet/shapes/conversions.h"

namespace scatter {

namespace {

/// The message about the only part of a shape that the caller does not know as parts.
std::string withoutPart(const std::string& message) {
  const std::string part = "part 1: ";
  return message.rfind(part, 0) == 0 ? message.substr(part.size()) : message;
}

}  // namespace

void BulletShapeBuilder::setParts(BulletShape& shape, const std::vector<ConvexPart>& parts) {
  shape.finest_ = shape.parts_.add(parts, shape.mass_.center, kHullMargin);
}

void BulletShapeBuilder::setFinest(BulletShape& shape, std::unique_ptr<btCollisionShape> finest) {
  shape.finest_ = finest.get();
  shape.other_ = std::move(finest);
}

BulletShapeBuilder::Made BulletShapeBuilder::build(const Shape& shape) {
  return std::visit([this](const auto& concrete) { return make(concrete); }, shape);
}

BulletShapeBuilder::Made BulletShapeBuilder::make(const ConvexShape& convex) {
  const std::vector<ConvexPart> parts{{convex, Transform{}}};
  const Result<MassProperties> mass = massProperties(parts);
  if (!mass) return fail(withoutPart(mass.error().message));
  auto shape = std::make_shared<BulletShape>();
  if (std::holds_alternative<ConvexHull>(convex)) {
    shape->mass_ = massFrame(*mass);
  } else {
    // The others are symmetric about their origin: no rounding may move them.
    shape->mass_.inertia = Vec3(mass->inertia[0][0], mass->inertia[1][1], mass->inertia[2][2]);
  }
  setParts(*shape, parts);
  return shape;
}

BulletShapeBuilder::Made BulletShapeBuilder::make(const Compound& compound) {
  const Result<MassProperties> mass = massProperties(compound.parts);
  if (!mass) return tl::unexpected(mass.error());
  auto shape = std::make_shared<BulletShape>();
  shape->mass_ = massFrame(*mass);
  setParts(*shape, compound.parts);
  return shape;
}

BulletShapeBuilder::Made BulletShapeBuilder::make(const Plane& plane) {
  auto shape = std::make_shared<BulletShape>();
  const float length = glm::length(plane.normal);
  setFinest(*shape,
            std::make_unique<btStaticPlaneShape>(toBullet(plane.normal / length), plane.offset / length));
  return shape;
}

BulletShapeBuilder::Made BulletShapeBuilder::make(const std::shared_ptr<const TriangleMesh>& mesh) {
  return share(mesh, [&mesh](BulletShape& shape) {
    static_assert(sizeof(Vec3) == 3 * sizeof(float));
    static_assert(std::is_same_v<btScalar, float>);
    // Bullet's view is not const but only read here.
    btIndexedMesh view;
    view.m_numTriangles = static_cast<int>(mesh->triangles.size());
    view.m_triangleIndexBase = reinterpret_cast<const unsigned char*>(mesh->triangles.data());
    view.m_triangleIndexStride = sizeof(mesh->triangles[0]);
    view.m_numVertices = static_cast<int>(mesh->vertices.size());
    view.m_vertexBase = reinterpret_cast<const unsigned char*>(mesh->vertices.data());
    view.m_vertexStride = sizeof(Vec3);
    auto array = std::make_unique<btTriangleIndexVertexArray>();
    array->addIndexedMesh(view, PHY_INTEGER);
    shape.meshView_ = std::move(array);
    setFinest(shape, std::make_unique<btBvhTriangleMeshShape>(shape.meshView_.get(),
                                                              /*useQuantizedAabbCompression=*/true));
    return Result<void>();
  });
}

BulletShapeBuilder::Made BulletShapeBuilder::make(const std::shared_ptr<const HeightField>& field) {
  return share(field, [&field](BulletShape& shape) {
    const auto [low, high] = std::minmax_element(field->heights.begin(), field->heights.end());
    // Bullet's height fields have their origin half-way between the lowest and the highest point.
    shape.mass_.center.position.y = 0.5F * (*low + *high);
    auto heights = std::make_unique<btHeightfieldTerrainShape>(
        static_cast<int>(field->columns), static_cast<int>(field->rows), field->heights.data(), *low, *high,
        /*upAxis=*/1, /*flipQuadEdges=*/false);
    heights->setLocalScaling(btVector3(field->spacingX, 1.0F, field->spacingZ));
    setFinest(shape, std::move(heights));
    return Result<void>();
  });
}

BulletShapeBuilder::Made BulletShapeBuilder::make(const std::shared_ptr<const LevelSet>& levels) {
  return share(levels, [&levels](BulletShape& shape) {
    shape.mass_ = massFrame(levels->mass());
    const char* mistake = shape.parts_.addLevels(*levels, shape.mass_.center, shape.levels_);
    if (mistake != nullptr) return Result<void>(fail(mistake));
    shape.finest_ = shape.levels_.getLevelShape(levels->count());
    return Result<void>();
  });
}

template <class Source, class Make>
BulletShapeBuilder::Made BulletShapeBuilder::share(const std::shared_ptr<const Source>& source, Make make) {
  if (auto existing = shared_[source.get()].lock()) return existing;
  std::erase_if(shared_, [](const auto& entry) { return entry.second.expired(); });
  auto shape = std::make_shared<BulletShape>();
  shape->source_ = source;
  if (auto made = make(*shape); !made) return tl::unexpected(made.error());
  shared_[source.get()] = shape;
  return shape;
}

}  // namespace scatter
