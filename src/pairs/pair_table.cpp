#include "pairs/pair_table.h"

#include <utility>

namespace scatter::pairs {

void PairTable::add(int* place) {
  const std::size_t index = places_.size();
  if (index == blocks_.size() * kBlock) blocks_.push_back(std::make_unique<std::array<Pair, kBlock>>());
  *place = static_cast<int>(index);
  places_.push_back(place);
  (*this)[*place].renew();
}

void PairTable::remove(int index) {
  const int last = count() - 1;
  if (index != last) {
    std::swap((*this)[index], (*this)[last]);
    int* const moved = places_.back();
    places_[static_cast<std::size_t>(index)] = moved;
    *moved = index;
  }
  places_.pop_back();
}

}  // namespace scatter::pairs
