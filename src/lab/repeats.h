#pragma once

#include <scatter/lab/comparison.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace scatter::lab {

/// The median of a figure over the repeated runs of a world.
[[nodiscard]] inline double medianOver(const ComparedWorld& world,
                                       const std::function<double(const Summary&)>& figure) {
  std::vector<double> values;
  for (const Run& run : world.repeats) {
    values.push_back(figure(run.summary));
  }
  return medianOf(std::move(values));
}

/// Each repeat's figure over that of the first world in the same repeat. Not a number where that is zero.
[[nodiscard]] inline Spread ratioOver(const ComparedWorld& world, const ComparedWorld& first,
                                      const std::function<double(const Run&)>& figure) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < world.repeats.size(); ++i) {
    const double base = figure(first.repeats[i]);
    if (base == 0.0) {
      const double none = std::numeric_limits<double>::quiet_NaN();
      return {.median = none, .min = none, .max = none};
    }
    ratios.push_back(figure(world.repeats[i]) / base);
  }
  const auto [min, max] = std::minmax_element(ratios.begin(), ratios.end());
  return {.median = medianOf(ratios), .min = *min, .max = *max};
}

/// Of runs that do the same in every frame: frame by frame the median of what they took, without what the
/// machine has added to one of them. As many frames as the shortest has.
[[nodiscard]] inline std::vector<double> framewiseMedian(const std::vector<std::vector<double>>& runs) {
  std::vector<double> medians;
  for (std::size_t frame = 0; !runs.empty(); ++frame) {
    std::vector<double> values;
    for (const std::vector<double>& run : runs) {
      if (frame >= run.size()) return medians;
      values.push_back(run[frame]);
    }
    medians.push_back(medianOf(std::move(values)));
  }
  return medians;
}

}  // namespace scatter::lab
