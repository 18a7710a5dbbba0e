#pragma once

#include <scatter/recording/recording_info.h>

#include <string>
#include <string_view>

namespace scatter::recording {

/// As JSON, compressed.
[[nodiscard]] std::string encodeInfo(const RecordingInfo& info);

/// Nothing if it is damaged.
[[nodiscard]] std::optional<RecordingInfo> decodeInfo(std::string_view bytes);

}  // namespace scatter::recording
