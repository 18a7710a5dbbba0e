#pragma once

#include <scatter/world/world.h>

namespace scatter::lab {

/// Keeps a thrown body on its way to a point through what gravity and fields do to it.
class ThrowAim {
 public:
  /// `object` flies with nothing but its velocity so far: straight to the point in so many steps.
  ThrowAim(const WorldObject& object, const Vec3& through, int steps);

  /// After the first step its velocity is corrected for the acceleration that it has met. True until then.
  bool beforeStep(World& world, float seconds);

 private:
  BodyId body_;
  Vec3 through_;
  Vec3 velocity_;
  float damping_;  // share of velocity lost per second
  int stepsLeft_;
  bool flies_ = false;
};

/// The velocity that moves a body by `offset` in so many steps, if each step first takes its share of
/// damping, then adds the acceleration, then moves the body.
[[nodiscard]] Vec3 launchVelocity(const Vec3& offset, int steps, const Vec3& acceleration, float damping,
                                  float seconds);

}  // namespace scatter::lab
