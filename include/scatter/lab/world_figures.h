#pragma once

#include <scatter/lab/comparison.h>

#include <functional>
#include <string>
#include <vector>

namespace scatter {

/// What one world of a comparison took and how true it was: medians over the repeats.
struct WorldFigures {
  std::string scene;
  std::string label;
  std::string engine;
  std::uint64_t frames = 0;
  int repeats = 0;
  double governedMs = 0.0;  ///< The time that it was governed to; 0 if it was not.
  double governedUnits = 0.0;
  double budgetMs = 0.0;  ///< What its frames were counted against.
  TimeStatistics cpuMs;   ///< Processor time of the physics; framesOverBudget is rounded up.
  TimeRatios ratios;      ///< Of that to the scene's first world.
  double manifoldsPeak = 0.0;

  /// Of collision detection, all frames: wall time, of each frame no more than its processor time.
  double collisionMs = 0.0;
  Spread collisionRatio;
  double awakeStepUs = 0.0;  ///< Processor microseconds, all frames, for each awake body in each step.
  Spread awakeStepRatio;     ///< Not a number if the first world's bodies all slept.

  bool hasFidelity = false;  ///< Was it measured? Else the rest is zero.
  double visibleOverlapMean = 0.0;
  double visibleOverlapPer100 = 0.0;
  double contactGapP95 = 0.0;  ///< Metres.
  double contactGapP95Percent = 0.0;
  double finestShareMean = 0.0;   ///< 0 to 1.
  double finestShareWorst = 0.0;  ///< 0 to 1.
  double largestJump = 0.0;       ///< Metres.
  double impactFinestShare = 0.0;
  double impactContactGapP95 = 0.0;
  double pileRadius = 0.0;
  double kineticEnergyEnd = 0.0;
};

[[nodiscard]] std::vector<WorldFigures> worldFigures(const Comparison& comparison);

/// Compares the worlds of one scene after another and keeps their figures only. Fails as compareWorlds does.
[[nodiscard]] Result<std::vector<WorldFigures>> benchWorlds(
    const std::vector<CompareOptions>& scenes,
    const std::function<void(const std::string& scene, const CompareProgress&)>& progress = {});

/// A table of times and ratios, one line for each scene and world, and of fidelity if it was measured; ends
/// with a new line.
[[nodiscard]] std::string formatWorldFigures(const std::vector<WorldFigures>& worlds);

/// The same as CSV, with the build, the machine and the date in every row.
[[nodiscard]] std::string worldFiguresCsv(const std::vector<WorldFigures>& worlds);

}  // namespace scatter
