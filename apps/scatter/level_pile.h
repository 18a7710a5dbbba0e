#pragma once

#include <scatter/lab/comparison.h>
#include <scatter/levels/level_set.h>
#include <scatter/result.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace scatter::app {

/// A body that is piled up.
struct PiledBody {
  std::string label;  ///< Of the way in which its parts were made.
  std::shared_ptr<const LevelSet> levels;
};

/// What a step of a resting pile costs: of the last hundred frames.
struct PileCost {
  Spread milliseconds{};  ///< Processor time, over the repeats.
  double contacts = 0.0;  ///< Mean; the same in every repeat, as what follows.
  double manifolds = 0.0;
};

struct PileCosts {
  PileCost bullet;  ///< Plain Bullet, with the finest level.
  PileCost ours;    ///< A hybrid world without a budget: the finest level, too.
};

/// Thirty of each body, which has a diagonal of about 2 m, fall into a pit of their own and may not fall
/// asleep, in both worlds; all runs are repeated, interleaved. One for each body.
[[nodiscard]] Result<std::vector<PileCosts>> pileUp(
    const std::vector<PiledBody>& bodies, int repeat,
    const std::function<void(const CompareProgress&)>& progress);

}  // namespace scatter::app
