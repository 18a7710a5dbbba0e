#include "lab/comparison_table.h"

#include "lab/text.h"
#include "lab/text_table.h"

#include <functional>
#include <utility>

namespace scatter {

namespace {

double medianOver(const ComparedWorld& world, const std::function<double(const Summary&)>& figure) {
  std::vector<double> values;
  for (const Run& run : world.repeats) {
    values.push_back(figure(run.summary));
  }
  return medianOf(std::move(values));
}

struct TimeFigure {
  const char* name;
  TimeStatistics Summary::*channel;
  double TimeStatistics::*figure;
  TimeRatios ComparedWorld::*ratios;
  Spread TimeRatios::*ratio;
};

constexpr TimeFigure kTimeFigures[] = {
    {"physics CPU ms, peak", &Summary::physicsCpuMs, &TimeStatistics::peak, &ComparedWorld::physicsCpuMs,
     &TimeRatios::peak},
    {"physics CPU ms, p99", &Summary::physicsCpuMs, &TimeStatistics::p99, &ComparedWorld::physicsCpuMs,
     &TimeRatios::p99},
    {"physics CPU ms, median", &Summary::physicsCpuMs, &TimeStatistics::median, &ComparedWorld::physicsCpuMs,
     &TimeRatios::median},
    {"physics CPU ms, total", &Summary::physicsCpuMs, &TimeStatistics::total, &ComparedWorld::physicsCpuMs,
     &TimeRatios::total},
    {"physics CPU ms, mean of last 100", &Summary::physicsCpuMs, &TimeStatistics::lastHundred,
     &ComparedWorld::physicsCpuMs, &TimeRatios::lastHundred},
    {"physics wall ms, peak", &Summary::physicsMs, &TimeStatistics::peak, &ComparedWorld::physicsMs,
     &TimeRatios::peak},
    {"physics wall ms, total", &Summary::physicsMs, &TimeStatistics::total, &ComparedWorld::physicsMs,
     &TimeRatios::total},
};

lab::ComparisonRow timeRow(const Comparison& comparison, const TimeFigure& time) {
  lab::ComparisonRow row{.name = time.name, .values = {}, .ratios = {}};
  for (const ComparedWorld& world : comparison.worlds) {
    row.values.push_back(lab::readableNumber(
        medianOver(world, [&time](const Summary& run) { return run.*time.channel.*time.figure; })));
    if (&world != &comparison.worlds.front()) {
      row.ratios.push_back(lab::ratioText(world.*time.ratios.*time.ratio, comparison.options.repeat > 1));
    }
  }
  return row;
}

lab::ComparisonRow countRow(const Comparison& comparison, std::string name,
                            const std::function<double(const Summary&)>& count) {
  lab::ComparisonRow row{.name = std::move(name), .values = {}, .ratios = {}};
  const double first = medianOver(comparison.worlds.front(), count);
  for (const ComparedWorld& world : comparison.worlds) {
    const double value = medianOver(world, count);
    row.values.push_back(lab::fixedNumber(value, 0));
    if (&world != &comparison.worlds.front()) {
      row.ratios.push_back(first > 0.0 ? lab::ratioNumber(value / first, value / first) : "-");
    }
  }
  return row;
}

std::vector<std::string> headerOf(const Comparison& comparison) {
  std::vector<std::string> header{""};
  for (const ComparedWorld& world : comparison.worlds) {
    header.push_back(world.label());
  }
  for (std::size_t i = 1; i < comparison.worlds.size(); ++i) {
    header.push_back(comparison.worlds[i].label() + "/" + comparison.worlds.front().label());
  }
  return header;
}

}  // namespace

std::vector<lab::ComparisonRow> lab::comparisonRows(const Comparison& comparison) {
  std::vector<lab::ComparisonRow> rows;
  for (const TimeFigure& time : kTimeFigures) {
    rows.push_back(timeRow(comparison, time));
  }
  const auto add = [&](std::string name, const std::function<double(const Summary&)>& count) {
    rows.push_back(countRow(comparison, std::move(name), count));
  };
  const double budget = comparison.options.runs.front().budgetMs;
  add("frames over " + lab::readableNumber(budget) + " ms (CPU)",
      [](const Summary& run) { return static_cast<double>(run.physicsCpuMs.framesOverBudget); });
  add("manifolds, peak", [](const Summary& run) { return run.counter("manifolds").peak; });
  add("narrowphase pairs, peak", [](const Summary& run) { return run.counter("narrowphase_pairs").peak; });
  add("contacts, peak", [](const Summary& run) { return run.counter("contacts").peak; });
  add("requests made", [](const Summary& run) {
    return static_cast<double>(run.levelEvents[static_cast<std::size_t>(LevelEventKind::kRequested)]);
  });
  add("requests retracted", [](const Summary& run) { return run.counter("retractions").total; });
  add("switches to coarser", [](const Summary& run) { return run.counter("switches_coarser").total; });
  add("switches to finer", [](const Summary& run) { return run.counter("switches_finer").total; });
  return rows;
}

std::string lab::comparisonNote(const Comparison& comparison) {
  const std::string frames = std::to_string(comparison.options.runs.front().frames);
  if (comparison.options.repeat == 1) {
    return "One run of " + frames + " frames in each world; repeat it to see how much the times vary.";
  }
  return "Medians of " + std::to_string(comparison.options.repeat) + " interleaved repeats of " + frames +
         " frames; in brackets the smallest and the largest ratio. Counts are the same in all repeats.";
}

std::string formatTable(const Comparison& comparison) {
  std::vector<std::vector<std::string>> lines{headerOf(comparison)};
  for (lab::ComparisonRow& row : lab::comparisonRows(comparison)) {
    std::vector<std::string> cells{std::move(row.name)};
    cells.insert(cells.end(), row.values.begin(), row.values.end());
    cells.insert(cells.end(), row.ratios.begin(), row.ratios.end());
    lines.push_back(std::move(cells));
  }
  return lab::textTable(lines) + lab::comparisonNote(comparison) + '\n';
}

}  // namespace scatter
