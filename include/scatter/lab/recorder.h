#pragma once

#include <scatter/lab/cpu_time.h>
#include <scatter/lab/frame_data.h>
#include <scatter/result.h>
#include <scatter/world/world.h>

#include <array>

namespace scatter {

/// Every measured frame is one physics step of this many seconds.
inline constexpr double kStepSeconds = 1.0 / 60.0;

/// Steps a world and records what the step cost and did (report, section 5.1.3), in these channels, in this
/// order: frame, time_s, physics_ms, physics_cpu_ms, the stages of step_report.h, cpu_load, its counters,
/// awake_bodies (dynamic ones, after the step), budget_ms, budget_units, revised_units, settled_units,
/// kinetic_energy, max_penetration, state_hash.
class FrameRecorder {
 public:
  /// Adds the channels to `data`, which must have none of them. `budgetMs` is the time that a frame's
  /// physics should fit into. World and data must outlive the recorder.
  FrameRecorder(World& world, FrameData& data, double budgetMs = 1000.0 / 60.0);

  /// Begins a frame of the data, runs one step of the world and fills the frame. `physics_ms` (wall) and
  /// `physics_cpu_ms` (this thread) hold World::step alone. Fails, with the frame recorded, if a body's
  /// state is no longer finite; the message names the body and the frame.
  [[nodiscard]] Result<void> step();

 private:
  enum Measured : std::size_t {
    kWall,
    kCpu,
    kLoad,
    kBudget,
    kUnits,
    kRevised,
    kSettled,
    kEnergy,
    kPenetration,
    kMeasuredCount
  };

  void addChannels();
  void recordCounters();

  World& world_;
  FrameData& data_;
  double budgetMs_;
  CpuLoad load_;
  ChannelId frame_{};
  ChannelId time_{};
  ChannelId hash_{};
  ChannelId awake_{};
  std::array<ChannelId, kMeasuredCount> measured_{};
  std::array<ChannelId, kStageCount> stages_{};
  std::vector<ChannelId> counters_;
};

}  // namespace scatter
