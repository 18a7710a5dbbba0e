#include "lab/text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

namespace scatter::lab {

std::string shortestNumber(double value) {
  std::array<char, 64> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

std::string fixedNumber(double value, int decimals) {
  // The largest double has 309 digits before the point.
  std::array<char, 400> buffer{};
  const auto result =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
  return {buffer.data(), result.ptr};
}

std::string readableNumber(double value) {
  const double size = std::abs(value);
  if (size == 0.0 || size >= 100.0) {
    return fixedNumber(value, 0);
  }
  if (size >= 10.0) {
    return fixedNumber(value, 1);
  }
  constexpr double kLeastFixed = 0.0005;
  if (size < kLeastFixed) {
    std::array<char, 64> buffer{};
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 2);
    return {buffer.data(), end.ptr};
  }
  return fixedNumber(value, size >= 1.0 ? 2 : 3);
}

std::string wrapped(const std::string& text) {
  std::string lines;
  std::size_t width = 0;
  std::istringstream words(text);
  for (std::string word; words >> word; width += word.size()) {
    if (width > 0 && width + 1 + word.size() > kTerminalWidth) {
      lines += '\n';
      width = 0;
    }
    if (width > 0) {
      lines += ' ';
      ++width;
    }
    lines += word;
  }
  return lines + '\n';
}

std::string hexNumber(std::uint64_t value) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text(16, '0');
  for (std::size_t i = text.size(); i-- > 0; value >>= 4U) {
    text[i] = kDigits[value & 0xFU];
  }
  return text;
}

std::string replaceAll(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

}  // namespace scatter::lab
