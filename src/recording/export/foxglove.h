#pragma once

#include <scatter/recording/recording.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace scatter::recording {

/// Messages of the Foxglove schemas (https://docs.foxglove.dev/docs/sdk/schemas), as JSON, and JSON schemas
/// of what of them is used.
/// @{
[[nodiscard]] std::string sceneSchema();
[[nodiscard]] std::string transformsSchema();
[[nodiscard]] std::string logSchema();
[[nodiscard]] std::string dataSchema(const RecordingInfo& info);

/// Makes the messages of a recording. Frames of reference: "map", with z up, "world" in it, with y up, and in
/// that one for each body, with its name and number.
class FoxgloveMessages {
 public:
  explicit FoxgloveMessages(const Recording& recording) : recording_(recording) {}

  /// All bodies of the frame, in the place of all that were shown before.
  [[nodiscard]] std::string scene(const RecordedFrame& frame, std::uint64_t nanoseconds);
  [[nodiscard]] std::string transforms(const RecordedFrame& frame, std::uint64_t nanoseconds) const;
  [[nodiscard]] std::string data(const RecordedFrame& frame) const;
  [[nodiscard]] std::string log(const LevelEvent& event, std::uint64_t nanoseconds) const;
  [[nodiscard]] std::string contacts(const RecordedFrame& frame, std::uint64_t nanoseconds) const;

 private:
  [[nodiscard]] const std::string& trianglesOf(const BodyDef& def);
  [[nodiscard]] std::string frameOf(BodyId body) const;

  const Recording& recording_;
  std::map<std::pair<const void*, std::string>, std::string> triangles_;  ///< Of a surface.
};
/// @}

}  // namespace scatter::recording
