#pragma once

#include <cstddef>
#include <vector>

namespace scatter::graph {

/// The root of a tree in a union-find forest: `parents` leads from each member towards it, and a root is its
/// own. Halves the way for the next time.
template <class Index>
[[nodiscard]] Index rootOf(std::vector<Index>& parents, Index member) {
  auto at = static_cast<std::size_t>(member);
  while (parents[at] != static_cast<Index>(at)) {
    parents[at] = parents[static_cast<std::size_t>(parents[at])];
    at = static_cast<std::size_t>(parents[at]);
  }
  return static_cast<Index>(at);
}

}  // namespace scatter::graph
