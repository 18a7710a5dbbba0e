#pragma once

#include <cstdint>
#include <vector>

namespace scatter {

/// How true the contacts of hybrid bodies are to their finest shapes, at one moment. A pair touches if a
/// contact at the level in use is closer than 1 cm, with its penetration credit.
struct FidelitySample {
  std::uint32_t touchingPairs = 0;

  /// By level, from the finest: [0] at the pair's finest level, [1] one level coarser, and so on.
  std::vector<std::uint32_t> touchingByLevel{};

  std::uint32_t visibleOverlapPairs = 0;  ///< Pairs whose finest shapes overlap by more than 5 cm.

  /// Of each pair that touches at a coarser level: how far apart the finest shapes are, metres; 0 if they
  /// overlap.
  std::vector<float> contactGaps{};
};

}  // namespace scatter
