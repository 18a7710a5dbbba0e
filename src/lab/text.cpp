#include "lab/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

namespace scatter::lab {

namespace {

// Of UTF-8: bytes that begin a character.
std::size_t columnsOf(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char byte) { return (byte & 0xC0) != 0x80; }));
}

// Where a line that was broken goes on.
std::size_t hangingIndent(const std::string& line) {
  const std::size_t begin = line.find_first_not_of(' ');
  const std::size_t gap = line.find("  ", begin);
  const std::size_t description = gap == std::string::npos ? gap : line.find_first_not_of(' ', gap);
  const std::size_t indent =
      description == std::string::npos ? begin : columnsOf(line.substr(0, description));
  return indent < kTerminalWidth / 2 ? indent : begin;
}

std::string brokenLine(const std::string& line) {
  const std::string indent(hangingIndent(line), ' ');
  std::string text = line.substr(0, line.find_first_not_of(' '));
  std::size_t width = text.size();
  for (std::size_t at = text.size(); at < line.size();) {
    const std::size_t next = std::min(line.find_first_not_of(' ', at), line.size());
    const std::size_t end = std::min(line.find(' ', next), line.size());
    const std::string word = line.substr(next, end - next);
    if (width + (next - at) + columnsOf(word) <= kTerminalWidth) {
      text += std::string(next - at, ' ');
      width += next - at;
    } else {
      text += '\n' + indent;
      width = indent.size();
    }
    text += word;
    width += columnsOf(word);
    at = end;
  }
  return text;
}

}  // namespace

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

std::string fitTerminal(const std::string& text) {
  std::string fitting;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    fitting += (columnsOf(line) > kTerminalWidth ? brokenLine(line) : line) + '\n';
  }
  return fitting;
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
