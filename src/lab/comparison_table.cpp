#include "lab/comparison_table.h"

#include "lab/budget_report.h"
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
    {"CPU ms, peak", &Summary::physicsCpuMs, &TimeStatistics::peak, &ComparedWorld::physicsCpuMs,
     &TimeRatios::peak},
    {"CPU ms, p99", &Summary::physicsCpuMs, &TimeStatistics::p99, &ComparedWorld::physicsCpuMs,
     &TimeRatios::p99},
    {"CPU ms, median", &Summary::physicsCpuMs, &TimeStatistics::median, &ComparedWorld::physicsCpuMs,
     &TimeRatios::median},
    {"CPU ms, total", &Summary::physicsCpuMs, &TimeStatistics::total, &ComparedWorld::physicsCpuMs,
     &TimeRatios::total},
    {"CPU ms, last 100 mean", &Summary::physicsCpuMs, &TimeStatistics::lastHundred,
     &ComparedWorld::physicsCpuMs, &TimeRatios::lastHundred},
    {"wall ms, peak", &Summary::physicsMs, &TimeStatistics::peak, &ComparedWorld::physicsMs,
     &TimeRatios::peak},
    {"wall ms, total", &Summary::physicsMs, &TimeStatistics::total, &ComparedWorld::physicsMs,
     &TimeRatios::total},
};

lab::ComparisonRow timeRow(const Comparison& comparison, const TimeFigure& time) {
  lab::ComparisonRow row{.name = time.name, .values = {}, .ratios = {}, .extremes = {}};
  for (const ComparedWorld& world : comparison.worlds) {
    row.values.push_back(lab::readableNumber(
        lab::medianOver(world, [&time](const Summary& run) { return run.*time.channel.*time.figure; })));
    if (&world != &comparison.worlds.front()) {
      const Spread& ratio = world.*time.ratios.*time.ratio;
      row.ratios.push_back(lab::ratioText(ratio, false));
      if (comparison.options.repeat > 1) {
        row.extremes.push_back(lab::extremesText(ratio));
      }
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
  lab::ComparisonRow row{.name = std::move(name), .values = {}, .ratios = {}, .extremes = {}};
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
    values.push_back(lab::framesOver(world, budget));
  }
  return valueRow("frames over " + lab::readableNumber(budget) + " ms (CPU)", values, wholeNumber);
}

struct FidelityFigure {
  const char* name;
  double (*value)(const FidelityStatistics&);
};

constexpr FidelityFigure kFidelityFigures[] = {
    {"overlaps seen, mean", [](const FidelityStatistics& run) { return run.visibleOverlapMean; }},
    {"overlaps, per 100 touching", [](const FidelityStatistics& run) { return run.visibleOverlapPer100; }},
    {"contact gap p95, % length", [](const FidelityStatistics& run) { return run.contactGapP95Percent(); }},
    {"touching finely %, mean", [](const FidelityStatistics& run) { return 100.0 * run.finestShareMean; }},
    {"touching finely %, worst", [](const FidelityStatistics& run) { return 100.0 * run.finestShareWorst; }},
    {"impact: touching finely %",
     [](const FidelityStatistics& run) { return 100.0 * run.impactFinestShare; }},
    {"impact: gap p95, m", [](const FidelityStatistics& run) { return run.impactContactGapP95; }},
    {"largest jump, m", [](const FidelityStatistics& run) { return run.largestJump; }},
    {"pile radius at end, m", [](const FidelityStatistics& run) { return run.pileRadius; }},
    {"energy, last 100 mean, J", [](const FidelityStatistics& run) { return run.kineticEnergyEnd; }},
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
  return header;
}

// A row's line, and below it that of the extremes if there are any.
void addLines(const lab::ComparisonRow& row, std::vector<std::vector<std::string>>& lines) {
  std::vector<std::string> cells{row.name, row.values.front()};
  for (std::size_t i = 0; i < row.ratios.size(); ++i) {
    cells.push_back(row.values[i + 1] + (row.ratios[i] == "-" ? "" : " (" + row.ratios[i] + ")"));
  }
  lines.push_back(std::move(cells));
  if (!row.extremes.empty()) {
    std::vector<std::string> below{"", ""};
    below.insert(below.end(), row.extremes.begin(), row.extremes.end());
    lines.push_back(std::move(below));
  }
}

}  // namespace

double lab::framesOver(const ComparedWorld& world, double budgetMs) {
  std::vector<double> repeats;
  for (const Run& run : world.repeats) {
    const auto& times = run.table.values("physics_cpu_ms");
    repeats.push_back(static_cast<double>(timeStatistics(times, budgetMs).framesOverBudget));
  }
  return medianOf(std::move(repeats));
}

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
  const std::string ratios = " In brackets: as a part of the " + comparison.worlds.front().label() + " world";
  const std::string clock = clockSentence(comparison);
  if (comparison.options.repeat == 1) {
    return "One run of " + frames + " frames in each world; repeat it to see how much the times vary." +
           ratios + "." + clock;
  }
  return "Medians of " + std::to_string(comparison.options.repeat) + " interleaved repeats of " + frames +
         " frames." + ratios + ", and of ratios of times the smallest and the largest. " +
         (clock.empty() ? "Counts are the same in all repeats."
                        : "Counts of the other worlds are the same in all repeats." + clock);
}

std::vector<std::string> lab::budgetNotes(const Comparison& comparison) {
  std::vector<std::string> notes;
  for (const ComparedWorld& world : comparison.worlds) {
    std::string note = budgetSentence(world.run(), comparison.options.repeat > 1);
    if (!note.empty()) {
      notes.push_back(std::move(note));
    }
  }
  return notes;
}

std::string formatTable(const Comparison& comparison) {
  std::vector<std::vector<std::string>> lines{headerOf(comparison)};
  for (const lab::ComparisonRow& row : lab::comparisonRows(comparison)) {
    addLines(row, lines);
  }
  std::string text = lab::textTable(lines) + lab::fitTerminal(lab::comparisonNote(comparison));
  for (const std::string& note : lab::budgetNotes(comparison)) {
    text += lab::fitTerminal(note);
  }
  return text;
}

}  // namespace scatter
