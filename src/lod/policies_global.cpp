#include "lod/policies_global.h"

#include <algorithm>
#include <cmath>

namespace scatter::lod {

void LoadPolicy::observe(const Situation& situation) {
  const Load& load = situation.load;
  if (load.budget > 0.0) {
    latch_.update(load.units > static_cast<double>(def_.over) * load.budget,
                  load.units < static_cast<double>(def_.fine) * load.budget);
  } else {
    latch_ = Latch(def_.steps);
  }
}

void LoadPolicy::advise(const Situation& /*situation*/, const PairView& /*pair*/, Wish& wish) const {
  if (latch_.isOn()) wish.request(def_.level);
}

OverlapPolicy::OverlapPolicy(const Def& def, std::shared_ptr<Grouping> grouping)
    : def_(def),
      latch_(def.steps),
      grouping_(grouping ? std::move(grouping) : std::make_shared<Grouping>()) {}

void OverlapPolicy::observe(const Situation& situation) {
  grouping_->observe(situation);
  if (generation_ != grouping_->generation()) {
    generation_ = grouping_->generation();
    overlaps_ = countOverlaps(grouping_->groups(), def_.members);
  }
  latch_.update(overlaps_ > def_.groups, overlaps_ <= def_.groups);
}

void OverlapPolicy::advise(const Situation& /*situation*/, const PairView& /*pair*/, Wish& wish) const {
  if (latch_.isOn()) wish.request(def_.level);
}

// A sweep along x: groups in the order of where their balls begin.
int countOverlaps(std::span<const Group> groups, int members) {
  std::vector<const Group*> balls;
  for (const Group& group : groups) {
    const bool hasPlace = std::isfinite(group.center.x) && std::isfinite(group.reach);
    if (hasPlace && group.count >= static_cast<std::uint32_t>(members)) balls.push_back(&group);
  }
  std::stable_sort(balls.begin(), balls.end(), [](const Group* a, const Group* b) {
    return a->center.x - a->reach < b->center.x - b->reach;
  });
  int overlaps = 0;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Group& a = *balls[i];
    for (std::size_t j = i + 1; j < balls.size(); ++j) {
      const Group& b = *balls[j];
      if (b.center.x - b.reach > a.center.x + a.reach) break;
      const float reach = a.reach + b.reach;
      const Vec3 offset = b.center - a.center;
      if (glm::dot(offset, offset) < reach * reach) ++overlaps;
    }
  }
  return overlaps;
}

}  // namespace scatter::lod
