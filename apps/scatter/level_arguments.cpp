#include "level_arguments.h"

#include <scatter/io/mesh_file.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "number_checks.h"

namespace scatter::app {

Result<GapLimit> parseGap(const std::string& text) {
  const std::size_t end = std::min(text.find_first_not_of("0123456789.eE+-"), text.size());
  const std::string unit = text.substr(end);
  const std::optional<double> number = parseNumber<double>(text.substr(0, end));
  if (number && std::isfinite(*number) && *number > 0.0 && *number < 1e30) {
    GapLimit limit;
    if (unit == "%") {
      limit.ofDiagonal = static_cast<float>(*number / 100.0);
      return limit;
    }
    const bool isNumber = unit.find_first_of("0123456789") != std::string::npos;
    if (const Result<double> metres = parseUnit(unit); metres && !isNumber) {
      limit.metres = static_cast<float>(*number * *metres);
      return limit;
    }
  }
  return fail("--gap: \"" + text +
              "\" is neither a share of the diagonal, such as 0.5%, nor a length, such as 0.01m");
}

Result<MeshInterior> parseInterior(const std::string& text) {
  if (text == "automatic") return MeshInterior::kAutomatic;
  if (text == "solid") return MeshInterior::kSolid;
  if (text == "surface") return MeshInterior::kSurface;
  return fail("--interior: \"" + text + "\" is unknown; give automatic, solid or surface");
}

Result<MeshSymmetry> parseSymmetry(const std::string& text) {
  if (text == "off") return MeshSymmetry::kIgnore;
  if (text == "auto") return MeshSymmetry::kAutomatic;
  if (text == "on") return MeshSymmetry::kRequired;
  return fail("--symmetric: \"" + text + "\" is unknown; give on, auto or off");
}

Result<std::vector<int>> parsePartCounts(const std::string& text) {
  std::vector<int> counts;
  std::istringstream stream(text + ",");
  for (std::string word; std::getline(stream, word, ',');) {
    const std::optional<int> count = parseNumber<int>(word);
    if (!count || *count < 1)
      return fail("--parts: \"" + word + "\" is no number of parts; give such as 64,8,1");
    counts.push_back(*count);
  }
  std::sort(counts.begin(), counts.end());
  if (std::adjacent_find(counts.begin(), counts.end()) != counts.end()) {
    return fail(
        "--parts: two levels have the same number of parts; each needs fewer than the next finer one");
  }
  return counts;
}

}  // namespace scatter::app
