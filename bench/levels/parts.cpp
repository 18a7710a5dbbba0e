#include "parts.h"

#include <utility>

namespace scatter::bench {

Result<Decomposition> decompositionOf(std::vector<ConvexHull> hulls, double seconds) {
  Decomposition result;
  result.seconds = seconds;
  for (ConvexHull& hull : hulls) {
    const ConvexPart part{std::move(hull), {}};
    const std::vector<Level> single{Level{{part}}};
    if (LevelSet::create({.name = "part", .levels = single, .hullMargin = 0.0F, .mass = {}}))
      result.level.parts.push_back(part);
    else
      ++result.flatParts;
  }
  if (result.level.parts.empty()) return fail("gave no part with a volume");
  return result;
}

}  // namespace scatter::bench
