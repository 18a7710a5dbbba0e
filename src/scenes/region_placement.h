#pragma once

#include <scatter/io/scene_file.h>
#include <scatter/math.h>

#include <vector>

#include "scenes/placement.h"

namespace scatter {

/// Places balls at random in a region, so that no two of them overlap.
class RegionPlacement {
 public:
  /// `random` must outlive this.
  RegionPlacement(Random& random, SceneFileRegion region);

  /// The centre of a ball of `radius` that is clear of all balls placed before. The region grows by a
  /// little whenever it has become too full.
  Vec3 place(float radius);

 private:
  struct Ball {
    Vec3 center;
    float radius;
  };

  [[nodiscard]] Vec3 draw();
  [[nodiscard]] bool isClear(const Ball& candidate) const;
  void grow();

  Random& random_;
  SceneFileRegion region_;
  std::vector<Ball> balls_;
};

}  // namespace scatter
