#pragma once

#include <scatter/recording/recording_writer.h>

#include <string>
#include <vector>

#include "recording/block.h"
#include "recording/body_coder.h"
#include "recording/frame_coder.h"

namespace scatter::recording {

struct EncodedBlock {
  BlockKind kind = BlockKind::kFrames;
  std::uint64_t first = 0;
  std::uint32_t frames = 0;
  std::string bytes;  ///< With its header.
};

/// Makes blocks of frames. One thread at a time.
class RecordingEncoder {
 public:
  explicit RecordingEncoder(const RecordingDef& def) : def_(def) {}

  void add(const FrameSample& frame);

  /// Whether it is time to take() what there is, by all but the clock.
  [[nodiscard]] bool isFull() const;
  [[nodiscard]] bool isEmpty() const { return frames_.frames() == 0; }

  /// What has been added since the last call: the new bodies, if there are any, and the frames.
  [[nodiscard]] std::vector<EncodedBlock> take();

 private:
  RecordingDef def_;
  BodyEncoder bodies_;
  FrameEncoder frames_;
};

}  // namespace scatter::recording
