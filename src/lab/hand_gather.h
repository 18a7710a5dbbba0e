#pragma once

#include <scatter/lab/hands.h>

#include "lab/hand_pull.h"

#include <set>
#include <vector>

namespace scatter::lab {

/// Bodies pulled to one point.
class Gathering {
 public:
  /// All dynamic bodies if `bodies` is empty.
  Gathering(const Vec3& point, std::vector<BodyId> bodies);

  /// Leaves alone what is frozen.
  void apply(World& world, const PullDef& def, const std::set<BodyId>& frozen, float seconds);

 private:
  // A body and the velocity that it is expected to have after the step.
  struct Pulled {
    BodyId body;
    float mass;
    Vec3 expected;
  };

  [[nodiscard]] bool takes(const WorldObject& object, const std::set<BodyId>& frozen) const;
  void followLoad(const World& world, float seconds);

  Vec3 point_;
  std::set<BodyId> bodies_;
  std::vector<Pulled> pulled_;
  SteadyLoad load_;
};

}  // namespace scatter::lab
