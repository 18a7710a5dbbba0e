#pragma once

#include <spdlog/fmt/fmt.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace scatter::app {

template <class Number>
[[nodiscard]] std::optional<Number> parseNumber(const std::string& text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

/// A check for CLI::Option that refuses all but whole numbers from `least` on.
template <class Integer>
[[nodiscard]] auto wholeNumber(Integer least) {
  return [least](const std::string& text) -> std::string {
    const auto number = parseNumber<Integer>(text);
    if (number && *number >= least) {
      return {};
    }
    return fmt::format("needs a whole number from {} to {}, not \"{}\"", least,
                       std::numeric_limits<Integer>::max(), text);
  };
}

/// A check for CLI::Option that refuses all but finite numbers above `bound`.
[[nodiscard]] inline auto numberAbove(double bound) {
  return [bound](const std::string& text) -> std::string {
    const auto number = parseNumber<double>(text);
    if (number && std::isfinite(*number) && *number > bound && *number < 1e30) {
      return {};
    }
    return fmt::format("needs a number above {}, not \"{}\"", bound, text);
  };
}

/// A check for CLI::Option that refuses all but finite numbers that are no less than `least`.
[[nodiscard]] inline auto numberFrom(double least) {
  return [least](const std::string& text) -> std::string {
    const auto number = parseNumber<double>(text);
    if (number && std::isfinite(*number) && *number >= least && *number < 1e30) {
      return {};
    }
    return fmt::format("needs a number from {}, not \"{}\"", least, text);
  };
}

}  // namespace scatter::app
