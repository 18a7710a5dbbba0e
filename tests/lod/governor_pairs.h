#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "lod/cost_model.h"
#include "lod/governor.h"

/// Pairs of three levels whose costs the cost model has seen.
namespace scatter::lod::testing {

inline constexpr double kNoBudget = std::numeric_limits<double>::infinity();

inline double unitsAt(int level, double finestUnits) {
  const double shares[] = {0.0, 0.1, 0.4, 1.0};
  return shares[level] * finestUnits;
}

/// A pair that has been at all levels, last at `level`.
inline PlannedPair knownPair(CostModel& costs, int level, double finestUnits = 10.0, bool touching = true) {
  PlannedPair pair;
  pair.view.finest = 3;
  pair.view.level = static_cast<std::uint8_t>(level);
  pair.view.touching = touching;
  pair.target = pair.view.level;
  for (const int known : {1, 2, 3, level}) {
    for (int i = 0; i < 40; ++i) costs.learn(pair.cost, known, 3, touching, {unitsAt(known, finestUnits)});
  }
  for (int i = 0; i < 3; ++i) {
    pair.cost.units[static_cast<std::size_t>(i)] = static_cast<float>(unitsAt(3 - i, finestUnits));
  }
  return pair;
}

inline std::vector<PlannedPair> knownPairs(CostModel& costs, int count, int level, double finestUnits = 10.0,
                                           bool touching = true) {
  std::vector<PlannedPair> pairs(static_cast<std::size_t>(count),
                                 knownPair(costs, level, finestUnits, touching));
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i].identity = static_cast<std::uint32_t>(i);
  return pairs;
}

inline PlannedPair newPair(std::uint32_t identity) {
  PlannedPair pair;
  pair.view.finest = 3;
  pair.identity = identity;
  return pair;
}

/// How many of so many new pairs get their finest level.
inline int admitNew(Governor& governor, const CostModel& costs, int count, PlannedPair pair = newPair(0)) {
  int admitted = 0;
  for (int i = 0; i < count; ++i) {
    pair.identity = static_cast<std::uint32_t>(i);
    admitted += governor.planNew(pair, costs) == 3 ? 1 : 0;
  }
  return admitted;
}

inline int countAt(const std::vector<PlannedPair>& pairs, int level) {
  return static_cast<int>(std::count_if(pairs.begin(), pairs.end(),
                                        [level](const PlannedPair& pair) { return pair.target == level; }));
}

/// Switches as planned, all of them safe. How many there were.
inline int followPlan(std::vector<PlannedPair>& pairs) {
  int changes = 0;
  for (PlannedPair& pair : pairs) {
    changes += pair.target != pair.view.level ? 1 : 0;
    if (pair.view.touching && pair.target != pair.view.level)
      pair.view.credited = pair.target < pair.view.level;
    pair.view.level = pair.target;
  }
  return changes;
}

}  // namespace scatter::lod::testing
