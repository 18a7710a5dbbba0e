#pragma once

#include <scatter/lab/frame_data.h>
#include <scatter/lab/hands.h>
#include <scatter/lab/run.h>
#include <scatter/lab/run_history.h>
#include <scatter/world/observation.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace scatter {

namespace lab {
class SceneRun;
class ScriptedHands;
}  // namespace lab

struct ExperimentDef {
  /// The scene and its world. `frames`, `out`, `inspect` and `keepEvents` mean nothing here: it runs until
  /// nobody steps it, and keeps its events.
  RunOptions run{};
  HistoryDef history{};
  HandsDef hands{};  ///< `onRemove` is called when the scene has forgotten the object.
};

/// How often levels changed since the start.
struct SwitchCounts {
  std::uint64_t coarser = 0;
  std::uint64_t finer = 0;
};

/// One scene in one world that is played: stepped when somebody wants a step, looked at, poked, started
/// again. With no hands on it, every frame has the state hash that runScene() has. It needs no window and
/// knows no clock. Beside its history it keeps about half a kilobyte a frame, and 64 bytes a level event, for
/// write(): 100 MB in an hour.
class Experiment {
 public:
  /// Fails as runScene() does before its first frame.
  [[nodiscard]] static Result<std::unique_ptr<Experiment>> create(const ExperimentDef& def);

  Experiment(const Experiment&) = delete;
  Experiment& operator=(const Experiment&) = delete;
  ~Experiment();

  /// One frame, exactly as runScene() makes it: what the script says for it, Scene::update, the hands, one
  /// step, the record. Fails, with the frame recorded, if a body's state is no longer finite, and from then
  /// on, doing nothing, until restart().
  [[nodiscard]] Result<void> step();

  /// Why it cannot be stepped, in one line; empty if it can.
  [[nodiscard]] const std::string& stopped() const;

  /// Builds the scene anew, with the physics as it was changed to, and does what the script says again.
  /// World, hands and all that is recorded are new: what points into them is invalid. If it fails, everything
  /// stays as it was.
  [[nodiscard]] Result<void> restart(HandScript script = {});

  /// The same in another physics.
  [[nodiscard]] Result<void> restart(const PhysicsDef& physics, HandScript script = {});

  /// The same with another scene, in the same physics: what SceneRegistry::find() takes. With the scene's own
  /// seed and length.
  [[nodiscard]] Result<void> open(const std::string& scene);

  /// What the script could not do, first of all; empty if there is nothing.
  [[nodiscard]] const std::string& scriptError() const;

  /// Change the running world, as the methods of Physics with these names do, and every restart after.
  /// @{
  bool setBudget(const BudgetDef& budget);
  [[nodiscard]] Result<void> setPolicies(Policy policy, const std::vector<std::string>& policies);
  [[nodiscard]] Result<void> setSwitching(Switching switching);
  /// @}

  [[nodiscard]] World& world();
  [[nodiscard]] const World& world() const;
  [[nodiscard]] Hands& hands();
  [[nodiscard]] const Hands& hands() const;

  /// From the frame before the first step on, as far as its memory reaches.
  [[nodiscard]] RunHistory& history() { return history_; }
  [[nodiscard]] const RunHistory& history() const { return history_; }

  /// Writes a recording of all frames that the history has, which goes on with those that come until
  /// RunHistory::stopRecording() or restart(). Fails as RunHistory::startRecording() does.
  [[nodiscard]] Result<void> startRecording(const std::filesystem::path& file);

  /// With defaults filled in; `physics` as it was changed to.
  [[nodiscard]] const RunOptions& options() const;
  [[nodiscard]] int restarts() const { return restarts_; }

  /// The last 600 frames, as they are recorded.
  [[nodiscard]] const FrameData& data() const;
  /// All frames since the start.
  [[nodiscard]] const FrameTable& table() const;
  [[nodiscard]] const std::vector<FrameEvent>& events() const;
  [[nodiscard]] const LevelEventCounts& levelEvents() const;
  [[nodiscard]] const SwitchCounts& switches() const { return switches_; }

  /// Of the frames until now.
  [[nodiscard]] Summary summary() const;

  /// Writes the run until now into a folder, whole or not at all: frames.csv, events.csv, summary.json,
  /// hands.txt if something was done by hand, and figures/ if asked for, which takes seconds and needs
  /// gnuplot. Files of other names are left alone. Fails before the first frame.
  [[nodiscard]] Result<void> write(const std::filesystem::path& folder, bool figures) const;

 private:
  Experiment(ExperimentDef def, std::unique_ptr<lab::SceneRun> run);

  [[nodiscard]] Result<void> begin(RunOptions options, HandScript script);
  void adopt(std::unique_ptr<lab::SceneRun> run, HandScript script);
  void keepHistory();

  ExperimentDef def_;
  std::unique_ptr<lab::SceneRun> run_;
  std::unique_ptr<lab::ScriptedHands> hands_;
  RunHistory history_;
  SwitchCounts switches_;
  int restarts_ = 0;
  Observation observation_;
  std::vector<PairLevel> pairs_;
};

}  // namespace scatter
