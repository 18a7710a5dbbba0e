#pragma once

#include <scatter/result.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace scatter::io {

struct TomlEntry;

/// A date or a time.
struct TomlDate {};

/// A value of a TOML file and the line that it begins in.
struct TomlNode {
  using Array = std::vector<TomlNode>;
  using Table = std::vector<TomlEntry>;  ///< In the file's order.

  std::variant<TomlDate, bool, std::int64_t, double, std::string, Array, Table> value;
  int line = 0;

  template <class Kind>
  [[nodiscard]] const Kind* as() const {
    return std::get_if<Kind>(&value);
  }

  /// "a number", "a list" and the like.
  [[nodiscard]] std::string_view kind() const;
};

struct TomlEntry {
  std::string key{};
  int line = 0;
  TomlNode node{};
};

/// The outermost table. Fails on text that is no TOML 1.0, is too large or too deeply nested, with a
/// message that begins with "NAME:LINE: ".
[[nodiscard]] Result<TomlNode::Table> parseToml(std::string_view text, std::string_view name);

}  // namespace scatter::io
