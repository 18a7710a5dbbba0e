#pragma once

#include <string>

namespace scatter::lab {

/// As it stands in a page's text or in a quoted attribute.
[[nodiscard]] std::string escaped(std::string text);

/// An element with this text; ends with a new line.
[[nodiscard]] std::string element(const std::string& tag, const std::string& text);

}  // namespace scatter::lab
