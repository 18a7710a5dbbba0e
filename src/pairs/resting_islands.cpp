#include "pairs/resting_islands.h"

#include <algorithm>
#include <cstddef>

#include "graph/union_find.h"

namespace scatter::pairs {

void RestingIslands::clear() {
  numbers_.clear();
  bodies_.clear();
  islands_.clear();
  parents_.clear();
}

int RestingIslands::numberOf(PlannedBody& body) {
  const auto [known, isNew] = numbers_.try_emplace(&body, static_cast<int>(bodies_.size()));
  if (isNew) {
    bodies_.push_back(&body);
    islands_.emplace_back();
    parents_.push_back(known->second);
  }
  return known->second;
}

void RestingIslands::add(PlannedBody& a, PlannedBody& b, double units, bool isOwed) {
  int roots[2];
  int count = 0;
  for (PlannedBody* body : {&a, &b}) {
    if (body->isMovable()) roots[count++] = graph::rootOf(parents_, numberOf(*body));
  }
  if (count == 0) return;
  const int first = count == 2 ? std::min(roots[0], roots[1]) : roots[0];
  Island& island = islands_[static_cast<std::size_t>(first)];
  if (count == 2 && roots[0] != roots[1]) {
    const auto later = static_cast<std::size_t>(std::max(roots[0], roots[1]));
    const Island& other = islands_[later];
    parents_[later] = first;
    island.units += other.units;
    island.isOwed = island.isOwed || other.isOwed;
  }
  island.units += units;
  island.isOwed = island.isOwed || isOwed;
}

void RestingIslands::wake(double room, std::vector<PlannedBody*>& bodies) {
  for (std::size_t i = 0; i < islands_.size(); ++i) {
    Island& island = islands_[i];
    parents_[i] = graph::rootOf(parents_, static_cast<int>(i));
    if (parents_[i] != static_cast<int>(i) || !island.isOwed || island.units > room) continue;
    room -= island.units;
    island.isWoken = true;
  }
  for (PlannedBody* body : bodies_) {
    if (isWoken(*body)) bodies.push_back(body);
  }
}

bool RestingIslands::isWoken(const PlannedBody& body) const {
  const auto known = numbers_.find(&body);
  return known != numbers_.end() &&
         islands_[static_cast<std::size_t>(parents_[static_cast<std::size_t>(known->second)])].isWoken;
}

}  // namespace scatter::pairs
