#pragma once

#include <string_view>

namespace scatter::io {

/// Whether a text is UTF-8 without overlong forms and surrogates.
[[nodiscard]] bool isUtf8(std::string_view text);

}  // namespace scatter::io
