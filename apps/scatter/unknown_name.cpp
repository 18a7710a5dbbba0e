#include "unknown_name.h"

#include <algorithm>
#include <numeric>

namespace scatter::app {

namespace {

// Insertions, deletions and replacements that turn one into the other.
std::size_t editDistance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> above(to.size() + 1);
  std::iota(above.begin(), above.end(), std::size_t{0});
  for (std::size_t i = 1; i <= from.size(); ++i) {
    std::vector<std::size_t> row{i};
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t replaced = above[j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1);
      row.push_back(std::min({replaced, above[j] + 1, row[j - 1] + 1}));
    }
    above = std::move(row);
  }
  return above.back();
}

}  // namespace

std::string unknownName(std::string_view kind, std::string_view name, const std::vector<std::string>& known) {
  std::string message = "unknown " + std::string(kind) + " \"" + std::string(name) + "\"; ";
  const auto nearest = std::min_element(known.begin(), known.end(), [name](const auto& a, const auto& b) {
    return editDistance(name, a) < editDistance(name, b);
  });
  // More than half of it wrong is another word.
  if (nearest != known.end() && 2 * editDistance(name, *nearest) <= name.size()) {
    message += "did you mean \"" + *nearest + "\"? ";
  }
  message += "Known: ";
  for (const std::string& one : known) {
    message += (&one == &known.front() ? "" : ", ") + one;
  }
  return message;
}

}  // namespace scatter::app
