#include "io/nearest_name.h"

#include <algorithm>

#include "io/collada/xml_source.h"
#include "text/edit_distance.h"

namespace scatter::io {

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
