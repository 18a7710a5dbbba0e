#include <scatter/io/file.h>
#include <scatter/lab/summary.h>

#include "lab/summary_json.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <string_view>
#include <utility>

namespace scatter {

namespace {

// Whole numbers that are no counts of what the physics did.
bool isCounter(const Channel& channel) {
  return channel.kind == ChannelKind::kInteger && channel.name != "frame" && !channel.sampled;
}

}  // namespace

double meanOfLast(const std::vector<double>& values) {
  constexpr std::ptrdiff_t kLastFrames = 100;
  const auto first = values.end() - std::min<std::ptrdiff_t>(kLastFrames, std::ssize(values));
  return values.empty()
             ? 0.0
             : std::accumulate(first, values.end(), 0.0) / static_cast<double>(values.end() - first);
}

double nearestRank(std::vector<double> values, double share) {
  assert(share >= 0.0 && share <= 1.0);
  if (values.empty()) {
    return 0.0;
  }
  const auto count = static_cast<double>(values.size());
  // A rank that is whole but for rounding (0.07 * 100 is 7.000000000000001) must not become the next one.
  const double rank = std::ceil(share * count - 1e-9 * count);
  const auto index = static_cast<std::ptrdiff_t>(std::clamp(rank, 1.0, count)) - 1;
  std::nth_element(values.begin(), values.begin() + index, values.end());
  return values[static_cast<std::size_t>(index)];
}

double medianOf(std::vector<double> values) {
  if (values.empty()) {
    return 0.0;
  }
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2.0;
}

TimeStatistics timeStatistics(const std::vector<double>& milliseconds, double budgetMs) {
  const auto over = std::count_if(milliseconds.begin(), milliseconds.end(),
                                  [budgetMs](double value) { return value > budgetMs; });
  return {.peak = nearestRank(milliseconds, 1.0),
          .p999 = nearestRank(milliseconds, 0.999),
          .p99 = nearestRank(milliseconds, 0.99),
          .median = nearestRank(milliseconds, 0.5),
          .total = std::accumulate(milliseconds.begin(), milliseconds.end(), 0.0),
          .lastHundred = meanOfLast(milliseconds),
          .framesOverBudget = static_cast<std::uint64_t>(over)};
}

const CounterStatistics& Summary::counter(std::string_view name) const {
  const auto found = std::find_if(counters.begin(), counters.end(),
                                  [name](const CounterStatistics& item) { return item.name == name; });
  assert(found != counters.end());
  return *found;
}

void summarise(const FrameTable& table, Summary& summary) {
  summary.frames = table.frames();
  summary.physicsMs = timeStatistics(table.values("physics_ms"), summary.budgetMs);
  summary.physicsCpuMs = timeStatistics(table.values("physics_cpu_ms"), summary.budgetMs);
  summary.counters.clear();
  for (const FrameColumn& column : table.columns()) {
    if (isCounter(column.channel)) {
      const auto& values = column.values;
      summary.counters.push_back(
          {.name = column.channel.name,
           .total = std::accumulate(values.begin(), values.end(), 0.0),
           .peak = values.empty() ? 0.0 : *std::max_element(values.begin(), values.end())});
    }
  }
  const auto& hashes = table.hashes("state_hash");
  summary.stateHash = hashes.empty() ? 0 : hashes.back();
  summary.build = buildInfo();
  summary.machine = machineInfo();
}

Result<void> writeSummary(const std::filesystem::path& file, const Summary& summary) {
  return writeFile(file,
                   lab::summaryJson(summary).dump(2, ' ', false, lab::Json::error_handler_t::replace) + '\n');
}

}  // namespace scatter
