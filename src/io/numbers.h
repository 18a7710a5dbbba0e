#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scatter::io {

/// Text and numbers, the same in every locale.
/// @{

/// The next word of `text`, which loses it; empty at the end. Words are separated by XML white space.
[[nodiscard]] std::string_view takeWord(std::string_view& text);

/// Nothing if the word is no number or out of a double's range; may be infinite or not a number if it says
/// so.
[[nodiscard]] std::optional<double> parseNumber(std::string_view word);
[[nodiscard]] std::optional<std::uint32_t> parseIndex(std::string_view word);

/// The shortest text that reads back as the same number.
[[nodiscard]] std::string formatNumber(float value);

/// With at most `digits` significant digits.
[[nodiscard]] std::string formatNumber(double value, int digits);

/// @}

}  // namespace scatter::io
