#pragma once

#include <scatter/lab/event_csv.h>
#include <scatter/lab/frame_table.h>
#include <scatter/lab/hand_script.h>
#include <scatter/lab/summary.h>
#include <scatter/result.h>
#include <scatter/world/physics.h>
#include <scatter/world/scene.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace scatter {

using EngineFactory = std::function<Result<std::unique_ptr<Physics>>(const PhysicsDef&)>;

/// That a run is stored, so that it can be looked at again.
struct RecordOptions {
  std::filesystem::path file{};
  bool contacts = false;  ///< Contact points and levels of pairs, too, which take a multiple of the room.
};

/// What a recording was and what it took.
struct RecordingCost {
  std::filesystem::path file{};
  std::uint64_t frames = 0;
  std::uint64_t bytes = 0;
  std::uint64_t movingBodies = 0;  ///< Dynamic bodies that did not sleep, over all frames.
  double runSeconds = 0.0;         ///< Processor time of the run's thread,
  double wallSeconds = 0.0;        ///< and wall time in it, while it waits for the writer, too.
  double writerSeconds = 0.0;      ///< Processor time of the writer's thread.
  std::string failed{};            ///< Why it is not whole, in one line; empty if it is.
};

/// One scene in one world.
struct RunOptions {
  /// What SceneRegistry::find() takes, or any name if `makeScene` is given.
  std::string scene{};
  std::string summary{};  ///< One line about the scene; empty: the registered one.
  std::function<std::unique_ptr<Scene>()> makeScene{};  ///< Empty: the registered scene.
  EngineFactory engine{};
  PhysicsDef physics{};
  int frames = 0;                       ///< 0: as many as the registered scene says.
  std::optional<std::uint64_t> seed{};  ///< Absent: the scene's, or 1 if `makeScene` is given.
  double budgetMs = 1000.0 / 60.0;      ///< What frames_over_budget is counted against.

  /// Frames from one measurement of fidelity to the next; 0: never. Changes nothing else, and is not timed.
  int fidelityEvery = 0;

  /// Frames from one count of the memory that a step touches to the next; 0: never. Changes nothing else, but
  /// the times of frames that are counted mean nothing.
  int memoryEvery = 0;

  /// What is done by hand, and in which frames; with none of it, nothing.
  HandScript hands{};

  /// Whether the run's events are kept in memory, in Run::events.
  bool keepEvents = false;

  /// Where frames.csv, events.csv and summary.json go; made if it does not exist. They are there from the
  /// first frame on, in the place of an earlier run's, and have every whole frame, however the program ends.
  /// Nothing is written without it.
  std::optional<std::filesystem::path> out{};

  /// Stores the run; from the frame before the first step on, up to the last block of frames, however the
  /// program ends. A disk that becomes full does not end the run: Run::recording says so.
  std::optional<RecordOptions> record{};

  /// Asked after every frame but the last whether the run is to end there; may be empty.
  std::function<bool()> stop{};

  /// Called with the world after the last frame.
  std::function<void(const World&)> inspect{};

  /// What the scene leaves out of its file, as SceneInfo::warnings; filled in by resolveRun().
  std::vector<std::string> warnings{};

  /// The world's name in tables, figures and folders: letters, digits, '-', '_' and '.'. Empty: the
  /// world's kind.
  std::string label{};
};

/// Whether what a world does depends on the clock, so that no two runs are the same.
[[nodiscard]] bool isClockGoverned(const PhysicsDef& physics);

struct Run {
  RunOptions options;  ///< With defaults filled in.
  FrameTable table;
  Summary summary;
  std::vector<FrameEvent> events{};          ///< Empty unless the options ask for them.
  std::optional<RecordingCost> recording{};  ///< If the options asked for one.
};

struct RunProgress {
  int frame = 0;  ///< Frames done.
  int frames = 0;
  double seconds = 0.0;  ///< Wall time since the run's first frame.
};

/// Called after every frame, outside what is measured; may be empty.
using Progress = std::function<void(const RunProgress&)>;

/// Builds the scene in a new world and runs it, one fixed step a frame, with Scene::update before each.
/// Fails on an unknown scene, a scene or engine that cannot be made, a folder that cannot be written, a disk
/// that becomes full, a hand's action that cannot be done and a state that is no longer finite (the files
/// then keep the frames until there). A run that RunOptions::stop ended is no failure; its summary says so.
[[nodiscard]] Result<Run> runScene(const RunOptions& options, const Progress& progress = {});

/// How a run's budget was kept, in words, as lines for a terminal: in how many frames it was not, by how
/// much, and what could not have been given up in them. Empty if the world has no budget.
[[nodiscard]] std::string formatBudget(const Run& run);

/// `options` with the registered scene, its frames and summary, and the label filled in; fails on what
/// runScene() would refuse before it starts.
[[nodiscard]] Result<RunOptions> resolveRun(RunOptions options);

}  // namespace scatter
