#include <scatter/lab/memory_study.h>

#include "lab/memory_recorder.h"
#include "lab/text.h"
#include "lab/text_table.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace scatter {

namespace {

using Cells = std::vector<std::string>;

/// Megabytes.
struct Figures {
  double median = 0.0;
  double p99 = 0.0;
  double peak = 0.0;
  double held = 0.0;
};

double megabytes(std::uint64_t bytes) {
  return static_cast<double>(bytes) * 1e-6;
}

Figures figuresOf(const Run& run) {
  std::vector<double> samples = run.table.values(lab::kTouchedColumn);
  std::erase_if(samples, [](double value) { return std::isnan(value); });
  Figures figures;
  const CollisionMemory& memory = run.summary.collisionMemory;
  figures.held = megabytes(memory.pairBytes + memory.childPairBytes + memory.bodyBytes + memory.partBytes);
  if (samples.empty()) {
    return figures;
  }
  figures.p99 = nearestRank(samples, 0.99);
  figures.peak = nearestRank(samples, 1.0);
  figures.median = medianOf(std::move(samples));
  return figures;
}

template <class Number>
std::vector<Cells> linesOf(const Comparison& comparison, Cells header, Number number) {
  std::vector<Cells> lines{std::move(header)};
  for (const ComparedWorld& world : comparison.worlds) {
    const Figures figures = figuresOf(world.run());
    Cells cells{world.label()};
    for (const double value : {figures.median, figures.p99, figures.peak, figures.held}) {
      cells.push_back(number(value));
    }
    lines.push_back(std::move(cells));
  }
  return lines;
}

}  // namespace

std::string formatMemory(const Comparison& comparison) {
  const auto lines =
      linesOf(comparison, {"MB touched in a frame", "median", "p99", "peak", "held by the pair algorithm"},
              [](double value) { return lab::fixedNumber(value, 2); });
  return lab::textTable(lines) +
         lab::fitTerminal(
             "Pages of 4 KiB that a step and its record have touched of the process's own data, every " +
             std::to_string(comparison.options.runs.front().memoryEvery) +
             " frames. Held: in the frame with the most pairs of parts, without contacts.");
}

std::string memoryCsv(const Comparison& comparison) {
  return lab::csvText(linesOf(comparison,
                              {"world", "touched_median_mb", "touched_p99_mb", "touched_peak_mb", "held_mb"},
                              lab::shortestNumber));
}

}  // namespace scatter
