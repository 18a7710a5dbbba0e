#pragma once

#include <cstddef>
#include <vector>

#include "pairs/pair.h"

namespace scatter::pairs {

/// All pairs, side by side in memory. A pair's place changes when another one ends; its owner is told.
class PairTable {
 public:
  /// A new pair. `place` is where its owner keeps its index, as long as the pair lives.
  void add(int* place);

  /// Its manifolds must be gone. Its memory is kept for pairs to come.
  void remove(int index);

  [[nodiscard]] Pair& operator[](int index) { return pairs_[static_cast<std::size_t>(index)]; }
  [[nodiscard]] const Pair& operator[](int index) const { return pairs_[static_cast<std::size_t>(index)]; }
  [[nodiscard]] int count() const { return static_cast<int>(places_.size()); }

 private:
  std::vector<Pair> pairs_;  ///< Those that have ended are behind the others.
  std::vector<int*> places_;
};

}  // namespace scatter::pairs
