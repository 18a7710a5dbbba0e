#pragma once

#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletCollision/CollisionShapes/btStridingMeshInterface.h>
#include <BulletHybrid/btHybridLevelSet.h>
#include <scatter/result.h>
#include <scatter/world/shape.h>

#include <algorithm>
#include <map>
#include <memory>
#include <vector>

#include "bullet/shapes/part_shapes.h"

namespace scatter {

/// Margin around the hulls of shapes that are not LevelSets: the same as theirs, metres.
inline constexpr float kHullMargin = 0.02F;

/// A Shape as Bullet wants it, in the frame of its centre of mass. Shared by bodies, immutable.
class BulletShape {
 public:
  BulletShape() = default;
  BulletShape(const BulletShape&) = delete;
  BulletShape& operator=(const BulletShape&) = delete;
  ~BulletShape() = default;

  /// The finest level of a LevelSet, else the shape itself. Bullet's interfaces are not const correct; the
  /// shape is not changed.
  [[nodiscard]] btCollisionShape* finest() const { return finest_; }

  /// Of a LevelSet; empty for other shapes, which count as one level.
  [[nodiscard]] const btHybridLevelSet& levels() const { return levels_; }
  [[nodiscard]] int levelCount() const { return std::max(levels_.getNumLevels(), 1); }

  /// The frame of the centre of mass and the principal axes, in the model's frame.
  [[nodiscard]] const Transform& center() const { return mass_.center; }

  /// About `center`'s axes, per kilogram: square metres. Zero for planes, meshes and height fields.
  [[nodiscard]] const Vec3& inertia() const { return mass_.inertia; }

 private:
  friend class BulletShapeBuilder;

  PartShapes parts_;
  std::unique_ptr<btStridingMeshInterface> meshView_;
  std::unique_ptr<btCollisionShape> other_;  ///< A plane, a mesh or a height field.
  btHybridLevelSet levels_;
  btCollisionShape* finest_ = nullptr;
  MassFrame mass_;

  /// Kept so that its address, the key under which this shape is shared, is not used again.
  std::shared_ptr<const void> source_;
};

/// Makes BulletShapes; the same one for the same LevelSet, TriangleMesh or HeightField as long as a body uses
/// it.
class BulletShapeBuilder {
 public:
  /// `shape` is that of a body that has passed validateBody(). Fails if a part is not finite or has no
  /// volume, naming the part.
  [[nodiscard]] Result<std::shared_ptr<const BulletShape>> build(const Shape& shape);

 private:
  using Made = Result<std::shared_ptr<const BulletShape>>;

  Made make(const ConvexShape& shape);
  Made make(const Plane& plane);
  Made make(const Compound& compound);
  Made make(const std::shared_ptr<const TriangleMesh>& mesh);
  Made make(const std::shared_ptr<const HeightField>& field);
  Made make(const std::shared_ptr<const LevelSet>& levels);

  template <class Source, class Make>
  Made share(const std::shared_ptr<const Source>& source, Make make);

  static void setFinest(BulletShape& shape, std::unique_ptr<btCollisionShape> finest);
  static void setParts(BulletShape& shape, const std::vector<ConvexPart>& parts);

  std::map<const void*, std::weak_ptr<const BulletShape>> shared_;
};

}  // namespace scatter
