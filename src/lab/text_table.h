#pragma once

#include <scatter/lab/comparison.h>

#include <string>
#include <vector>

namespace scatter::lab {

/// Lines of cells as columns of even width, the first one flush left, the others right, with a rule under
/// the first line. Columns that do not fit into kTerminalWidth follow below, beside the first one again.
/// Plain ASCII; ends with a new line.
[[nodiscard]] std::string textTable(const std::vector<std::vector<std::string>>& lines);

/// Lines of cells as CSV. No cell holds a comma, a quote or a line break.
[[nodiscard]] std::string csvText(const std::vector<std::vector<std::string>>& lines);

/// A ratio with two significant digits, also where it is small: `scale` is the ratio that it stands beside.
[[nodiscard]] std::string ratioNumber(double ratio, double scale);

/// "0.16-0.18"; empty where there is none.
[[nodiscard]] std::string extremesText(const Spread& spread);

/// "0.17 (0.16-0.18)", or without the extremes; "-" where there is none.
[[nodiscard]] std::string ratioText(const Spread& spread, bool withExtremes);

}  // namespace scatter::lab
