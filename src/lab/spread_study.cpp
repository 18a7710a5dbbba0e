#include <scatter/lab/spread_study.h>

#include "lab/pile_size.h"
#include "lab/run_series.h"
#include "lab/text.h"
#include "lab/text_table.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace scatter {

namespace {

using Cells = std::vector<std::string>;

enum Quantity : std::size_t {
  kDeepest,
  kP99,
  kDepthEnd,
  kEnergyPeak,
  kEnergyEnd,
  kRadius,
  kMedianDistance,
  kHeight,
  kAsleepFrom,
  kUsualCount,
  kImpactFinest = kUsualCount,
  kImpactOverlaps,
  kImpactGap,
  kAllFinest,
  kAllOverlaps,
  kAllGaps,
  kAllCount
};

// Counted from 1, as frames are.
double asleepFrom(const std::vector<double>& awake) {
  const auto last = std::find_if(awake.rbegin(), awake.rend(), [](double bodies) { return bodies > 0.0; });
  return static_cast<double>(awake.rend() - last) + 1.0;
}

std::vector<double> measure(const Run& run, const lab::PileSize& pile) {
  const auto& depths = run.table.values("max_penetration");
  const auto& energies = run.table.values("kinetic_energy");
  std::vector<double> values(kAllCount);
  values[kDeepest] = nearestRank(depths, 1.0);
  values[kP99] = nearestRank(depths, 0.99);
  values[kEnergyPeak] = nearestRank(energies, 1.0);
  values[kEnergyEnd] = meanOfLast(energies);
  values[kDepthEnd] = meanOfLast(depths);
  values[kRadius] = pile.radius;
  values[kMedianDistance] = pile.medianDistance;
  values[kHeight] = pile.meanHeight;
  values[kAsleepFrom] = asleepFrom(run.table.values("awake_bodies"));
  const FidelityStatistics& fidelity = run.summary.fidelity;
  values[kImpactFinest] = fidelity.impactFinestShare;
  values[kImpactOverlaps] = fidelity.impactVisibleOverlapPer100;
  values[kImpactGap] = fidelity.impactContactGapP95;
  values[kAllFinest] = fidelity.finestShareMean;
  values[kAllOverlaps] = fidelity.visibleOverlapPer100;
  values[kAllGaps] = fidelity.contactGapP95;
  return values;
}

void addSpreads(WorldSpread& world) {
  for (std::size_t quantity = 0; quantity < world.values.front().size(); ++quantity) {
    std::vector<double> values;
    for (const auto& seed : world.values) {
      values.push_back(seed[quantity]);
    }
    const auto [min, max] = std::minmax_element(values.begin(), values.end());
    const Spread extremes{.median = 0.0, .min = *min, .max = *max};
    world.spreads.push_back(extremes);
    world.spreads.back().median = medianOf(std::move(values));
  }
}

Result<void> addWorld(const RunOptions& world, const std::string& suffix, SpreadStudy& study) {
  const auto resolved = resolveRun(world);
  if (!resolved) {
    return tl::unexpected(resolved.error());
  }
  study.worlds.push_back({.label = resolved->label + suffix, .values = {}, .spreads = {}});
  return {};
}

Result<SpreadStudy> prepare(const SpreadOptions& options) {
  if (options.worlds.empty() || options.seeds.empty()) {
    return fail("a study of spreads needs at least one world and one seed; name some");
  }
  SpreadStudy study{.seeds = options.seeds,
                    .quantities = spreadQuantities(options.worlds.front().fidelityEvery > 0),
                    .worlds = {}};
  for (const RunOptions& world : options.worlds) {
    if (auto added = addWorld(world, "", study); !added) {
      return tl::unexpected(added.error());
    }
  }
  for (const double floors : options.budgets ? options.budgets->floors : std::vector<double>()) {
    const std::string suffix = "-" + lab::shortestNumber(floors) + "floors";
    if (auto added = addWorld(options.budgets->governed, suffix, study); !added) {
      return tl::unexpected(added.error());
    }
  }
  return study;
}

/// The runs of one study.
class SpreadRunner {
 public:
  SpreadRunner(const SpreadOptions& options, const std::function<void(const CompareProgress&)>& progress)
      : options_(options), series_(countRuns(options), progress) {}

  Result<void> addSeed(std::uint64_t seed, SpreadStudy& study) {
    std::size_t world = 0;
    for (const RunOptions& options : options_.worlds) {
      if (auto added = addRun(options, seed, study, study.worlds[world++]); !added) {
        return added;
      }
    }
    return options_.budgets ? addBudgets(seed, study, world) : Result<void>();
  }

 private:
  static std::size_t countRuns(const SpreadOptions& options) {
    const std::size_t budgets = options.budgets ? options.budgets->floors.size() + 1 : 0;
    return (options.worlds.size() + budgets) * options.seeds.size();
  }

  Result<void> addBudgets(std::uint64_t seed, SpreadStudy& study, std::size_t world) {
    lab::PileSize pile;
    const auto coarsest = run(options_.budgets->coarsest, seed, "coarsest", pile);
    if (!coarsest) {
      return tl::unexpected(coarsest.error());
    }
    const double floor = nearestRank(coarsest->table.values("cost_units"), 1.0);
    if (!(floor > 0.0)) {
      return fail("there is nothing to govern: the coarsest world costs nothing");
    }
    for (const double floors : options_.budgets->floors) {
      RunOptions governed = options_.budgets->governed;
      governed.physics.switching.budget.units = floors * floor;
      if (auto added = addRun(governed, seed, study, study.worlds[world++]); !added) {
        return added;
      }
    }
    return {};
  }

  Result<void> addRun(const RunOptions& options, std::uint64_t seed, const SpreadStudy& study,
                      WorldSpread& world) {
    lab::PileSize pile;
    const auto done = run(options, seed, world.label, pile);
    if (!done) {
      return tl::unexpected(done.error());
    }
    world.values.push_back(measure(*done, pile));
    world.values.back().resize(study.quantities.size());
    return {};
  }

  Result<Run> run(RunOptions options, std::uint64_t seed, std::string label, lab::PileSize& pile) {
    options.seed = seed;
    options.inspect = [&pile](const World& world) { pile = lab::pileSize(world); };
    if (options_.sceneOf) {
      options.scene = options_.sceneOf(seed);
      options.makeScene = {};
    }
    return series_.run(options, std::move(label));
  }

  const SpreadOptions& options_;
  lab::RunSeries series_;
};

std::string spreadText(const Spread& spread) {
  return lab::readableNumber(spread.median) + " (" + lab::readableNumber(spread.min) + "-" +
         lab::readableNumber(spread.max) + ")";
}

std::string withinText(const SpreadStudy& study, std::size_t world, std::size_t quantity) {
  const auto [above, below] = study.aboveAndBelow(world, quantity);
  return std::string(study.isWithin(world, quantity) ? "yes" : "no") + ", +" + std::to_string(above) + " -" +
         std::to_string(below);
}

}  // namespace

std::vector<SpreadQuantity> spreadQuantities(bool withFidelity) {
  std::vector<SpreadQuantity> quantities{
      {"deepest_penetration", "m", "deepest penetration"},
      {"p99_penetration", "m", "deepest of a frame, p99"},
      {"penetration_end", "m", "deepest of a frame, last 100"},
      {"kinetic_energy_peak", "J", "kinetic energy, peak"},
      {"kinetic_energy_end", "J", "kinetic energy, last 100"},
      {"pile_radius", "m", "pile radius (RMS)"},
      {"pile_median_distance", "m", "pile radius (median)"},
      {"mean_height", "m", "height of the bodies, mean"},
      {"asleep_from", "frame", "all asleep from"},
      {"impact_finest", "1", "at the finest level, impact"},
      {"impact_overlaps", "1", "overlaps of 100 pairs, impact"},
      {"impact_gap", "m", "contact gap p95, impact"},
      {"finest", "1", "at the finest level"},
      {"overlaps", "1", "overlaps of 100 pairs"},
      {"gap", "m", "contact gap p95"},
  };
  if (!withFidelity) quantities.resize(kUsualCount);
  return quantities;
}

bool SpreadStudy::isWithin(std::size_t world, std::size_t quantity) const {
  const Spread& first = worlds.front().spreads[quantity];
  const double median = worlds[world].spreads[quantity].median;
  return median >= first.min && median <= first.max;
}

bool SpreadStudy::hasSpread() const {
  const auto& bySeed = worlds.front().values;
  return seeds.size() == 1 || !std::equal(bySeed.begin() + 1, bySeed.end(), bySeed.begin());
}

std::pair<int, int> SpreadStudy::aboveAndBelow(std::size_t world, std::size_t quantity) const {
  std::pair<int, int> counts{0, 0};
  for (std::size_t seed = 0; seed < seeds.size(); ++seed) {
    const double own = worlds[world].values[seed][quantity];
    const double first = worlds.front().values[seed][quantity];
    counts.first += own > first ? 1 : 0;
    counts.second += own < first ? 1 : 0;
  }
  return counts;
}

Result<SpreadStudy> studySpread(const SpreadOptions& options,
                                const std::function<void(const CompareProgress&)>& progress) {
  auto study = prepare(options);
  if (!study) {
    return study;
  }
  SpreadRunner runner(options, progress);
  for (const std::uint64_t seed : options.seeds) {
    if (auto added = runner.addSeed(seed, *study); !added) {
      return tl::unexpected(added.error());
    }
  }
  for (WorldSpread& world : study->worlds) {
    addSpreads(world);
  }
  return study;
}

std::string formatSpread(const SpreadStudy& study) {
  Cells header{"over " + std::to_string(study.seeds.size()) + " seeds"};
  for (std::size_t i = 0; i < study.worlds.size(); ++i) {
    header.push_back(study.worlds[i].label);
    if (i > 0) {
      header.emplace_back("within");
    }
  }
  std::vector<Cells> lines{std::move(header)};
  for (std::size_t quantity = 0; quantity < study.quantities.size(); ++quantity) {
    const SpreadQuantity& about = study.quantities[quantity];
    Cells cells{about.what + ", " + about.unit};
    for (std::size_t i = 0; i < study.worlds.size(); ++i) {
      cells.push_back(spreadText(study.worlds[i].spreads[quantity]));
      if (i > 0) {
        cells.emplace_back(withinText(study, i, quantity));
      }
    }
    lines.push_back(std::move(cells));
  }
  return lab::textTable(lines) +
         lab::fitTerminal(
             "Median (smallest-largest). Within: the median lies between the extremes of the " +
             study.worlds.front().label + " world; +a -b: in a seeds it is above that world's, in b below." +
             (study.hasSpread() ? ""
                                : " No seed changes anything in the " + study.worlds.front().label +
                                      " world, so that there is no spread to compare with: take "
                                      "a scene in which something is random."));
}

std::string spreadCsv(const SpreadStudy& study) {
  Cells header{"world", "seed"};
  for (const SpreadQuantity& quantity : study.quantities) {
    header.push_back(quantity.name);
  }
  std::vector<Cells> lines{std::move(header)};
  for (const WorldSpread& world : study.worlds) {
    for (std::size_t seed = 0; seed < study.seeds.size(); ++seed) {
      Cells cells{world.label, std::to_string(study.seeds[seed])};
      for (const double value : world.values[seed]) {
        cells.push_back(lab::shortestNumber(value));
      }
      lines.push_back(std::move(cells));
    }
  }
  return lab::csvText(lines);
}

}  // namespace scatter
