#pragma once

#include <scatter/recording/recorded_frame.h>
#include <scatter/recording/recording_info.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace scatter::test {

/// Frames of bodies that fly, turn, bounce, sleep, come and go, with events, pairs, contacts and two
/// channels; the same for the same seed.
[[nodiscard]] std::vector<FrameSample> sampleFrames(std::size_t frames, unsigned seed = 1);

[[nodiscard]] RecordingInfo sampleInfo();

/// A whole recording of the frames, in blocks of so many.
void writeRecording(const std::filesystem::path& file, const std::vector<FrameSample>& frames,
                    std::uint32_t blockFrames);

/// Copies `from` into `to`, which is of the same recording's next frame.
void copyFrame(const FrameSample& from, FrameSample& to);

}  // namespace scatter::test
