#include <scatter/lab/collision_steps.h>

#include "lab/text.h"
#include "lab/text_table.h"

#include <cassert>
#include <utility>

namespace scatter {

namespace {

using Cells = std::vector<std::string>;

constexpr PairSteps kNoSteps{.midphase = PairMidphase::kWorldBoxes,
                             .motionBound = false,
                             .cachedAxis = false,
                             .lazyManifolds = false,
                             .ownGjk = false,
                             .warmSimplex = false};

CollisionStep hybridStep(std::string label, std::string what, const PairSteps& steps,
                         Policy policy = Policy::kFinest) {
  CollisionStep step{.label = std::move(label), .what = std::move(what), .physics = {}};
  step.physics.world = WorldKind::kHybrid;
  step.physics.switching.switching = Switching::kBody;
  step.physics.switching.policy = policy;
  step.physics.collision.pairAlgorithm = steps;
  return step;
}

std::vector<CollisionStep> makeSteps() {
  PairSteps boxes = kNoSteps;
  boxes.midphase = PairMidphase::kPartBoxes;
  PairSteps motion = boxes;
  motion.motionBound = true;
  PairSteps axis = boxes;
  axis.cachedAxis = true;
  PairSteps lazy = boxes;
  lazy.lazyManifolds = true;
  PairSteps list;
  list.ownGjk = false;
  list.warmSimplex = false;
  PairSteps gjk;
  gjk.warmSimplex = false;
  PairSteps recycled;
  recycled.recycling = kUsualRecycling;
  return {{.label = "standard", .what = "plain engine", .physics = {}},
          hybridStep("world_boxes", "world bounds of the parts", kNoSteps),
          hybridStep("part_boxes", "part boxes in the bodies' frames", boxes),
          hybridStep("motion_bound", "part boxes and motion bound", motion),
          hybridStep("cached_axis", "part boxes and cached axis", axis),
          hybridStep("lazy_manifolds", "part boxes and lazy manifolds", lazy),
          hybridStep("neighbour_list", "all three and a neighbour list", list),
          hybridStep("own_gjk", "the same + own GJK", gjk),
          hybridStep("warm_simplex", "the same + warm simplex: the default", {}),
          hybridStep("recycled", "the default + contacts recycled within 1 mm", recycled),
          hybridStep("level_1", "the default with everything at level 1", {}, Policy::kCoarsest)};
}

double peakOf(const ComparedWorld& world, std::string_view counter) {
  return world.run().summary.counter(counter).peak;
}

std::string share(std::uint64_t bytes, std::uint64_t count, int decimals) {
  return count == 0 ? "-"
                    : lab::fixedNumber(static_cast<double>(bytes) / static_cast<double>(count), decimals);
}

Cells bytesOf(const ComparedWorld& world) {
  const CollisionMemory& memory = world.run().summary.collisionMemory;
  return {share(memory.pairBytes, memory.pairs, 0), share(memory.childPairBytes, memory.childPairs, 1)};
}

Cells countsOf(const ComparedWorld& world) {
  Cells cells;
  for (const char* counter : {"manifolds", "child_pairs", "gjk_runs", "detector_runs"}) {
    cells.push_back(lab::fixedNumber(peakOf(world, counter), 0));
  }
  return cells;
}

void append(Cells& cells, const Cells& more) {
  cells.insert(cells.end(), more.begin(), more.end());
}

Cells rowOf(const ComparedWorld& world, const std::string& what, bool withExtremes) {
  std::vector<double> peaks;
  for (const Run& run : world.repeats) {
    peaks.push_back(run.summary.physicsCpuMs.peak);
  }
  const TimeRatios& ratios = world.physicsCpuMs;
  Cells cells{what, lab::readableNumber(medianOf(std::move(peaks)))};
  for (const Spread* ratio : {&ratios.peak, &ratios.total, &ratios.lastHundred}) {
    cells.push_back(lab::ratioText(*ratio, withExtremes));
  }
  append(cells, countsOf(world));
  append(cells, bytesOf(world));
  return cells;
}

}  // namespace

const std::vector<CollisionStep>& collisionSteps() {
  static const std::vector<CollisionStep> steps = makeSteps();
  return steps;
}

std::vector<RunOptions> collisionStepRuns(const RunOptions& base) {
  std::vector<RunOptions> runs;
  for (const CollisionStep& step : collisionSteps()) {
    RunOptions run = base;
    run.label = step.label;
    run.physics = step.physics;
    run.physics.profiling = base.physics.profiling;
    runs.push_back(std::move(run));
  }
  return runs;
}

std::string formatCollisionSteps(const Comparison& comparison) {
  assert(comparison.worlds.size() == collisionSteps().size());
  std::vector<Cells> lines{{"ratios to the standard world", "peak ms", "peak", "total", "last 100",
                            "manifolds", "child pairs", "GJK runs", "detectors", "B/pair", "B/child pair"}};
  for (std::size_t i = 0; i < comparison.worlds.size(); ++i) {
    lines.push_back(rowOf(comparison.worlds[i], collisionSteps()[i].what, comparison.options.repeat > 1));
  }
  return lab::textTable(lines) +
         lab::fitTerminal("Processor time of the physics, medians of " +
                          std::to_string(comparison.options.repeat) +
                          " interleaved repeats (smallest-largest ratio). Counts are the most in any frame.");
}

std::string collisionStepsCsv(const Comparison& comparison) {
  Cells header{"step"};
  for (const char* figure : {"peak", "total", "last_100"}) {
    for (const char* part : {"_ratio", "_ratio_min", "_ratio_max"}) {
      header.push_back(std::string(figure) + part);
    }
  }
  append(header, {"manifolds_peak", "child_pairs_peak", "gjk_runs_peak", "detector_runs_peak",
                  "bytes_per_pair", "bytes_per_child_pair"});
  std::vector<Cells> lines{std::move(header)};
  for (const ComparedWorld& world : comparison.worlds) {
    Cells cells{world.label()};
    const TimeRatios& ratios = world.physicsCpuMs;
    for (const Spread* ratio : {&ratios.peak, &ratios.total, &ratios.lastHundred}) {
      for (const double value : {ratio->median, ratio->min, ratio->max}) {
        cells.push_back(lab::shortestNumber(value));
      }
    }
    append(cells, countsOf(world));
    append(cells, bytesOf(world));
    lines.push_back(std::move(cells));
  }
  return lab::csvText(lines);
}

}  // namespace scatter
