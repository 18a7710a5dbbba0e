#pragma once

#include <scatter/lab/run.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace scatter {

struct CompareOptions {
  /// One for each world, the first being what the others are compared to. Labels differ; their `out` is
  /// ignored.
  std::vector<RunOptions> runs{};
  int repeat = 1;
  std::string commandLine{};  ///< For the report.

  /// Where each run is written while it goes on, as RunOptions::out: LABEL, or LABEL/repeat-1 and so on if
  /// there are several; and comparison.json, which says that the comparison is not complete. Nothing is
  /// written without it.
  std::optional<std::filesystem::path> out{};

  /// With `out`: each world's first run is stored in its folder, as run.rec, unless it has
  /// RunOptions::record. The report plays it.
  bool recordRuns = false;

  bool resume = false;  ///< Finished runs of the same comparison in `out` are taken as they are.
  bool anew = false;    ///< Finished runs of a comparison in `out` that was cut short are given up.
};

struct CompareProgress {
  std::string label;   ///< The world that runs.
  int run = 0;         ///< Counts from 0 to runs - 1.
  int runs = 0;        ///< Worlds times repeats.
  RunProgress inside;  ///< Of this run.
};

/// The median of one figure over the repeats, and its extremes.
struct Spread {
  double median = 0.0;
  double min = 0.0;
  double max = 0.0;
};

/// Of a world to the first one, each taken within a repeat. Not a number where the first world's is zero.
struct TimeRatios {
  Spread peak;
  Spread p99;
  Spread median;
  Spread total;
  Spread lastHundred;
};

struct ComparedWorld {
  std::vector<Run> repeats;  ///< In the order in which they were run.

  /// The repeat with the median total physics_cpu_ms, of an even number the lower of the middle two: the one
  /// that is written.
  std::size_t typical = 0;

  /// The typical repeat's table with the per-frame median over the repeats (of an even number the lower of
  /// the middle two) in every time column; counters are the typical repeat's. For figures.
  FrameTable median;

  TimeRatios physicsMs;  ///< To the first world; all 1 for itself.
  TimeRatios physicsCpuMs;

  /// Of the first repeat, if it was recorded.
  std::optional<std::filesystem::path> recording{};

  [[nodiscard]] const Run& run() const { return repeats[typical]; }
  [[nodiscard]] const std::string& label() const { return run().options.label; }
};

struct Comparison {
  CompareOptions options;  ///< With defaults filled in.
  std::vector<ComparedWorld> worlds;
};

/// Runs every world `repeat` times, interleaved, in an order that alternates (A B, B A, A B …) so that a
/// drift of the machine hits all alike. Fails as runScene does, and if the state hashes of a world that is
/// not governed by the clock differ between repeats: the message names the world and the first diverged
/// frame. Fails, with what is written kept, if a run's RunOptions::stop ended it; and before the first run if
/// `out` holds finished runs of a comparison that was cut short and neither `resume` nor `anew` is set, or
/// `resume` is set and it was another comparison (other options, build or machine).
[[nodiscard]] Result<Comparison> compareWorlds(
    const CompareOptions& options, const std::function<void(const CompareProgress&)>& progress = {});

/// A plain-text table for the terminal; ends with a new line.
[[nodiscard]] std::string formatTable(const Comparison& comparison);

/// Writes LABEL/frames.csv, LABEL/events.csv and LABEL/summary.json of each world's typical repeat
/// (events.csv only if the run kept its events or has been written with CompareOptions::out),
/// comparison.json, worlds.csv (times, ratios and fidelity of all worlds), figures/*.svg and *.png, and
/// report.html, which needs no other file, whole or not at all; files of other names in an existing folder
/// are left alone. Call prepareOutputFolder() before a long run to know that this will work.
[[nodiscard]] Result<void> writeComparison(const Comparison& comparison, const std::filesystem::path& folder);

/// Whether the reports of this build play recordings.
[[nodiscard]] bool hasReportPage();

}  // namespace scatter
