#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "bullet/physics/body.h"

namespace scatter {

/// The bodies of a BulletPhysics, by their ids. It is up to their user to add them to a Bullet world.
class BulletBodies {
 public:
  /// `def` is valid. Ids are not used again.
  BulletBody& make(const BodyDef& def, std::shared_ptr<const BulletShape> shape, LevelStart start);

  /// It is in no Bullet world any more.
  void destroy(BodyId body);

  /// There is such a body.
  [[nodiscard]] BulletBody& at(BodyId body);
  [[nodiscard]] const BulletBody& at(BodyId body) const;

  /// By id, which is one more than the index; null once destroyed. Valid until the next is made.
  [[nodiscard]] std::span<const std::unique_ptr<BulletBody>> all() const { return bodies_; }

  [[nodiscard]] std::uint32_t count() const { return count_; }
  [[nodiscard]] std::uint32_t hybridCount() const { return hybridCount_; }

 private:
  std::vector<std::unique_ptr<BulletBody>> bodies_;
  std::uint32_t count_ = 0;
  std::uint32_t hybridCount_ = 0;
};

}  // namespace scatter
