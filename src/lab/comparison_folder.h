#pragma once

#include <scatter/lab/comparison.h>

#include "lab/summary_json.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <utility>

namespace scatter::lab {

inline constexpr const char* kRecordingName = "run.rec";

/// Where a comparison is kept while it goes on: a folder for each run, and comparison.json, which says what
/// is compared and whether all of it is there.
class ComparisonFolder {
 public:
  /// `options` with defaults filled in, and with `out`. Fails where the folder has finished runs of a
  /// comparison that was cut short, unless they are to be used or given up, and if they are to be used and
  /// belong to another comparison.
  [[nodiscard]] static Result<ComparisonFolder> open(const CompareOptions& options);

  /// Of a run: LABEL, or LABEL/repeat-1 and so on if there are several.
  [[nodiscard]] std::filesystem::path runFolder(std::size_t world, int repeat) const;

  /// Where a world's first run is stored for the report.
  [[nodiscard]] std::filesystem::path recordingFile(std::size_t world) const {
    return runFolder(world, 0) / kRecordingName;
  }

  /// A run that is there already; none if it is still to be made. Fails on one that does not belong here.
  [[nodiscard]] Result<std::optional<Run>> finishedRun(std::size_t world, int repeat) const;

  /// To be called when a new run has a frame in its folder: from now on all is this comparison's.
  [[nodiscard]] Result<void> begin(const std::filesystem::path& run);

 private:
  explicit ComparisonFolder(CompareOptions options) : options_(std::move(options)) {}
  [[nodiscard]] bool isFinished(std::size_t world, int repeat) const;
  [[nodiscard]] int finishedRuns() const;
  [[nodiscard]] Result<void> checkEarlier() const;
  void removeEarlierRuns(const std::filesystem::path& except) const;

  CompareOptions options_;
  bool begun_ = false;
  bool resumes_ = false;
};

/// The key in comparison.json under which comparisonIdentity() stands.
inline constexpr const char* kComparedKey = "compared";

/// What a comparison compares, and on what: two with the same can be one.
[[nodiscard]] Json comparisonIdentity(const CompareOptions& options);

}  // namespace scatter::lab
