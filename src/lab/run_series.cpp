#include "lab/run_series.h"

#include <utility>

namespace scatter::lab {

RunSeries::RunSeries(std::size_t runs, const std::function<void(const CompareProgress&)>& progress)
    : progress_(progress) {
  report_.runs = static_cast<int>(runs);
}

Result<Run> RunSeries::run(const RunOptions& options, std::string label) {
  report_.label = std::move(label);
  auto done = runScene(options, [this](const RunProgress& inside) {
    report_.inside = inside;
    if (progress_) {
      progress_(report_);
    }
  });
  ++report_.run;
  return done;
}

}  // namespace scatter::lab
