#pragma once

#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletHybrid/btHybridLevelSet.h>
#include <scatter/levels/convex_part.h>
#include <scatter/levels/level_set.h>
#include <scatter/levels/mass_properties.h>
#include <scatter/math.h>

#include <memory>
#include <vector>

namespace scatter {

/// The frame in which Bullet moves a body, and what it needs to turn it.
struct MassFrame {
  Transform center{};  ///< The centre of mass and the principal axes, in the model's frame.
  Vec3 inertia{0.0F};  ///< About `center`'s axes, per kilogram: square metres.
};

[[nodiscard]] MassFrame massFrame(const MassProperties& mass);

/// Bullet's shapes for convex parts, which it owns.
class PartShapes {
 public:
  PartShapes() = default;
  PartShapes(const PartShapes&) = delete;
  PartShapes& operator=(const PartShapes&) = delete;
  ~PartShapes() = default;

  /// The parts as one shape in the frame `center`, both given in the model's frame: a compound, or, where a
  /// single part lies in place, its own shape. Hulls get a margin of `hullMargin` metres around them.
  btCollisionShape* add(const std::vector<ConvexPart>& parts, const Transform& center, float hullMargin);

  /// All levels in the frame `center`, appended to `set`, which needs this object as long as it is used.
  /// Returns 0, or why Bullet cannot have them.
  const char* addLevels(const LevelSet& levels, const Transform& center, btHybridLevelSet& set);

 private:
  btCollisionShape* keep(std::unique_ptr<btCollisionShape> shape);

  std::vector<std::unique_ptr<btCollisionShape>> owned_;
};

}  // namespace scatter
