#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "text/edit_distance.h"

namespace scatter {

/// Which of the known names may have been meant, by editDistance(). Empty if the nearest differs in more than
/// half of the letters of the longer of both: then it is another word. It lives as long as the known ones.
template <class Names>
[[nodiscard]] std::string_view nearestName(std::string_view name, const Names& known) {
  // A longer name is no misspelling, and would take long to compare.
  const std::string_view start = name.substr(0, 100);
  std::string_view nearest;
  std::size_t least = start.size() + 1;
  for (const std::string_view one : known) {
    const std::size_t distance = editDistance(start, one);
    if (distance >= least || 2 * distance > std::max(start.size(), one.size())) continue;
    least = distance;
    nearest = one;
  }
  return nearest;
}

}  // namespace scatter
