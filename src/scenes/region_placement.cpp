#include "scenes/region_placement.h"

#include <algorithm>
#include <utility>

namespace scatter {

RegionPlacement::RegionPlacement(Random& random, SceneFileRegion region)
    : random_(random), region_(std::move(region)) {}

bool RegionPlacement::isClear(const Ball& candidate) const {
  return std::all_of(balls_.begin(), balls_.end(), [&](const Ball& ball) {
    const Vec3 apart = ball.center - candidate.center;
    const float reach = ball.radius + candidate.radius + region_.clearance;
    return glm::dot(apart, apart) > reach * reach;
  });
}

Vec3 RegionPlacement::draw() {
  switch (region_.kind) {
    case SceneFileRegion::Kind::kShell: {
      const Vec3 direction = random_.direction();
      return region_.center + direction * random_.uniform(region_.inner, region_.outer);
    }
    case SceneFileRegion::Kind::kBall:
      return region_.center + region_.outer * random_.insideUnitBall();
    case SceneFileRegion::Kind::kBox:
      break;
  }
  const float x = random_.uniform(-0.5F, 0.5F);
  const float y = random_.uniform(-0.5F, 0.5F);
  const float z = random_.uniform(-0.5F, 0.5F);
  return region_.center + region_.size * Vec3(x, y, z);
}

void RegionPlacement::grow() {
  constexpr float kGrowth = 1.05F;
  region_.outer *= kGrowth;
  region_.size *= kGrowth;
}

Vec3 RegionPlacement::place(float radius) {
  constexpr int kTriesBeforeGrowing = 100;
  for (;;) {
    for (int i = 0; i < kTriesBeforeGrowing; ++i) {
      const Ball ball{draw(), radius};
      if (isClear(ball)) {
        balls_.push_back(ball);
        return ball.center;
      }
    }
    grow();
  }
}

}  // namespace scatter
