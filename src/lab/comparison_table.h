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

  /// "0.16-0.18", the ratios' extremes over the repeats: one for each ratio, or none where they do not vary.
  std::vector<std::string> extremes{};
};

[[nodiscard]] std::vector<ComparisonRow> comparisonRows(const Comparison& comparison);

/// What the numbers are, in a few sentences.
[[nodiscard]] std::string comparisonNote(const Comparison& comparison);

/// How the worlds with budgets kept them, one sentence or two each.
[[nodiscard]] std::vector<std::string> budgetNotes(const Comparison& comparison);

/// How many of a world's frames took more processor time than that, the median over its repeats.
[[nodiscard]] double framesOver(const ComparedWorld& world, double budgetMs);

}  // namespace scatter::lab
