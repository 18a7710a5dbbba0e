#include "pairs/contact_recycling.h"

#include <limits>

namespace scatter::pairs {

bool ContactRecycling::run(std::vector<int>& touching) {
  touching.clear();
  bool isDone = parts_.hasNoNewcomers(*bodies_.a, *bodies_.b);
  std::vector<ChildPair>& children = parts_.children();
  for (const int i : parts_.wakeful()) {
    ChildPair& child = children[static_cast<std::size_t>(i)];
    if (!child.touching) continue;
    const float slid = engine_.carry(child.contact);
    child.touching = slid < std::numeric_limits<float>::infinity();
    if (!child.touching) {
      engine_.release(child.contact);
      child.contact = nullptr;
    }
    child.stale = isStale(child, slid);
    isDone = isDone && !child.stale;
    touching.push_back(i);
  }
  return isDone && !touching.empty();
}

bool ContactRecycling::isStale(const ChildPair& child, float slid) const {
  return !child.settled || !(slid < tolerance_) || !(parts_.turn() - child.turnAt < kMostRecycledTurn);
}

}  // namespace scatter::pairs
