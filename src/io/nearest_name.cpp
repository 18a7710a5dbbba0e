#include "io/nearest_name.h"

#include <algorithm>
#include <numeric>

#include "io/xml_source.h"

namespace scatter::io {
namespace {

/// Insertions, deletions and replacements that turn one into the other.
std::size_t editDistance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t replaced = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string didYouMean(std::string_view name, const std::vector<std::string_view>& known) {
  // Names are short; a longer one is no misspelling, and would take long to compare.
  const std::string_view start = name.substr(0, 100);
  const auto nearest =
      std::min_element(known.begin(), known.end(), [start](std::string_view a, std::string_view b) {
        return editDistance(start, a) < editDistance(start, b);
      });
  return nearest == known.end() ? "" : "; did you mean " + inQuotes(*nearest) + "?";
}

}  // namespace scatter::io
