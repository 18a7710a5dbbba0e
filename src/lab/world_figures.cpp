#include <scatter/lab/world_figures.h>

#include "lab/repeats.h"
#include "lab/text.h"
#include "lab/text_table.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <numeric>
#include <utility>

namespace scatter {

namespace {

using Cells = std::vector<std::string>;

TimeStatistics medianTimes(const ComparedWorld& world) {
  const auto median = [&world](double TimeStatistics::*figure) {
    return lab::medianOver(world, [figure](const Summary& run) { return run.physicsCpuMs.*figure; });
  };
  const double over = lab::medianOver(
      world, [](const Summary& run) { return static_cast<double>(run.physicsCpuMs.framesOverBudget); });
  return {.peak = median(&TimeStatistics::peak),
          .p999 = median(&TimeStatistics::p999),
          .p99 = median(&TimeStatistics::p99),
          .median = median(&TimeStatistics::median),
          .total = median(&TimeStatistics::total),
          .lastHundred = median(&TimeStatistics::lastHundred),
          .framesOverBudget = static_cast<std::uint64_t>(std::ceil(over))};
}

void addFidelity(const ComparedWorld& world, WorldFigures& figures) {
  const auto median = [&world](auto figure) {
    return lab::medianOver(world, [figure](const Summary& run) { return figure(run.fidelity); });
  };
  using Statistics = FidelityStatistics;
  figures.hasFidelity = true;
  figures.visibleOverlapMean = median([](const Statistics& run) { return run.visibleOverlapMean; });
  figures.visibleOverlapPer100 = median([](const Statistics& run) { return run.visibleOverlapPer100; });
  figures.contactGapP95 = median([](const Statistics& run) { return run.contactGapP95; });
  figures.contactGapP95Percent = median([](const Statistics& run) { return run.contactGapP95Percent(); });
  figures.finestShareMean = median([](const Statistics& run) { return run.finestShareMean; });
  figures.finestShareWorst = median([](const Statistics& run) { return run.finestShareWorst; });
  figures.largestJump = median([](const Statistics& run) { return run.largestJump; });
  figures.impactFinestShare = median([](const Statistics& run) { return run.impactFinestShare; });
  figures.impactContactGapP95 = median([](const Statistics& run) { return run.impactContactGapP95; });
  figures.pileRadius = median([](const Statistics& run) { return run.pileRadius; });
  figures.kineticEnergyEnd = median([](const Statistics& run) { return run.kineticEnergyEnd; });
}

bool anyFidelity(const std::vector<WorldFigures>& worlds) {
  return std::any_of(worlds.begin(), worlds.end(),
                     [](const WorldFigures& world) { return world.hasFidelity; });
}

struct RatioColumn {
  const char* name;
  Spread TimeRatios::*ratio;
  double TimeStatistics::*time;
};

constexpr std::array<RatioColumn, 4> kRatioColumns{{
    {"peak", &TimeRatios::peak, &TimeStatistics::peak},
    {"p99", &TimeRatios::p99, &TimeStatistics::p99},
    {"total", &TimeRatios::total, &TimeStatistics::total},
    {"last_100", &TimeRatios::lastHundred, &TimeStatistics::lastHundred},
}};

/// Stages are timed by the wall. What a frame's detection took beyond the processor time of the whole frame
/// is somebody else's.
double collisionMs(const Run& run) {
  const std::vector<double>& wall = run.table.values("collision_detection_ms");
  const std::vector<double>& processor = run.table.values("physics_cpu_ms");
  return std::inner_product(wall.begin(), wall.end(), processor.begin(), 0.0, std::plus<>(),
                            [](double a, double b) { return std::min(a, b); });
}

/// Worlds may fall asleep at different times: what is asleep costs nothing, and counts for nothing.
double awakeStepUs(const Run& run) {
  const double bodySteps = run.summary.counter("awake_bodies").total;
  return bodySteps > 0.0 ? 1000.0 * run.summary.physicsCpuMs.total / bodySteps : 0.0;
}

double medianOfRuns(const ComparedWorld& world, double (*figure)(const Run& run)) {
  std::vector<double> values;
  for (const Run& run : world.repeats) {
    values.push_back(figure(run));
  }
  return medianOf(std::move(values));
}

/// What is no statistic of the frames' processor times.
struct WorkColumn {
  const char* name;     ///< In a file, of the figure.
  const char* ratio;    ///< In a file, of its ratio.
  const char* heading;  ///< In a table.
  double WorldFigures::*value;
  Spread WorldFigures::*spread;
};

constexpr std::array<WorkColumn, 2> kWorkColumns{{
    {"collision_detection_ms", "collision_detection_ratio", "collision", &WorldFigures::collisionMs,
     &WorldFigures::collisionRatio},
    {"awake_body_step_us", "awake_body_step_ratio", "per awake", &WorldFigures::awakeStepUs,
     &WorldFigures::awakeStepRatio},
}};

struct FidelityColumn {
  const char* name;     ///< In a file.
  const char* heading;  ///< In a table.
  double WorldFigures::*value;
  double scale;  ///< In a table.
};

constexpr std::array<FidelityColumn, 11> kFidelityColumns{{
    {"visible_overlap_mean", "overlaps", &WorldFigures::visibleOverlapMean, 1.0},
    {"visible_overlap_per_100_touching", "per 100", &WorldFigures::visibleOverlapPer100, 1.0},
    {"contact_gap_p95_m", "gap p95 m", &WorldFigures::contactGapP95, 1.0},
    {"contact_gap_p95_percent", "gap p95 %", &WorldFigures::contactGapP95Percent, 1.0},
    {"finest_share_mean", "finest %", &WorldFigures::finestShareMean, 100.0},
    {"finest_share_worst", "worst %", &WorldFigures::finestShareWorst, 100.0},
    {"impact_finest_share", "impact %", &WorldFigures::impactFinestShare, 100.0},
    {"impact_contact_gap_p95_m", "impact gap m", &WorldFigures::impactContactGapP95, 1.0},
    {"largest_jump_m", "jump m", &WorldFigures::largestJump, 1.0},
    {"pile_radius_m", "radius m", &WorldFigures::pileRadius, 1.0},
    {"kinetic_energy_end_j", "energy J", &WorldFigures::kineticEnergyEnd, 1.0},
}};

// Days and hours of the clock that everyone shares, such as "2024-05-01T12:00:00Z".
std::string dateNow() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm parts{};
  gmtime_r(&now, &parts);
  std::array<char, 32> text{};
  const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return {text.data(), length};
}

// What a cell of a file can hold.
std::string asCell(std::string text) {
  for (char& c : text) {
    c = c == ',' || c == '"' || c == '\n' || c == '\r' ? ' ' : c;
  }
  return text;
}

Cells surroundings() {
  const BuildInfo build = buildInfo();
  const MachineInfo machine = machineInfo();
  Cells cells{build.version,
              build.commit,
              build.compiler,
              build.buildType,
              build.flags,
              machine.cpu,
              std::to_string(machine.cores),
              machine.os,
              dateNow()};
  std::transform(cells.begin(), cells.end(), cells.begin(), asCell);
  return cells;
}

Cells csvHeader() {
  Cells header{"scene",       "world",          "frames",    "repeats",
               "governed_ms", "governed_units", "budget_ms", "frames_over_budget"};
  for (const RatioColumn& column : kRatioColumns) {
    header.push_back(std::string(column.name) + "_ms");
  }
  for (const RatioColumn& column : kRatioColumns) {
    for (const char* part : {"_ratio", "_ratio_min", "_ratio_max"}) {
      header.push_back(std::string(column.name) + part);
    }
  }
  header.emplace_back("manifolds_peak");
  for (const WorkColumn& column : kWorkColumns) {
    header.emplace_back(column.name);
    for (const char* part : {"", "_min", "_max"}) {
      header.push_back(std::string(column.ratio) + part);
    }
  }
  for (const FidelityColumn& column : kFidelityColumns) {
    header.emplace_back(column.name);
  }
  for (const char* name :
       {"engine", "version", "commit", "compiler", "build_type", "flags", "cpu", "cores", "os", "date"}) {
    header.emplace_back(name);
  }
  return header;
}

Cells csvRow(const WorldFigures& world, const Cells& around) {
  Cells cells{world.scene,
              world.label,
              std::to_string(world.frames),
              std::to_string(world.repeats),
              lab::shortestNumber(world.governedMs),
              lab::shortestNumber(world.governedUnits),
              lab::shortestNumber(world.budgetMs),
              std::to_string(world.cpuMs.framesOverBudget)};
  for (const RatioColumn& column : kRatioColumns) {
    cells.push_back(lab::shortestNumber(world.cpuMs.*column.time));
  }
  const auto addRatio = [&cells](const Spread& ratio) {
    for (const double value : {ratio.median, ratio.min, ratio.max}) {
      cells.push_back(std::isnan(value) ? std::string() : lab::shortestNumber(value));
    }
  };
  for (const RatioColumn& column : kRatioColumns) {
    addRatio(world.ratios.*column.ratio);
  }
  cells.push_back(lab::shortestNumber(world.manifoldsPeak));
  for (const WorkColumn& column : kWorkColumns) {
    cells.push_back(lab::shortestNumber(world.*column.value));
    addRatio(world.*column.spread);
  }
  for (const FidelityColumn& column : kFidelityColumns) {
    cells.push_back(world.hasFidelity ? lab::shortestNumber(world.*column.value) : std::string());
  }
  cells.push_back(asCell(world.engine));
  cells.insert(cells.end(), around.begin(), around.end());
  return cells;
}

}  // namespace

std::vector<WorldFigures> worldFigures(const Comparison& comparison) {
  std::vector<WorldFigures> all;
  for (const ComparedWorld& world : comparison.worlds) {
    const RunOptions& options = world.run().options;
    const bool hybrid = options.physics.world == WorldKind::kHybrid;
    WorldFigures figures{.scene = options.scene,
                         .label = options.label,
                         .engine = world.run().summary.engine,
                         .frames = world.run().summary.frames,
                         .repeats = comparison.options.repeat,
                         .governedMs = hybrid ? options.physics.switching.budget.milliseconds : 0.0,
                         .governedUnits = hybrid ? options.physics.switching.budget.units : 0.0,
                         .budgetMs = options.budgetMs,
                         .cpuMs = medianTimes(world),
                         .ratios = world.physicsCpuMs,
                         .manifoldsPeak = lab::medianOver(
                             world, [](const Summary& run) { return run.counter("manifolds").peak; }),
                         .collisionMs = medianOfRuns(world, collisionMs),
                         .collisionRatio = lab::ratioOver(world, comparison.worlds.front(), collisionMs),
                         .awakeStepUs = medianOfRuns(world, awakeStepUs),
                         .awakeStepRatio = lab::ratioOver(world, comparison.worlds.front(), awakeStepUs)};
    if (options.fidelityEvery > 0) {
      addFidelity(world, figures);
    }
    all.push_back(std::move(figures));
  }
  return all;
}

Result<std::vector<WorldFigures>> benchWorlds(
    const std::vector<CompareOptions>& scenes,
    const std::function<void(const std::string& scene, const CompareProgress&)>& progress) {
  std::vector<WorldFigures> all;
  for (const CompareOptions& scene : scenes) {
    const auto comparison = compareWorlds(scene, [&](const CompareProgress& inside) {
      if (progress) {
        progress(scene.runs.front().scene, inside);
      }
    });
    if (!comparison) {
      return tl::unexpected(comparison.error());
    }
    const auto figures = worldFigures(*comparison);
    all.insert(all.end(), figures.begin(), figures.end());
  }
  return all;
}

std::string formatWorldFigures(const std::vector<WorldFigures>& worlds) {
  const bool fidelity = anyFidelity(worlds);
  Cells header{"scene, world", "peak ms", "over", "peak", "p99", "total", "last 100"};
  for (const WorkColumn& column : kWorkColumns) {
    header.emplace_back(column.heading);
  }
  for (const FidelityColumn& column : kFidelityColumns) {
    if (fidelity) {
      header.emplace_back(column.heading);
    }
  }
  std::vector<Cells> lines{std::move(header)};
  for (const WorldFigures& world : worlds) {
    Cells cells{world.scene + ", " + world.label, lab::readableNumber(world.cpuMs.peak),
                std::to_string(world.cpuMs.framesOverBudget)};
    for (const RatioColumn& column : kRatioColumns) {
      cells.push_back(lab::ratioText(world.ratios.*column.ratio, world.repeats > 1));
    }
    for (const WorkColumn& column : kWorkColumns) {
      cells.push_back(lab::ratioText(world.*column.spread, world.repeats > 1));
    }
    for (const FidelityColumn& column : kFidelityColumns) {
      if (fidelity) {
        cells.push_back(lab::readableNumber(column.scale * world.*column.value));
      }
    }
    lines.push_back(std::move(cells));
  }
  const std::string repeats = worlds.empty() ? "0" : std::to_string(worlds.front().repeats);
  return lab::textTable(lines) +
         lab::fitTerminal(
             "Processor time of the physics: ratios to the scene's first world, medians of " + repeats +
             " interleaved repeats (smallest-largest); over: frames over the world's budget. "
             "collision: time in collision detection; per awake: processor time for each awake body "
             "and step.");
}

std::string worldFiguresCsv(const std::vector<WorldFigures>& worlds) {
  std::vector<Cells> lines{csvHeader()};
  const Cells around = surroundings();
  for (const WorldFigures& world : worlds) {
    lines.push_back(csvRow(world, around));
  }
  return lab::csvText(lines);
}

}  // namespace scatter
