#include "lab/figure_data.h"

#include <scatter/io/file.h>
#include <scatter/world/step_report.h>

#include "lab/text.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

namespace scatter::lab {

namespace {

constexpr std::array<std::string_view, 13> kColumns{
    "frame",
    "physics_ms",
    "physics_cpu_ms",
    "manifolds",
    "narrowphase_pairs",
    "pairs_with_hybrid",
    "objects",
    "contacts",
    "finest_pairs",
    "switches_coarser",
    "switches_finer",
    "pairs_without_hybrid",
    "requests",
};

}  // namespace

FigureData::FigureData(std::vector<FigureWorld> worlds, FigureOptions options)
    : worlds_(std::move(worlds)), options_(std::move(options)) {
  assert(!worlds_.empty());
}

FrameRange FigureData::allFrames() const {
  FrameRange range{.first = worlds_[0].table->values("frame").front(), .last = 0.0};
  for (const FigureWorld& world : worlds_) {
    range.first = std::min(range.first, world.table->values("frame").front());
    range.last = std::max(range.last, world.table->values("frame").back());
  }
  // A run's first frame is 1; an axis that starts at 0 has rounder numbers.
  range.first = range.first == 1.0 ? 0.0 : range.first;
  // gnuplot refuses an empty range.
  range.last = std::max(range.last, range.first + 1.0);
  return range;
}

FrameRange FigureData::peakFrames() const {
  const FrameRange all = allFrames();
  const double center = peak(0, "physics_cpu_ms").frame;
  const double half = std::max(25.0, std::round((all.last - all.first) * 0.05));
  return {.first = std::max(all.first, center - half), .last = std::min(all.last, center + half)};
}

FramePeak FigureData::peak(std::size_t world, std::string_view column) const {
  const FrameTable& table = *worlds_[world].table;
  const auto& values = table.values(column);
  const auto highest = std::max_element(values.begin(), values.end());
  return {.frame = table.values("frame")[static_cast<std::size_t>(highest - values.begin())],
          .value = *highest};
}

double FigureData::highest(std::string_view column, const FrameRange& frames) const {
  double highest = 0.0;
  for (std::size_t world = 0; world < worlds_.size(); ++world) {
    highest = std::max(highest, this->highest(world, column, frames));
  }
  return highest;
}

double FigureData::highest(std::size_t world, std::string_view column, const FrameRange& frames) const {
  const auto values = valuesIn(world, column, frames);
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

int FigureData::countAbove(std::size_t world, std::string_view column, const FrameRange& frames,
                           double limit) const {
  const auto values = valuesIn(world, column, frames);
  return static_cast<int>(
      std::count_if(values.begin(), values.end(), [limit](double value) { return value > limit; }));
}

std::vector<double> FigureData::valuesIn(std::size_t world, std::string_view column,
                                         const FrameRange& frames) const {
  const auto& numbers = worlds_[world].table->values("frame");
  const auto& values = worlds_[world].table->values(column);
  std::vector<double> inRange;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (numbers[i] >= frames.first && numbers[i] <= frames.last) {
      inRange.push_back(values[i]);
    }
  }
  return inRange;
}

Result<void> FigureData::write(const std::filesystem::path& folder) const {
  for (std::size_t world = 0; world < worlds_.size(); ++world) {
    const FrameTable& table = *worlds_[world].table;
    std::string text;
    for (std::size_t frame = 0; frame < table.frames(); ++frame) {
      for (const std::string_view column : kColumns) {
        text += shortestNumber(table.values(column)[frame]) + ' ';
      }
      double sum = 0.0;
      for (std::size_t stage = 0; stage < kStageCount; ++stage) {
        sum += table.values(stageColumn(static_cast<Stage>(stage)))[frame];
        text += shortestNumber(sum) + ' ';
      }
      text.back() = '\n';
    }
    if (auto written = writeFile(folder / fileOf(world), text); !written) {
      return written;
    }
  }
  return {};
}

int FigureData::columnOf(std::string_view name) {
  const auto* const found = std::find(kColumns.begin(), kColumns.end(), name);
  assert(found != kColumns.end());
  return static_cast<int>(found - kColumns.begin()) + 1;
}

int FigureData::stackColumn(std::size_t stages) {
  return static_cast<int>(kColumns.size() + stages);
}

}  // namespace scatter::lab
