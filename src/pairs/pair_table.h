#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "pairs/pair.h"

namespace scatter::pairs {

/// All pairs, side by side in memory, in blocks. A pair's place changes when another one ends; its owner is
/// told. A new one moves no other: a program's callback may make one inside another one's step.
class PairTable {
 public:
  /// A new pair. `place` is where its owner keeps its index, as long as the pair lives.
  void add(int* place);

  /// Its manifolds must be gone. Its memory is kept for pairs to come.
  void remove(int index);

  [[nodiscard]] Pair& operator[](int index) {
    const auto i = static_cast<std::size_t>(index);
    return (*blocks_[i / kBlock])[i % kBlock];
  }
  [[nodiscard]] const Pair& operator[](int index) const {
    const auto i = static_cast<std::size_t>(index);
    return (*blocks_[i / kBlock])[i % kBlock];
  }
  [[nodiscard]] int count() const { return static_cast<int>(places_.size()); }

 private:
  static constexpr std::size_t kBlock = 64;

  std::vector<std::unique_ptr<std::array<Pair, kBlock>>>
      blocks_;  ///< Pairs that have ended are behind the others.
  std::vector<int*> places_;
};

}  // namespace scatter::pairs
