// What worlds take of each other's time in the same frame of a scene: they step in turn, so that a drift of
// the machine, and a neighbour, hit all alike. For worlds that go the same way, as with other numbers of
// threads.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "lab/scene_run.h"
#include "run_arguments.h"

namespace {

using scatter::Result;
using scatter::lab::SceneRun;

struct InTurnOptions {
  std::string scene = "fleet";
  std::vector<std::string> worlds{"lean", "lean@2threads"};
  int frames = 0;            ///< 0: the scene's.
  double budgetUnits = 0.0;  ///< Of worlds that have one; 0: none.
  int repeat = 3;
};

/// Frames of so many contacts at least, in the first world: what is worth threads differs with the load.
constexpr double kLoads[] = {0, 100, 500, 2000, 4000};

/// Of one frame of one repeat.
struct InTurnSample {
  double contacts = 0.0;  ///< In the first world.
  double ratio = 0.0;     ///< Milliseconds of the physics by those of the first world.
};

Result<std::vector<std::unique_ptr<SceneRun>>> makeRunsInTurn(const InTurnOptions& options) {
  scatter::app::RunArguments arguments;
  arguments.scene = options.scene;
  if (options.frames > 0) arguments.frames = options.frames;
  if (options.budgetUnits > 0.0) arguments.switching.budgetUnits = options.budgetUnits;
  const auto all = scatter::app::makeRuns(arguments, options.worlds);
  if (!all) return tl::unexpected(all.error());
  std::vector<std::unique_ptr<SceneRun>> runs;
  for (const scatter::RunOptions& one : *all) {
    auto resolved = scatter::resolveRun(one);
    if (!resolved) return tl::unexpected(resolved.error());
    auto run = SceneRun::create(*resolved);
    if (!run) return tl::unexpected(run.error());
    runs.push_back(std::move(*run));
  }
  return runs;
}

// Each is the first in turn, as what steps after another finds less of its own in the cache.
Result<void> stepInTurn(std::vector<std::unique_ptr<SceneRun>>& runs) {
  const int frames = runs.front()->options().frames;
  for (int frame = 0; frame < frames; ++frame) {
    for (std::size_t k = 0; k < runs.size(); ++k) {
      SceneRun& run = *runs[(k + static_cast<std::size_t>(frame)) % runs.size()];
      run.step();
      if (!run.stopped().empty()) return scatter::fail(run.stopped());
    }
  }
  for (const auto& run : runs) {
    if (run->world().physics().stateHash() != runs.front()->world().physics().stateHash())
      return scatter::fail(run->options().label + " goes another way than " + runs.front()->options().label +
                           ", so that their frames are not the same work; use `scatter bench worlds`");
  }
  return {};
}

void collectRatios(const std::vector<std::unique_ptr<SceneRun>>& runs,
                   std::vector<std::vector<InTurnSample>>& samples) {
  const auto& first = runs.front()->table();
  for (std::size_t k = 1; k < runs.size(); ++k) {
    for (std::size_t i = 0; i < first.frames(); ++i) {
      samples[k].push_back({first.values("contacts")[i], runs[k]->table().values("physics_ms")[i] /
                                                             std::max(first.values("physics_ms")[i], 1e-6)});
    }
  }
}

void reportLoads(const std::string& world, const std::vector<InTurnSample>& samples) {
  for (std::size_t i = 0; i < std::size(kLoads); ++i) {
    const double end = i + 1 < std::size(kLoads) ? kLoads[i + 1] : std::numeric_limits<double>::infinity();
    std::vector<double> ratios;
    for (const InTurnSample& sample : samples)
      if (sample.contacts >= kLoads[i] && sample.contacts < end) ratios.push_back(sample.ratio);
    if (ratios.empty()) continue;
    std::sort(ratios.begin(), ratios.end());
    const std::size_t count = ratios.size();
    std::printf("%s, from %.0f contacts: %.3f (quarters %.3f-%.3f) in %zu frames\n", world.c_str(), kLoads[i],
                ratios[count / 2], ratios[count / 4], ratios[count * 3 / 4], count);
  }
}

int refuseInTurn(const std::string& why) {
  std::fprintf(stderr, "in_turn: %s\n", why.c_str());
  return 2;
}

int runInTurn(const InTurnOptions& options) {
  std::vector<std::vector<InTurnSample>> samples(options.worlds.size());
  for (int i = 0; i < options.repeat; ++i) {
    auto runs = makeRunsInTurn(options);
    if (!runs) return refuseInTurn(runs.error().message);
    if (const auto stepped = stepInTurn(*runs); !stepped) return refuseInTurn(stepped.error().message);
    collectRatios(*runs, samples);
  }
  std::printf("%s: wall time of the physics, as ratios to %s in the same frame, medians of %d repeats\n",
              options.scene.c_str(), options.worlds.front().c_str(), options.repeat);
  for (std::size_t k = 1; k < samples.size(); ++k) reportLoads(options.worlds[k], samples[k]);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  InTurnOptions options;
  CLI::App app("What worlds take of each other's time, frame by frame: they step in turn.");
  app.add_option("--scene", options.scene, "a scene's name, or a file")->capture_default_str();
  app.add_option("--worlds", options.worlds, "as `scatter compare` takes them; others by the first")
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--frames", options.frames, "steps of 1/60 s a repeat")->check(CLI::PositiveNumber);
  app.add_option("--budget-units", options.budgetUnits, "a budget, of hybrid worlds")
      ->check(CLI::PositiveNumber);
  app.add_option("--repeat", options.repeat, "repeats")->check(CLI::PositiveNumber)->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return runInTurn(options);
}
