#pragma once

#include <scatter/lab/comparison.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace scatter {

/// A figure of a whole run that differs from seed to seed although the physics is the same.
struct SpreadQuantity {
  std::string name;  ///< A column name, such as "deepest_penetration".
  std::string unit;
  std::string what;  ///< A few words.
};

/// deepest_penetration and p99_penetration over the frames; kinetic_energy_peak and kinetic_energy_end
/// (the mean of the last hundred frames); pile_radius and pile_median_distance: the root mean square and the
/// median distance of the hybrids' centres of mass from their mean after the last frame, zero without
/// hybrids.
[[nodiscard]] const std::vector<SpreadQuantity>& spreadQuantities();

struct SpreadOptions {
  std::vector<RunOptions> worlds{};  ///< The first is what the others are compared to. Their seed is ignored.
  std::vector<std::uint64_t> seeds{};
};

struct WorldSpread {
  std::string label;
  std::vector<std::vector<double>> values;  ///< [seed][quantity].
  std::vector<Spread> spreads;              ///< Of each quantity over the seeds.
};

struct SpreadStudy {
  std::vector<std::uint64_t> seeds;
  std::vector<WorldSpread> worlds;

  /// The world's median of a quantity lies within the first world's extremes.
  [[nodiscard]] bool isWithin(std::size_t world, std::size_t quantity) const;
};

/// Runs every world once for each seed, all worlds of a seed after one another. Fails as runScene does, and
/// without a world or a seed.
[[nodiscard]] Result<SpreadStudy> studySpread(
    const SpreadOptions& options, const std::function<void(const CompareProgress&)>& progress = {});

/// Each quantity's median and extremes over the seeds in each world, and whether the median lies within the
/// first world's extremes; ends with a new line.
[[nodiscard]] std::string formatSpread(const SpreadStudy& study);

/// One line for each world and seed.
[[nodiscard]] std::string spreadCsv(const SpreadStudy& study);

}  // namespace scatter
