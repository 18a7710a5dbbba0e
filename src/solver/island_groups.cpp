#include "solver/island_groups.h"

#include <algorithm>
#include <numeric>

#include "graph/union_find.h"

namespace scatter::solver {

void IslandGroups::group(int bodies, std::span<const Link> links, std::span<const int> apart, int share) {
  const auto count = static_cast<std::size_t>(bodies);
  parents_.resize(count);
  std::iota(parents_.begin(), parents_.end(), 0);
  sizes_.assign(count, 0);
  groups_.assign(count, kNone);
  unite(links);
  for (const int body : apart)
    groups_[static_cast<std::size_t>(parents_[static_cast<std::size_t>(body)])] = 0;
  sortLinks(chooseGroups(share));
}

void IslandGroups::unite(std::span<const Link> links) {
  for (const Link& link : links) {
    if (link.b == kNone) continue;
    const int a = graph::rootOf(parents_, link.a);
    const int b = graph::rootOf(parents_, link.b);
    parents_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  }
  // A parent comes before its children, so that one pass leads all to their roots.
  for (int& parent : parents_) parent = parents_[static_cast<std::size_t>(parent)];
  roots_.clear();
  for (const Link& link : links) {
    roots_.push_back(parents_[static_cast<std::size_t>(link.a)]);
    sizes_[static_cast<std::size_t>(roots_.back())] += link.count;
  }
}

// How many groups there are.
int IslandGroups::chooseGroups(int share) {
  int current = 1;
  int taken = 0;
  for (const int root : roots_) {
    int& group = groups_[static_cast<std::size_t>(root)];
    if (group != kNone) continue;
    if (taken >= share) {
      ++current;
      taken = 0;
    }
    group = current;
    taken += sizes_[static_cast<std::size_t>(root)];
  }
  return taken > 0 ? current + 1 : current;
}

void IslandGroups::sortLinks(int groups) {
  const auto groupOf = [this](int root) {
    return static_cast<std::size_t>(groups_[static_cast<std::size_t>(root)]);
  };
  starts_.assign(static_cast<std::size_t>(groups) + 1, 0);
  for (const int root : roots_) ++starts_[groupOf(root) + 1];
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  next_.assign(starts_.begin(), starts_.end());
  sorted_.resize(roots_.size());
  for (std::size_t i = 0; i < roots_.size(); ++i)
    sorted_[static_cast<std::size_t>(next_[groupOf(roots_[i])]++)] = static_cast<int>(i);
}

std::span<const int> IslandGroups::linksOf(int group) const {
  const auto at = static_cast<std::size_t>(group);
  return std::span(sorted_).subspan(static_cast<std::size_t>(starts_[at]),
                                    static_cast<std::size_t>(starts_[at + 1] - starts_[at]));
}

}  // namespace scatter::solver
