#include "lab/comparison_table.h"

#include "lab/repeats.h"
#include "lab/text.h"
#include "lab/text_table.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace scatter {

namespace {

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
        lab::medianOver(world, [&time](const Summary& run) { return run.*time.channel.*time.figure; })));
    if (&world != &comparison.worlds.front()) {
      row.ratios.push_back(lab::ratioText(world.*time.ratios.*time.ratio, comparison.options.repeat > 1));
    }
  }
  return row;
}

using Format = std::string (*)(double);

std::string wholeNumber(double value) {
  return lab::fixedNumber(value, 0);
}

// `values` has one for each world.
lab::ComparisonRow valueRow(std::string name, const std::vector<double>& values, Format format) {
  lab::ComparisonRow row{.name = std::move(name), .values = {}, .ratios = {}};
  for (std::size_t i = 0; i < values.size(); ++i) {
    row.values.push_back(format(values[i]));
    if (i > 0) {
      const double ratio = values[i] / values[0];
      row.ratios.push_back(values[0] > 0.0 ? lab::ratioNumber(ratio, ratio) : "-");
    }
  }
  return row;
}

lab::ComparisonRow countRow(const Comparison& comparison, std::string name,
                            const std::function<double(const Summary&)>& count, Format format = wholeNumber) {
  std::vector<double> values;
  for (const ComparedWorld& world : comparison.worlds) {
    values.push_back(lab::medianOver(world, count));
  }
  return valueRow(std::move(name), values, format);
}

// Each once, in the order of the worlds.
std::vector<double> budgetsOf(const Comparison& comparison) {
  std::vector<double> budgets;
  for (const RunOptions& run : comparison.options.runs) {
    if (std::find(budgets.begin(), budgets.end(), run.budgetMs) == budgets.end()) {
      budgets.push_back(run.budgetMs);
    }
  }
  return budgets;
}

// All worlds against one budget, whatever their own is.
lab::ComparisonRow overBudgetRow(const Comparison& comparison, double budget) {
  std::vector<double> values;
  for (const ComparedWorld& world : comparison.worlds) {
    std::vector<double> repeats;
    for (const Run& run : world.repeats) {
      const auto& times = run.table.values("physics_cpu_ms");
      repeats.push_back(static_cast<double>(timeStatistics(times, budget).framesOverBudget));
    }
    values.push_back(medianOf(std::move(repeats)));
  }
  return valueRow("frames over " + lab::readableNumber(budget) + " ms (CPU)", values, wholeNumber);
}

struct FidelityFigure {
  const char* name;
  double (*value)(const FidelityStatistics&);
};

constexpr FidelityFigure kFidelityFigures[] = {
    {"visible overlaps, mean", [](const FidelityStatistics& run) { return run.visibleOverlapMean; }},
    {"visible overlaps per 100 touching",
     [](const FidelityStatistics& run) { return run.visibleOverlapPer100; }},
    {"contact gap p95, % of length",
     [](const FidelityStatistics& run) { return run.contactGapP95Percent(); }},
    {"touching finely %, mean", [](const FidelityStatistics& run) { return 100.0 * run.finestShareMean; }},
    {"touching finely %, worst", [](const FidelityStatistics& run) { return 100.0 * run.finestShareWorst; }},
    {"largest jump, m", [](const FidelityStatistics& run) { return run.largestJump; }},
};

void addFidelityRows(const Comparison& comparison, std::vector<lab::ComparisonRow>& rows) {
  if (comparison.options.runs.front().fidelityEvery == 0) {
    return;
  }
  for (const FidelityFigure& figure : kFidelityFigures) {
    rows.push_back(countRow(
        comparison, figure.name, [&figure](const Summary& run) { return figure.value(run.fidelity); },
        lab::readableNumber));
  }
}

// "", or which worlds never run twice the same.
std::string clockSentence(const Comparison& comparison) {
  std::string names;
  for (const RunOptions& run : comparison.options.runs) {
    if (isClockGoverned(run.physics)) {
      names += (names.empty() ? "" : ", ") + run.label;
    }
  }
  return names.empty() ? "" : " Governed by the clock, so that each run differs: " + names + ".";
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
  for (const double budget : budgetsOf(comparison)) {
    rows.push_back(overBudgetRow(comparison, budget));
  }
  add("manifolds, peak", [](const Summary& run) { return run.counter("manifolds").peak; });
  add("narrowphase pairs, peak", [](const Summary& run) { return run.counter("narrowphase_pairs").peak; });
  add("contacts, peak", [](const Summary& run) { return run.counter("contacts").peak; });
  add("requests made", [](const Summary& run) {
    return static_cast<double>(run.levelEvents[static_cast<std::size_t>(LevelEventKind::kRequested)]);
  });
  add("requests retracted", [](const Summary& run) { return run.counter("retractions").total; });
  add("switches to coarser", [](const Summary& run) { return run.counter("switches_coarser").total; });
  add("switches to finer", [](const Summary& run) { return run.counter("switches_finer").total; });
  addFidelityRows(comparison, rows);
  return rows;
}

std::string lab::comparisonNote(const Comparison& comparison) {
  const std::string frames = std::to_string(comparison.options.runs.front().frames);
  if (comparison.options.repeat == 1) {
    return "One run of " + frames + " frames in each world; repeat it to see how much the times vary." +
           clockSentence(comparison);
  }
  const std::string clock = clockSentence(comparison);
  return "Medians of " + std::to_string(comparison.options.repeat) + " interleaved repeats of " + frames +
         " frames; in brackets the smallest and the largest ratio. " +
         (clock.empty() ? "Counts are the same in all repeats."
                        : "Counts of the other worlds are the same in all repeats." + clock);
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
