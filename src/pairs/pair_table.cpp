#include "pairs/pair_table.h"

#include <utility>

namespace scatter::pairs {

void PairTable::add(int* place) {
  const std::size_t index = places_.size();
  if (index == pairs_.size()) pairs_.emplace_back();
  pairs_[index].renew();
  places_.push_back(place);
  *place = static_cast<int>(index);
}

void PairTable::remove(int index) {
  const auto removed = static_cast<std::size_t>(index);
  const std::size_t last = places_.size() - 1;
  if (removed != last) {
    std::swap(pairs_[removed], pairs_[last]);
    places_[removed] = places_[last];
    *places_[removed] = index;
  }
  places_.pop_back();
}

}  // namespace scatter::pairs
