#pragma once

#include <cstdint>
#include <string>

namespace scatter::lab {

/// The shortest decimal form that reads back to the same bits; "nan", "inf" and "-inf" as they are.
[[nodiscard]] std::string shortestNumber(double value);

/// With this many decimals, whatever the locale.
[[nodiscard]] std::string fixedNumber(double value, int decimals);

/// With three significant digits at least, and no more decimals than a reader can use.
[[nodiscard]] std::string readableNumber(double value);

/// 16 hexadecimal digits.
[[nodiscard]] std::string hexNumber(std::uint64_t value);

[[nodiscard]] std::string replaceAll(std::string text, const std::string& from, const std::string& to);

/// What a terminal shows in a line.
inline constexpr std::size_t kTerminalWidth = 80;

/// Text whose lines have at most kTerminalWidth characters, if it has blanks to break them at. What is too
/// long goes on below: in a line of a list, where the description begins (behind two blanks or more); in any
/// other line, where the line begins. Ends with a new line.
[[nodiscard]] std::string fitTerminal(const std::string& text);

}  // namespace scatter::lab
