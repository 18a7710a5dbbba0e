#pragma once

#include <scatter/lab/comparison.h>

#include <cstddef>
#include <functional>
#include <string>

namespace scatter::lab {

/// Runs that are made one after another, and how far they are.
class RunSeries {
 public:
  /// `runs`: how many there will be. `progress` may be empty, and outlives the series.
  RunSeries(std::size_t runs, const std::function<void(const CompareProgress&)>& progress);

  /// Makes the next one; `label` is what the progress calls it. Fails as runScene does.
  [[nodiscard]] Result<Run> run(const RunOptions& options, std::string label);

 private:
  const std::function<void(const CompareProgress&)>& progress_;
  CompareProgress report_{};
};

}  // namespace scatter::lab
