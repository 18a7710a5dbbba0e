#pragma once

#include <scatter/world/world.h>

namespace scatter::lab {

/// How far the hybrids' centres of mass are from their mean, metres; zero without hybrids. And how high those
/// of all dynamic bodies are.
struct PileSize {
  double radius = 0.0;  ///< Root mean square.
  double medianDistance = 0.0;
  double meanHeight = 0.0;
};

[[nodiscard]] PileSize pileSize(const World& world);

}  // namespace scatter::lab
