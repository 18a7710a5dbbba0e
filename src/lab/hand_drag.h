#pragma once

#include <scatter/lab/hands.h>

#include "lab/hand_pull.h"

#include <optional>

namespace scatter::lab {

/// One body pulled by one point.
class Drag {
 public:
  /// `object` is dynamic; `point` is in the world frame.
  Drag(const WorldObject& object, const Vec3& point);

  [[nodiscard]] BodyId body() const { return body_; }
  [[nodiscard]] Vec3 grip(const BodyState& state) const { return state.pose(local_); }

  void apply(World& world, const HandsDef& def, float seconds);

  Vec3 target;

 private:
  [[nodiscard]] Mat3 inverseMassAt(const Vec3& arm, const Mat3& inertia) const;

  BodyId body_;
  float mass_;
  Mat3 inertia_;  // in the model's frame, kg m²
  Vec3 local_;    // the grip, in the model's frame
  SteadyLoad load_;
  std::optional<Vec3> expected_;  // velocity of the grip after the step
};

}  // namespace scatter::lab
