#pragma once

#include <scatter/lab/contact_check.h>
#include <scatter/lab/environment.h>
#include <scatter/lab/fidelity.h>
#include <scatter/lab/frame_table.h>
#include <scatter/result.h>
#include <scatter/world/level_event.h>
#include <scatter/world/physics.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace scatter {

/// Of one time channel over a run, milliseconds.
struct TimeStatistics {
  double peak = 0.0;
  double p999 = 0.0;  ///< 99.9 % of the frames took no longer.
  double p99 = 0.0;
  double median = 0.0;
  double total = 0.0;
  double lastHundred = 0.0;  ///< Mean of the last hundred frames, or of all if there are fewer.
  std::uint64_t framesOverBudget = 0;
};

/// The nearest-rank percentile: the smallest of the values that at least `share` (0 to 1) of them do not
/// exceed. Always one of the values, never interpolated; the median of 1, 2, 3, 4 is 2. Zero for none.
[[nodiscard]] double nearestRank(std::vector<double> values, double share);

/// Over repeats: of an even number the mean of the middle two, since there are few. Zero for none.
[[nodiscard]] double medianOf(std::vector<double> values);

/// Of the last hundred frames, or of all if there are fewer; zero for none. Single frames at the end differ
/// much more from run to run.
[[nodiscard]] double meanOfLast(const std::vector<double>& values);

[[nodiscard]] TimeStatistics timeStatistics(const std::vector<double>& milliseconds, double budgetMs);

struct CounterStatistics {
  std::string name;  ///< The column.
  double total = 0.0;
  double peak = 0.0;
};

/// How many LevelEvents of each kind a run had, by LevelEventKind.
inline constexpr std::size_t kLevelEventKindCount = 5;
using LevelEventCounts = std::array<std::uint64_t, kLevelEventKindCount>;

/// What a run was and what came out of it.
struct Summary {
  std::string scene;
  std::string label;  ///< The world's name in tables and figures, such as "standard".
  std::string engine;
  PhysicsDef physics;
  std::uint64_t seed = 0;
  std::uint64_t frames = 0;       ///< That there are.
  std::uint64_t framesAsked = 0;  ///< That there were to be; 0 if that was open.
  double budgetMs = 0.0;
  TimeStatistics physicsMs;     ///< Wall time.
  TimeStatistics physicsCpuMs;  ///< Processor time of the physics thread.
  std::vector<CounterStatistics> counters;
  LevelEventCounts levelEvents{};
  std::map<std::string, LevelEventCounts, std::less<>> levelEventsByPolicy;  ///< By who asked.
  FidelityStatistics fidelity;      ///< Empty unless it was measured.
  CollisionMemory collisionMemory;  ///< In the frame with the most child pairs.
  ContactCheck contactCheck;        ///< Empty unless the physics verified its contacts.
  std::uint64_t stateHash = 0;      ///< After the last frame.
  std::string stopped;              ///< Why the run ended before its last frame; empty if it did not.
  BuildInfo build;
  MachineInfo machine;

  /// The counter must exist.
  [[nodiscard]] const CounterStatistics& counter(std::string_view name) const;
};

/// Fills times, counters and state_hash from the recorder's columns, build and machine from the
/// surroundings; the rest is the caller's.
void summarise(const FrameTable& table, Summary& summary);

/// As JSON; the file appears whole or not at all.
[[nodiscard]] Result<void> writeSummary(const std::filesystem::path& file, const Summary& summary);

}  // namespace scatter
