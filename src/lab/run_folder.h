#pragma once

#include <scatter/lab/event_csv.h>
#include <scatter/lab/frame_csv.h>
#include <scatter/lab/summary.h>
#include <scatter/result.h>

#include "lab/scene_run.h"

#include <filesystem>

namespace scatter::lab {

/// The folder of a run, filled while it runs: frames.csv and events.csv hold every whole frame, and
/// summary.json says that the run is unfinished until it is finished. An earlier run's files are replaced
/// with the first frame.
class RunFolder {
 public:
  /// Makes the folder if it does not exist.
  [[nodiscard]] static Result<RunFolder> open(const std::filesystem::path& folder, const FrameData& data);

  /// Adds the frame that was made last, in all files or in none.
  [[nodiscard]] Result<void> addFrame(const SceneRun& run);

  /// Nothing may be added afterwards.
  [[nodiscard]] Result<void> finish(const Summary& summary);

 private:
  RunFolder(std::filesystem::path folder, FrameCsv frames, EventCsv events);

  std::filesystem::path folder_;
  FrameCsv frames_;
  EventCsv events_;
  bool begun_ = false;
};

}  // namespace scatter::lab
