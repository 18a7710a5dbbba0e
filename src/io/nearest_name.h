#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scatter::io {

/// `; did you mean "NAME"?` with the nearest of the known names, or nothing if none is near.
[[nodiscard]] std::string didYouMean(std::string_view name, const std::vector<std::string_view>& known);

}  // namespace scatter::io
