#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace scatter::io {

[[nodiscard]] std::string encodeBase64(std::string_view bytes);

/// Nothing if the text is not base64; padding may be missing.
[[nodiscard]] std::optional<std::string> decodeBase64(std::string_view text);

}  // namespace scatter::io
