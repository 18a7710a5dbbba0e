#include "bullet/physics/shapes.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>

#include <glm/geometric.hpp>
#include <type_traits>

#include "bullet/physics/conversions.h"
#include "bullet/physics/principal_axes.h"

namespace scatter {

namespace {

std::unique_ptr<btCollisionShape> convert(const Box& box, float) {
  return std::make_unique<btBoxShape>(toBullet(box.halfExtents));
}

std::unique_ptr<btCollisionShape> convert(const Sphere& sphere, float) {
  return std::make_unique<btSphereShape>(sphere.radius);
}

std::unique_ptr<btCollisionShape> convert(const Capsule& capsule, float) {
  return std::make_unique<btCapsuleShape>(capsule.radius, 2.0F * capsule.halfHeight);
}

std::unique_ptr<btCollisionShape> convert(const Cylinder& cylinder, float) {
  return std::make_unique<btCylinderShape>(btVector3(cylinder.radius, cylinder.halfHeight, cylinder.radius));
}

std::unique_ptr<btCollisionShape> convert(const ConvexHull& hull, float margin) {
  auto shape = std::make_unique<btConvexHullShape>();
  for (const Vec3& vertex : hull.vertices) shape->addPoint(toBullet(vertex), /*recalculateLocalAabb=*/false);
  shape->setMargin(margin);
  shape->recalcLocalAabb();
  return shape;
}

std::unique_ptr<btCollisionShape> convert(const ConvexShape& shape, float hullMargin) {
  return std::visit([hullMargin](const auto& concrete) { return convert(concrete, hullMargin); }, shape);
}

/// Whether the part is the same with its pose left out, up to rounding.
bool isInPlace(const ConvexPart& part) {
  constexpr float kRounding = 1e-6F;
  const Quat& turn = part.pose.rotation;
  return glm::length(part.pose.position) < kRounding &&
         (glm::length(Vec3(turn.x, turn.y, turn.z)) < kRounding ||
          std::holds_alternative<Sphere>(part.shape));
}

/// A hull with its pose in its vertices; other parts as they are.
ConvexPart withPoseApplied(const ConvexPart& part) {
  const auto* hull = std::get_if<ConvexHull>(&part.shape);
  if (hull == nullptr) return part;
  ConvexHull placed;
  placed.vertices.reserve(hull->vertices.size());
  for (const Vec3& vertex : hull->vertices) placed.vertices.push_back(part.pose(vertex));
  return {std::move(placed), Transform{}};
}

/// The message about the only part of a shape that the caller does not know as parts.
std::string withoutPart(const std::string& message) {
  const std::string part = "part 1: ";
  return message.rfind(part, 0) == 0 ? message.substr(part.size()) : message;
}

}  // namespace

void BulletShapeBuilder::setMass(BulletShape& shape, const MassProperties& mass) {
  const PrincipalAxes axes = principalAxes(mass.inertia);
  shape.center_ = {mass.centerOfMass, axes.rotation};
  shape.inertia_ = axes.moments;
}

void BulletShapeBuilder::setFinest(BulletShape& shape, std::unique_ptr<btCollisionShape> finest) {
  shape.finest_ = finest.get();
  shape.owned_.push_back(std::move(finest));
}

void BulletShapeBuilder::setParts(BulletShape& shape, const std::vector<ConvexPart>& parts,
                                  float hullMargin) {
  const Transform toCenter = shape.center_.inverse();
  // A compound around a single part would cost a tree for nothing.
  if (parts.size() == 1) {
    const ConvexPart only = withPoseApplied({parts[0].shape, toCenter * parts[0].pose});
    if (isInPlace(only)) return setFinest(shape, convert(only.shape, hullMargin));
  }
  auto compound =
      std::make_unique<btCompoundShape>(/*enableDynamicAabbTree=*/true, static_cast<int>(parts.size()));
  for (const ConvexPart& part : parts) {
    shape.owned_.push_back(convert(part.shape, hullMargin));
    compound->addChildShape(toBullet(toCenter * part.pose), shape.owned_.back().get());
  }
  setFinest(shape, std::move(compound));
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
    setMass(*shape, *mass);
  } else {
    // The others are symmetric about their origin: no rounding may move them.
    shape->inertia_ = Vec3(mass->inertia[0][0], mass->inertia[1][1], mass->inertia[2][2]);
  }
  setParts(*shape, parts, kHullMargin);
  return shape;
}

BulletShapeBuilder::Made BulletShapeBuilder::make(const Compound& compound) {
  const Result<MassProperties> mass = massProperties(compound.parts);
  if (!mass) return tl::unexpected(mass.error());
  auto shape = std::make_shared<BulletShape>();
  setMass(*shape, *mass);
  setParts(*shape, compound.parts, kHullMargin);
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

BulletShapeBuilder::Made BulletShapeBuilder::make(const std::shared_ptr<const LevelSet>& levels) {
  return share(levels, [&levels](BulletShape& shape) {
    setMass(shape, levels->mass());
    for (int level = 1; level <= levels->count(); ++level) {
      setParts(shape, levels->level(level).parts, levels->hullMargin());
      // LevelSet::create has proven it, or was told to take it as it is.
      const char* mistake = shape.levels_.addLevel(shape.finest_, BT_HYBRID_NESTING_IS_PROVEN);
      if (mistake != nullptr) return Result<void>(fail(mistake));
    }
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
