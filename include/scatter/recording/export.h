#pragma once

#include <scatter/recording/recording.h>
#include <scatter/result.h>

#include <cstdint>
#include <filesystem>

namespace scatter {

/// Which frames are written: from `first` to `last`, every `step`-th, all frames of the recording.
struct ExportRange {
  std::uint64_t first = 0;
  std::uint64_t last = 0;
  std::uint64_t step = 1;
};

/// What was written.
struct ExportCounts {
  std::uint64_t frames = 0;
  std::uint64_t bodies = 0;
  std::uint64_t bytes = 0;
};

/// Both write a file that is there whole or not at all, and fail if the recording is damaged in these frames
/// or the file cannot be written.
/// @{

/// An animation in glTF, text if the file's name ends with .gltf and binary else: a node for each body, with
/// its mesh or its finest shape, which moves and turns; a body is there from its first frame to its last one.
/// Fails on more than 2 GiB, which no program opens: leave frames out.
[[nodiscard]] Result<ExportCounts> writeGltfAnimation(const Recording& recording, const ExportRange& range,
                                                      const std::filesystem::path& file);

/// An MCAP file of JSON messages: the bodies as foxglove.SceneUpdate in /scene, where they are as
/// foxglove.FrameTransforms in /tf, the frame data in /data, what happened to levels as foxglove.Log in
/// /events and contacts, if they were recorded, as lines in /contacts. y is up.
[[nodiscard]] Result<ExportCounts> writeMcap(const Recording& recording, const ExportRange& range,
                                             const std::filesystem::path& file);
/// @}

}  // namespace scatter
