#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace scatter::lod {

/// A quantile of the last values: follows a change after a few of them, and no single one moves it far.
template <int kValues>
class RecentQuantile {
 public:
  void add(double value) {
    values_[static_cast<std::size_t>(next_)] = value;
    next_ = (next_ + 1) % kValues;
    count_ = std::min(count_ + 1, kValues);
  }

  /// The value that was added last; 0 without values.
  [[nodiscard]] double last() const {
    return count_ == 0 ? 0.0 : values_[static_cast<std::size_t>((next_ + kValues - 1) % kValues)];
  }

  /// The smallest value that at least this share of the values (0 to 1) does not exceed; 0 without values.
  [[nodiscard]] double at(double share) const {
    if (count_ == 0) return 0.0;
    auto values = values_;
    const int rank = std::clamp(static_cast<int>(std::ceil(share * count_)), 1, count_) - 1;
    const auto nth = values.begin() + rank;
    std::nth_element(values.begin(), nth, values.begin() + count_);
    return *nth;
  }

 private:
  std::array<double, kValues> values_{};
  int next_ = 0;
  int count_ = 0;
};

}  // namespace scatter::lod
