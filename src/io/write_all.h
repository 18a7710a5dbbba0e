#pragma once

#include <string_view>

namespace scatter {

/// Writes all of the text to an open file, however often the system takes less of it or is interrupted.
/// 0 or an errno.
[[nodiscard]] int writeAll(int descriptor, std::string_view text);

}  // namespace scatter
