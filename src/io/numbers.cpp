#include "io/numbers.h"

#include <array>
#include <charconv>

namespace scatter::io {
namespace {

constexpr std::string_view kSpace = " \t\r\n";

template <class Number>
std::optional<Number> parseWhole(std::string_view word) {
  // XML Schema allows a leading plus sign, from_chars does not.
  if (word.size() > 1 && word.front() == '+' && word[1] != '-') {
    word.remove_prefix(1);
  }
  Number value{};
  const char* end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, value);
  return error == std::errc{} && rest == end && !word.empty() ? std::optional(value) : std::nullopt;
}

}  // namespace

std::string_view takeWord(std::string_view& text) {
  const std::size_t begin = text.find_first_not_of(kSpace);
  if (begin == std::string_view::npos) {
    text = {};
    return {};
  }
  const std::size_t end = std::min(text.find_first_of(kSpace, begin), text.size());
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

std::optional<double> parseNumber(std::string_view word) {
  return parseWhole<double>(word);
}

std::optional<std::uint32_t> parseIndex(std::string_view word) {
  return parseWhole<std::uint32_t>(word);
}

std::string formatNumber(float value) {
  std::array<char, 64> buffer{};
  // Adding zero turns a negative zero into a plain one.
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value + 0.0F);
  return error == std::errc{} ? std::string(buffer.data(), end) : std::string();
}

std::string formatNumber(double value, int digits) {
  std::array<char, 64> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value + 0.0,
                                          std::chars_format::general, digits);
  return error == std::errc{} ? std::string(buffer.data(), end) : std::string();
}

}  // namespace scatter::io
