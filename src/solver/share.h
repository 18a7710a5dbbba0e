#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace scatter::solver {

/// Calls work(i) once for every i from 0 to `count` - 1, on any thread and in any order, and returns when all
/// have returned.
using Share = std::function<void(int count, const std::function<void(int)>& work)>;

/// Calls all of them here.
inline void shareWithNobody(int count, const std::function<void(int)>& work) {
  for (int i = 0; i < count; ++i) work(i);
}

/// Calls `use(i)` once for every i from 0 to `count` - 1, some of them one after another: batches, which take
/// a microsecond, as long as it takes to hand one over.
template <class Use>
void shareBatches(std::size_t count, const Share& share, const Use& use) {
  constexpr std::size_t kBlock = 16;
  share(static_cast<int>((count + kBlock - 1) / kBlock), [&](int block) {
    const std::size_t first = static_cast<std::size_t>(block) * kBlock;
    for (std::size_t i = first; i < std::min(count, first + kBlock); ++i) use(i);
  });
}

}  // namespace scatter::solver
