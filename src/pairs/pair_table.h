#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "collision/child_memory.h"
#include "pairs/ground_pair.h"
#include "pairs/pair.h"

namespace scatter::pairs {

/// All pairs of a kind, side by side in memory, in blocks. A pair's place changes when another one ends; its
/// owner is told. A new one moves no other: a program's callback may make one inside another one's step.
template <class AnyPair>
class TableOf {
 public:
  /// A new pair. `place` is where its owner keeps its index, as long as the pair lives.
  void add(int* place) {
    const std::size_t index = places_.size();
    if (index == blocks_.size() * kBlock) addBlock();
    *place = static_cast<int>(index);
    places_.push_back(place);
    (*this)[*place].renew();
  }

  /// Its manifolds must be gone. Its memory is kept for pairs to come.
  void remove(int index) {
    const int last = count() - 1;
    if (index != last) {
      std::swap((*this)[index], (*this)[last]);
      int* const moved = places_.back();
      places_[static_cast<std::size_t>(index)] = moved;
      *moved = index;
    }
    places_.pop_back();
  }

  [[nodiscard]] AnyPair& operator[](int index) {
    const auto i = static_cast<std::size_t>(index);
    return (*blocks_[i / kBlock])[i % kBlock];
  }
  [[nodiscard]] const AnyPair& operator[](int index) const {
    const auto i = static_cast<std::size_t>(index);
    return (*blocks_[i / kBlock])[i % kBlock];
  }
  [[nodiscard]] int count() const { return static_cast<int>(places_.size()); }

 private:
  static constexpr std::size_t kBlock = 64;

  void addBlock() {
    blocks_.push_back(std::make_unique<std::array<AnyPair, kBlock>>());
    for (AnyPair& pair : *blocks_.back()) pair.parts.useMemory(*memory_);
  }

  std::unique_ptr<ChildMemory> memory_ = std::make_unique<ChildMemory>();  ///< Of the pairs' child pairs.
  std::vector<std::unique_ptr<std::array<AnyPair, kBlock>>>
      blocks_;  ///< Pairs that have ended are behind the others.
  std::vector<int*> places_;
};

using PairTable = TableOf<Pair>;
using GroundTable = TableOf<GroundPair>;

}  // namespace scatter::pairs
