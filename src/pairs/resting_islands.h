#pragma once

#include <unordered_map>
#include <vector>

#include "pairs/planned_body.h"

namespace scatter::pairs {

/// Bodies that are asleep, and are pairs of the broadphase, as engines make islands of: if one of them wakes,
/// so does its whole island. Deterministic.
class RestingIslands {
 public:
  void clear();

  /// A pair of bodies; what cannot be moved joins no islands. `units`: what it takes in a step when it is
  /// awake; `isOwed`: the island is to wake if it can.
  void add(PlannedBody& a, PlannedBody& b, double units, bool isOwed);

  /// Wakes islands with a pair that is owed something, in the order in which they were added, as long as what
  /// they take fits into so many units. Their bodies, as isWoken() knows them from then on.
  void wake(double room, std::vector<PlannedBody*>& bodies);
  [[nodiscard]] bool isWoken(const PlannedBody& body) const;

 private:
  struct Island {
    double units = 0.0;
    bool isOwed = false;
    bool isWoken = false;
  };

  int numberOf(PlannedBody& body);

  std::unordered_map<const PlannedBody*, int> numbers_;
  std::vector<PlannedBody*> bodies_;  ///< By number.
  std::vector<Island> islands_;       ///< Each begins as one body.
  std::vector<int> parents_;          ///< Of an island, one that it has become part of: not a later one.
};

}  // namespace scatter::pairs
