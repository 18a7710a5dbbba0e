#pragma once

#include <scatter/lab/run.h>
#include <scatter/recording/recording_writer.h>

#include "lab/frame_sampler.h"
#include "lab/scene_run.h"

#include <memory>
#include <string>

namespace scatter::lab {

/// Stores a run while it runs. What cannot be written does not end the run: cost() says so.
class RunRecorder {
 public:
  /// Makes the file, with the frame before the first step in it.
  [[nodiscard]] static Result<std::unique_ptr<RunRecorder>> create(const RecordOptions& options,
                                                                   const SceneRun& run);

  /// The frame that was made last.
  void add(const SceneRun& run);

  /// Nothing may be added afterwards.
  void finish(const std::string& stopped);

  [[nodiscard]] const RecordingCost& cost() const { return cost_; }

 private:
  RunRecorder(const RecordOptions& options, std::unique_ptr<RecordingWriter> writer);
  void note(const Result<void>& written);

  RecordOptions options_;
  FrameSampler sampler_;
  std::unique_ptr<RecordingWriter> writer_;
  RecordingCost cost_;
};

/// What a recording says of its run.
[[nodiscard]] RecordingInfo recordingInfo(const SceneRun& run, bool contacts);

}  // namespace scatter::lab
