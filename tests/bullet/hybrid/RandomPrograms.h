#pragma once

#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "../../trials.h"

namespace scatter::test {

/// The seeds of programs that do at random what a program may: so many as usual, or as SCATTER_RANDOM_USES
/// says, from SCATTER_RANDOM_USE on.
inline std::vector<std::uint64_t> programs(int usual) {
  const char* first = std::getenv("SCATTER_RANDOM_USE");
  const char* count = std::getenv("SCATTER_RANDOM_USES");
  if (count == nullptr) return seeds(1, usual);
  std::vector<std::uint64_t> all(std::strtoull(count, nullptr, 10));
  std::iota(all.begin(), all.end(), first == nullptr ? 1 : std::strtoull(first, nullptr, 10));
  return all;
}

}  // namespace scatter::test
