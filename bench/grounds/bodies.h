#pragma once

#include <BulletHybrid/btHybridLevelSet.h>

#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <memory>
#include <vector>

#include "random.h"

namespace scatter::bench {

enum class BodyKind {
  kShip,
  kWheel,
  kPlate,  ///< Thin, of three hulls.
  kRock,   ///< A bare hull.
  kCrate,  ///< A bare box.
};

[[nodiscard]] constexpr bool isBare(BodyKind kind) {
  return kind == BodyKind::kRock || kind == BodyKind::kCrate;
}

/// A body of many hulls, and the same as a set of three nested levels; or a bare one without levels.
class Model {
 public:
  Model(BodyKind kind, Random& random);

  [[nodiscard]] btCollisionShape* finest() {
    return bare_ ? bare_.get() : static_cast<btCollisionShape*>(levels_[2].get());
  }
  [[nodiscard]] const btHybridLevelSet& levels() const { return set_; }
  [[nodiscard]] float radius() const { return radius_; }

 private:
  void addLevels();
  void addHull(std::vector<btVector3> points);
  void addShip(Random& random);
  void addWheel(Random& random);
  void addPlate(Random& random);
  void addCoarser(int level, std::size_t group);

  std::vector<std::vector<btVector3>> hulls_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::unique_ptr<btCollisionShape> bare_;
  std::unique_ptr<btCompoundShape> levels_[3];
  btHybridLevelSet set_;
  float radius_ = 0;
};

}  // namespace scatter::bench
