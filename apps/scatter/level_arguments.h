#pragma once

#include <scatter/levels/build_levels.h>
#include <scatter/result.h>

#include <string>
#include <vector>

namespace scatter::app {

/// "0.5%" of the diagonal, or a length such as "0.01m", "1cm" or "5mm".
[[nodiscard]] Result<GapLimit> parseGap(const std::string& text);

/// "automatic", "solid" or "surface".
[[nodiscard]] Result<MeshInterior> parseInterior(const std::string& text);

/// "off", "auto" or "on".
[[nodiscard]] Result<MeshSymmetry> parseSymmetry(const std::string& text);

/// Whole numbers between commas in any order, such as "64,8,1"; they come back in increasing order. Fails on
/// numbers below 1 and on the same number twice.
[[nodiscard]] Result<std::vector<int>> parsePartCounts(const std::string& text);

}  // namespace scatter::app
