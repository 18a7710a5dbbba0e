// One of the scenes in another physics engine, recorded as `scatter run` records it: the same bodies, the
// same forces, the same columns. Each engine has a program of its own, made of this file and its
// <engine>_engine.cpp.

#include <scatter/lab/run.h>
#include <scatter/lab/summary.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine.h"
#include "pile_probe.h"

namespace scatter::bench {
namespace {

struct Options {
  std::string scene = "fleet";
  std::filesystem::path out;
  int frames = 0;
  std::uint64_t seed = 1;
  int pileEvery = 0;
  EngineOptions engine;
};

/// A scene that remembers the world that it was built in.
class ObservedScene final : public Scene {
 public:
  ObservedScene(std::unique_ptr<Scene> scene, World*& world) : scene_(std::move(scene)), world_(world) {}

  Result<void> build(World& world, const SceneOptions& options) override {
    world_ = &world;
    return scene_->build(world, options);
  }
  void update(World& world) override { scene_->update(world); }
  void configure(PhysicsDef& physics) const override { scene_->configure(physics); }

 private:
  std::unique_ptr<Scene> scene_;
  World*& world_;
};

struct PileFrame {
  int frame = 0;
  Pile pile;
};

Result<void> writePiles(const std::filesystem::path& file, const std::vector<PileFrame>& piles) {
  std::FILE* csv = std::fopen(file.c_str(), "w");
  if (csv == nullptr) return fail("cannot write " + file.string() + "; name a folder that can be written");
  std::fprintf(csv, "frame,pile_radius,touching_bodies,touching_pairs,deep_pairs,deepest\n");
  for (const auto& [frame, pile] : piles) {
    std::fprintf(csv, "%d,%.3f,%d,%d,%d,%.4f\n", frame, pile.radius, pile.touchingBodies, pile.touchingPairs,
                 pile.deepPairs, pile.deepest);
  }
  std::fclose(csv);
  return {};
}

void report(const Run& run, const std::vector<PileFrame>& piles) {
  const TimeStatistics& time = run.summary.physicsCpuMs;
  std::printf(
      "%s, scene %s, %d frames, processor ms a step: peak %.2f, p99 %.2f, median %.2f, total %.0f, "
      "mean of the last hundred %.2f\n",
      run.summary.engine.c_str(), run.summary.scene.c_str(), static_cast<int>(run.summary.frames), time.peak,
      time.p99, time.median, time.total, time.lastHundred);
  for (const auto& [frame, pile] : piles) {
    std::printf(
        "frame %d: nine tenths within %.2f m, %d bodies touch in %d pairs, %d pairs deeper than 5 cm, "
        "deepest %.3f m\n",
        frame, pile.radius, pile.touchingBodies, pile.touchingPairs, pile.deepPairs, pile.deepest);
  }
}

Result<void> measure(const Options& options) {
  const auto info = SceneRegistry::instance().find(options.scene);
  if (!info) return tl::unexpected(info.error());
  World* world = nullptr;
  RunOptions run;
  run.scene = options.scene;
  run.summary = (*info)->summary;
  run.makeScene = [&] { return std::make_unique<ObservedScene>((*info)->make(), world); };
  run.engine = [&](const PhysicsDef& def) { return makeEngine(options.engine, def); };
  run.frames = options.frames == 0 ? (*info)->frames : options.frames;
  run.seed = options.seed;
  run.label = engineInfo().program;
  if (!options.out.empty()) run.out = options.out;

  PileProbe probe(engineInfo().hasMargins);
  std::vector<PileFrame> piles;
  const auto done = runScene(run, [&](const RunProgress& progress) {
    if (options.pileEvery == 0 || progress.frame % options.pileEvery != 0) return;
    piles.push_back({progress.frame, probe.measure(*world)});
  });
  if (!done) return tl::unexpected(done.error());
  report(*done, piles);
  return options.out.empty() || piles.empty() ? Result<void>{} : writePiles(options.out / "pile.csv", piles);
}

void addOptions(CLI::App& app, Options& options) {
  app.add_option("--scene", options.scene, "the scene's name, as `scatter list` shows it, or a file")
      ->capture_default_str();
  app.add_option("--out", options.out, "write frames.csv, summary.json and pile.csv into this folder");
  app.add_option("--frames", options.frames, "steps of 1/60 s; 0: as many as the scene's story takes")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--seed", options.seed, "of the scene's random numbers")->capture_default_str();
  app.add_option(
         "--pile-every", options.pileEvery,
         "measure the pile every so many frames; it cools the caches, so not in a run whose times count")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_flag("--coarsest", options.engine.coarsest, "everything at level 1");
  app.add_flag("--count-contacts", options.engine.countContacts,
               "also where counting costs time in the step (Jolt)");
  app.add_flag("--pair-algorithm", options.engine.pairAlgorithm,
               "a hybrid world, all at the finest level (Bullet)");
  app.add_flag("--lean", options.engine.lean, "the world lean (Bullet)");
  app.add_option("--threads", options.engine.threads, "of a step (Bullet, Jolt)")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_flag("--boxes", options.engine.boxes, "the bounding boxes of hulls instead of the hulls (ODE)");
  app.add_option("--convex-radius", options.engine.convexRadius, "of hulls, metres (Jolt)")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--sub-steps", options.engine.subSteps, "of one step (Box3D, Jolt)")
      ->check(CLI::PositiveNumber);
  app.add_option("--iterations", options.engine.iterations, "of the velocity solver (Bullet, Jolt, ODE)")
      ->check(CLI::PositiveNumber);
}

}  // namespace
}  // namespace scatter::bench

int main(int argc, char** argv) {
  scatter::bench::Options options;
  CLI::App app("One scene in one physics engine, recorded as `scatter run` records it.");
  scatter::bench::addOptions(app, options);
  CLI11_PARSE(app, argc, argv);
  if (const auto measured = scatter::bench::measure(options); !measured) {
    std::fprintf(stderr, "%s: %s\n", scatter::bench::engineInfo().program, measured.error().message.c_str());
    return 2;
  }
  return 0;
}
