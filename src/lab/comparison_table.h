#pragma once

#include <scatter/lab/comparison.h>

#include <string>
#include <vector>

namespace scatter::lab {

/// One figure of a comparison, as text.
struct ComparisonRow {
  std::string name;
  std::vector<std::string> values;  ///< One for each world.
  std::vector<std::string> ratios;  ///< One for each world but the first; "-" where there is none.
};

[[nodiscard]] std::vector<ComparisonRow> comparisonRows(const Comparison& comparison);

/// What the numbers are, in one or two sentences.
[[nodiscard]] std::string comparisonNote(const Comparison& comparison);

}  // namespace scatter::lab
