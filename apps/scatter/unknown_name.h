#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scatter::app {

/// `unknown KIND "NAME"; did you mean "…"? Known: …`, with the question only if a known name is near.
[[nodiscard]] std::string unknownName(std::string_view kind, std::string_view name,
                                      const std::vector<std::string>& known);

}  // namespace scatter::app
