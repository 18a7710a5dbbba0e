#include "bullet/shapes/part_shapes.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>

#include <glm/geometric.hpp>
#include <utility>
#include <variant>

#include "bullet/shapes/conversions.h"
#include "levels/principal_axes.h"

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

}  // namespace

MassFrame massFrame(const MassProperties& mass) {
  const PrincipalAxes axes = principalAxes(mass.inertia);
  return {{mass.centerOfMass, axes.rotation}, axes.moments};
}

btCollisionShape* PartShapes::keep(std::unique_ptr<btCollisionShape> shape) {
  owned_.push_back(std::move(shape));
  return owned_.back().get();
}

btCollisionShape* PartShapes::add(const std::vector<ConvexPart>& parts, const Transform& center,
                                  float hullMargin) {
  const Transform toCenter = center.inverse();
  // A compound around a single part would cost a tree for nothing.
  if (parts.size() == 1) {
    const ConvexPart only = withPoseApplied({parts[0].shape, toCenter * parts[0].pose});
    if (isInPlace(only)) return keep(convert(only.shape, hullMargin));
  }
  auto compound =
      std::make_unique<btCompoundShape>(/*enableDynamicAabbTree=*/true, static_cast<int>(parts.size()));
  for (const ConvexPart& part : parts) {
    compound->addChildShape(toBullet(toCenter * part.pose), keep(convert(part.shape, hullMargin)));
  }
  return keep(std::move(compound));
}

const char* PartShapes::addLevels(const LevelSet& levels, const Transform& center, btHybridLevelSet& set) {
  for (int level = 1; level <= levels.count(); ++level) {
    btCollisionShape* shape = add(levels.level(level).parts, center, levels.hullMargin());
    // LevelSet::create has proven it, or was told to take it as it is.
    const char* mistake = set.addLevel(shape, BT_HYBRID_NESTING_IS_PROVEN);
    if (mistake != nullptr) return mistake;
  }
  return nullptr;
}

}  // namespace scatter
