#pragma once

#include <scatter/recording/recording.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace scatter::app {

/// A recording. What of it is not whole is noted.
[[nodiscard]] Result<std::unique_ptr<Recording>> openRecording(const std::string& file);

/// Frames in the order in which they are wanted: backwards if `from` is more than `to`.
struct FrameRange {
  std::uint64_t from = 0;
  std::uint64_t to = 0;
  std::uint64_t step = 1;
};

/// "N", "FROM:TO" or "FROM:TO:STEP", where FROM and TO may be left out: the first and the last frame. Fails
/// on anything else, and on frames that the recording has not.
[[nodiscard]] Result<FrameRange> parseFrames(const std::string& text, const Recording& recording);

/// Calls `use` with each frame of the range, until it fails or a frame is damaged.
[[nodiscard]] Result<void> forEachFrame(const Recording& recording, const FrameRange& range,
                                        const std::function<Result<void>(const RecordedFrame& frame)>& use);

}  // namespace scatter::app
