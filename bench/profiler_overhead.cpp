// What profiling costs: the same scene in two worlds that step in turn, one with profiling on and one with
// it off, so that a drift of the machine hits both alike.

#include <scatter/bullet/bullet_physics.h>
#include <scatter/lab/cpu_time.h>
#include <scatter/world/scene.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace {

using scatter::Result;
using scatter::World;

constexpr float kStep = 1.0F / 60.0F;

struct Options {
  std::string scene = "fleet";
  std::string world = "standard";
  int frames = 1000;  ///< Of fleet's: into the overload.
  int repeat = 6;
  std::string csv;
};

struct Lane {
  std::unique_ptr<scatter::Scene> scene;
  std::unique_ptr<World> world;
  double cpuSeconds = 0.0;

  void step() {
    scene->update(*world);
    const double before = scatter::threadCpuSeconds();
    world->step(kStep);
    cpuSeconds += scatter::threadCpuSeconds() - before;
  }
};

Result<Lane> makeLane(const Options& options, bool profiling) {
  auto info = scatter::SceneRegistry::instance().find(options.scene);
  if (!info) return scatter::fail(info.error().message);
  scatter::PhysicsDef def;
  def.world = options.world == "hybrid" ? scatter::WorldKind::kHybrid : scatter::WorldKind::kStandard;
  def.profiling = profiling;
  Lane lane{(*info)->make(), std::make_unique<World>(scatter::makeBulletPhysics(def))};
  if (auto built = lane.scene->build(*lane.world, {}); !built) return scatter::fail(built.error().message);
  return lane;
}

struct Outcome {
  double onSeconds = 0.0;
  double offSeconds = 0.0;
};

/// The world that is made first has other addresses and so another speed: the caller alternates.
Result<Outcome> measureOnce(const Options& options, bool onFirst) {
  auto made = makeLane(options, onFirst);
  if (!made) return scatter::fail(made.error().message);
  auto second = makeLane(options, !onFirst);
  if (!second) return scatter::fail(second.error().message);
  Lane* on = onFirst ? &*made : &*second;
  Lane* off = onFirst ? &*second : &*made;
  for (int frame = 0; frame < options.frames; ++frame) {
    (frame % 2 == 0 ? on : off)->step();
    (frame % 2 == 0 ? off : on)->step();
  }
  if (on->world->physics().stateHash() != off->world->physics().stateHash()) {
    return scatter::fail("profiling changed the simulation: the state hashes differ");
  }
  return Outcome{on->cpuSeconds, off->cpuSeconds};
}

void report(const Options& options, std::vector<double> overheads) {
  std::sort(overheads.begin(), overheads.end());
  std::printf(
      "profiling overhead of %s (%s world, %d frames): median %.2f %%, min %.2f %%, max %.2f %% of %zu\n",
      options.scene.c_str(), options.world.c_str(), options.frames, overheads[overheads.size() / 2],
      overheads.front(), overheads.back(), overheads.size());
}

int run(const Options& options) {
  std::FILE* csv = options.csv.empty() ? nullptr : std::fopen(options.csv.c_str(), "w");
  if (!options.csv.empty() && csv == nullptr) {
    std::fprintf(stderr, "profiler_overhead: cannot write %s; name a file in a folder that exists\n",
                 options.csv.c_str());
    return 2;
  }
  if (csv != nullptr) std::fprintf(csv, "repeat,on_s,off_s,overhead_percent\n");
  std::vector<double> overheads;
  for (int i = 0; i < options.repeat; ++i) {
    auto outcome = measureOnce(options, i % 2 == 0);
    if (!outcome) {
      std::fprintf(stderr, "profiler_overhead: %s\n", outcome.error().message.c_str());
      return 2;
    }
    const double percent = 100.0 * (outcome->onSeconds / outcome->offSeconds - 1.0);
    overheads.push_back(percent);
    std::printf("repeat %d: on %.3f s, off %.3f s, overhead %.2f %%\n", i + 1, outcome->onSeconds,
                outcome->offSeconds, percent);
    if (csv != nullptr)
      std::fprintf(csv, "%d,%.6f,%.6f,%.4f\n", i + 1, outcome->onSeconds, outcome->offSeconds, percent);
  }
  if (csv != nullptr) std::fclose(csv);
  report(options, overheads);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("What profiling costs: processor time with it on over processor time with it off.");
  app.add_option("--scene", options.scene, "registered scene")->capture_default_str();
  app.add_option("--world", options.world, "standard or hybrid")
      ->check(CLI::IsMember({"standard", "hybrid"}))
      ->capture_default_str();
  app.add_option("--frames", options.frames, "steps of 1/60 s a repeat")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--repeat", options.repeat, "repeats")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--csv", options.csv, "write the repeats to this file");
  CLI11_PARSE(app, argc, argv);
  return run(options);
}
