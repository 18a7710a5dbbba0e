#include "lab/scene_run.h"

#include <scatter/lab/touched_memory.h>

#include <cassert>
#include <utility>

namespace scatter::lab {

namespace {

// Components read this many frames back while a run goes on.
constexpr std::size_t kReadBackFrames = 600;

Result<std::unique_ptr<World>> buildWorld(const RunOptions& options, Scene& scene) {
  PhysicsDef definition = options.physics;
  scene.configure(definition);
  auto physics = options.engine(definition);
  if (!physics) {
    return tl::unexpected(physics.error());
  }
  auto world = std::make_unique<World>(std::move(*physics));
  if (auto built = scene.build(*world, {.seed = options.seed.value_or(1)}); !built) {
    return fail("scene '" + options.scene + "': " + built.error().message);
  }
  return world;
}

}  // namespace

Result<std::unique_ptr<SceneRun>> SceneRun::create(const RunOptions& options) {
  if (options.memoryEvery > 0) {
    if (auto counts = TouchedMemory::begin(); !counts) {
      return tl::unexpected(counts.error());
    }
  }
  auto scene = options.makeScene();
  auto world = buildWorld(options, *scene);
  if (!world) {
    return tl::unexpected(world.error());
  }
  return std::unique_ptr<SceneRun>(new SceneRun(options, std::move(scene), std::move(*world)));
}

SceneRun::SceneRun(const RunOptions& options, std::unique_ptr<Scene> scene, std::unique_ptr<World> world)
    : scene_(std::move(scene)),
      world_(std::move(world)),
      data_(kReadBackFrames),
      recorder_(*world_, data_, options.budgetMs) {
  if (options.fidelityEvery > 0) {
    fidelity_.emplace(*world_, data_, options.fidelityEvery);
  }
  if (options.memoryEvery > 0) {
    memory_.emplace(*world_, data_, options.memoryEvery);
  }
  run_.options = options;
  run_.table = FrameTable(data_.channels());
}

void SceneRun::step(const std::function<void()>& beforeStep) {
  assert(stopped().empty());
  scene_->update(*world_);
  if (beforeStep) {
    beforeStep();
  }
  if (fidelity_) {
    fidelity_->beforeStep();
  }
  if (memory_) {
    memory_->beforeStep();
  }
  const auto stepped = recorder_.step();
  if (memory_) {
    memory_->afterStep();
  }
  if (!stepped) {
    run_.summary.stopped =
        "scene '" + options().scene + "', " + options().label + " world, " + stepped.error().message;
  }
  if (fidelity_) {
    // Where a body is no number says nothing about shapes.
    stepped ? fidelity_->afterStep() : fidelity_->skipStep();
  }
  observe();
  run_.table.append(data_);
}

// What no column holds.
void SceneRun::observe() {
  takeEvents();
  const Physics& physics = world_->physics();
  const int childPairs = physics.counters().pairWork.childPairs;
  if (childPairs > mostChildPairs_) {
    mostChildPairs_ = childPairs;
    run_.summary.collisionMemory = physics.diagnostics().collisionMemory();
  }
  if (options().physics.collision.verifyEvery > 0) {
    run_.summary.contactCheck.follow(world_->frame(), physics.diagnostics().contactReport());
  }
}

void SceneRun::takeEvents() {
  auto& byPolicy = run_.summary.levelEventsByPolicy;
  for (const LevelEvent& event : world_->physics().switching().levelEvents()) {
    const auto kind = static_cast<std::size_t>(event.kind);
    ++run_.summary.levelEvents[kind];
    const auto known = byPolicy.find(event.policy);
    ++(known != byPolicy.end() ? known->second : byPolicy[std::string(event.policy)])[kind];
    if (options().keepEvents) {
      run_.events.push_back({.frame = world_->frame(), .event = event});
    }
  }
}

Summary SceneRun::summary() const {
  Summary summary = run_.summary;
  summary.scene = options().scene;
  summary.label = options().label;
  summary.engine = world_->physics().engine();
  summary.physics = options().physics;
  summary.seed = options().seed.value_or(1);
  summary.budgetMs = options().budgetMs;
  summary.framesAsked = static_cast<std::uint64_t>(options().frames);
  if (fidelity_) {
    summary.fidelity = fidelity_->statistics();
  }
  summarise(run_.table, summary);
  return summary;
}

Run SceneRun::takeRun() {
  run_.summary = summary();
  return std::move(run_);
}

}  // namespace scatter::lab
