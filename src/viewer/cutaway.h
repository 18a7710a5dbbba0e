#pragma once

#include <scatter/world/body.h>

#include <map>
#include <span>
#include <vector>

#include "viewer/action.h"
#include "viewer/drawing/projection.h"
#include "viewer/drawing/ray_tree.h"

namespace scatter::viewer {

/// Something that never moves and may hide what does, such as a wall.
struct Obstacle {
  BodyId body{};
  Transform pose{};
  float radius = 0.0F;               ///< Around the pose's position, metres.
  const RayTree* surface = nullptr;  ///< In the pose's frame.
};

/// The share of the bodies that the eye does not see because the obstacle is before them, 0 to 1. A few
/// bodies stand for many.
[[nodiscard]] float hiddenShare(const Obstacle& obstacle, const Vec3& eye, std::span<const Actor> actors);

/// Which walls are cut away, so that what happens behind them is seen. They fade, and a wall that was cut
/// away comes back only when it hides nothing.
class Cutaway {
 public:
  /// `seconds` have passed since the last update; the first one does not fade.
  void update(const Vec3& eye, std::span<const Actor> actors, std::span<const Obstacle> obstacles,
              float seconds);

  /// 0: drawn as it is, 1: cut away.
  [[nodiscard]] float share(BodyId body) const;

  /// How far a ray has to go to leave all that is cut away behind it, metres: what a user points at is
  /// beyond.
  [[nodiscard]] float depthBehind(const Ray& ray, std::span<const Obstacle> obstacles) const;

 private:
  std::map<BodyId, float> shares_;
  std::map<BodyId, bool> cut_;
};

}  // namespace scatter::viewer
