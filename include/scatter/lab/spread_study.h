#pragma once

#include <scatter/lab/comparison.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace scatter {

/// A figure of a whole run that differs from seed to seed although the physics is the same.
struct SpreadQuantity {
  std::string name;  ///< A column name, such as "deepest_penetration".
  std::string unit;
  std::string what;  ///< A few words.
};

/// deepest_penetration and p99_penetration over the frames; penetration_end, kinetic_energy_end (means of the
/// last hundred frames) and kinetic_energy_peak; pile_radius and pile_median_distance: the root mean square
/// and the median distance of the hybrids' centres of mass from their mean after the last frame, zero without
/// hybrids; mean_height of all dynamic bodies' centres of mass then; asleep_from: the first frame since which
/// no body was awake, or one more than there are frames. With fidelity also, as FidelityStatistics has it:
/// impact_finest, impact_overlaps (pairs per hundred that touch) and impact_gap of the hundred frames after
/// the impact; finest, overlaps and gap of the whole run.
[[nodiscard]] std::vector<SpreadQuantity> spreadQuantities(bool withFidelity = false);

/// Worlds with budgets that are multiples of what a scene takes with everything at level 1.
struct SpreadBudgets {
  RunOptions governed{};  ///< The world that is given the budgets.
  RunOptions coarsest{};  ///< The same with everything at level 1: its dearest frame, in units, is the floor.
  std::vector<double> floors{};
};

struct SpreadOptions {
  std::vector<RunOptions> worlds{};  ///< The first is what the others are compared to. Their seed is ignored.
  std::vector<std::uint64_t> seeds{};
  std::optional<SpreadBudgets> budgets{};  ///< Worlds that come after the others.

  /// The scene of a seed, as in RunOptions::scene, for seeds that have one each; without it all run the
  /// worlds' own.
  std::function<std::string(std::uint64_t seed)> sceneOf{};
};

struct WorldSpread {
  std::string label;
  std::vector<std::vector<double>> values;  ///< [seed][quantity].
  std::vector<Spread> spreads;              ///< Of each quantity over the seeds.
};

struct SpreadStudy {
  std::vector<std::uint64_t> seeds;
  std::vector<SpreadQuantity> quantities;  ///< Those of fidelity only if the first world measures it.
  std::vector<WorldSpread> worlds;

  /// The world's median of a quantity lies within the first world's extremes.
  [[nodiscard]] bool isWithin(std::size_t world, std::size_t quantity) const;

  /// In how many seeds the world's value is above the first world's, and in how many it is below.
  [[nodiscard]] std::pair<int, int> aboveAndBelow(std::size_t world, std::size_t quantity) const;

  /// The first world's figures are not the same with every seed, or there is one seed.
  [[nodiscard]] bool hasSpread() const;
};

/// Runs every world once for each seed, all worlds of a seed after one another. Fails as runScene does, and
/// without a world or a seed.
[[nodiscard]] Result<SpreadStudy> studySpread(
    const SpreadOptions& options, const std::function<void(const CompareProgress&)>& progress = {});

/// Each quantity's median and extremes over the seeds in each world, whether the median lies within the first
/// world's extremes, and in how many seeds the value is above and below the first world's; says so if
/// there is no spread. Ends with a new line.
[[nodiscard]] std::string formatSpread(const SpreadStudy& study);

/// One line for each world and seed.
[[nodiscard]] std::string spreadCsv(const SpreadStudy& study);

}  // namespace scatter
