#pragma once

#include <scatter/lab/frame_data.h>
#include <scatter/lab/recorder.h>
#include <scatter/lab/run.h>

#include "lab/fidelity_recorder.h"
#include "lab/memory_recorder.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace scatter::lab {

/// One scene in one world, frame by frame, and all that is recorded of it.
class SceneRun {
 public:
  /// `options` come from resolveRun(). Fails if the engine or the scene cannot be made.
  [[nodiscard]] static Result<std::unique_ptr<SceneRun>> create(const RunOptions& options);

  SceneRun(const SceneRun&) = delete;
  SceneRun& operator=(const SceneRun&) = delete;
  ~SceneRun() = default;

  /// Updates the scene, calls `beforeStep` if there is one, makes one step and records it. Not after the run
  /// has stopped.
  void step(const std::function<void()>& beforeStep = {});

  /// To be called before an object is taken out of the world by somebody else than the scene.
  void forget(const WorldObject& object) { scene_->forget(object); }

  /// There are no more frames, and this is why.
  void stop(std::string why) { run_.summary.stopped = std::move(why); }

  /// Why there are no more frames, in one line, a state that is no longer finite being one reason. Empty
  /// while there can be.
  [[nodiscard]] const std::string& stopped() const { return run_.summary.stopped; }

  [[nodiscard]] World& world() { return *world_; }
  [[nodiscard]] const World& world() const { return *world_; }
  [[nodiscard]] const FrameData& data() const { return data_; }
  [[nodiscard]] const RunOptions& options() const { return run_.options; }
  [[nodiscard]] const FrameTable& table() const { return run_.table; }
  [[nodiscard]] const std::vector<FrameEvent>& events() const { return run_.events; }
  [[nodiscard]] const LevelEventCounts& levelEvents() const { return run_.summary.levelEvents; }

  /// What the physics has become since it was made, for the summary.
  void setPhysics(const PhysicsDef& physics) { run_.options.physics = physics; }

  /// Of the frames until now.
  [[nodiscard]] Summary summary() const;

  /// Everything recorded, with its summary; this is then without.
  [[nodiscard]] Run takeRun();

 private:
  SceneRun(const RunOptions& options, std::unique_ptr<Scene> scene, std::unique_ptr<World> world);

  void observe();
  void takeEvents();

  std::unique_ptr<Scene> scene_;
  std::unique_ptr<World> world_;
  FrameData data_;
  FrameRecorder recorder_;
  std::optional<FidelityRecorder> fidelity_;
  std::optional<MemoryRecorder> memory_;
  Run run_;
  int mostChildPairs_ = 0;
};

}  // namespace scatter::lab
