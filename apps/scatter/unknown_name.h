#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scatter::app {

/// "unknown KIND "NAME"; did you mean "…"? Known are …"; `known` is not empty.
[[nodiscard]] std::string unknownName(std::string_view kind, std::string_view name,
                                      const std::vector<std::string>& known);

}  // namespace scatter::app
