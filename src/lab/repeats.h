#pragma once

#include <scatter/lab/comparison.h>

#include <functional>
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

}  // namespace scatter::lab
