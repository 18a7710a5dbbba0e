#pragma once

#include <scatter/result.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scatter {

enum class RecordedKind : std::uint8_t { kReal, kInteger, kHash };

/// A column of the frame data that a recording has.
struct RecordedChannel {
  std::string name;
  std::string unit;
  RecordedKind kind = RecordedKind::kReal;
};

/// What a recording is of.
struct RecordingInfo {
  std::string scene;
  std::string label;  ///< The world's.
  std::string engine;
  std::uint64_t seed = 0;
  std::uint64_t framesAsked = 0;  ///< 0 if that was open.
  double stepSeconds = 1.0 / 60.0;
  std::vector<RecordedChannel> channels;

  /// What else somebody may want to know, by name: the build, the machine, the command.
  std::map<std::string, std::string> notes;

  [[nodiscard]] std::optional<std::size_t> channel(std::string_view name) const;
};

}  // namespace scatter
