#include "io/nearest_name.h"

#include "io/collada/xml_source.h"
#include "text/nearest_name.h"

namespace scatter::io {

std::string didYouMean(std::string_view name, const std::vector<std::string_view>& known) {
  const std::string_view nearest = nearestName(name, known);
  return nearest.empty() ? "" : "; did you mean " + inQuotes(nearest) + "?";
}

}  // namespace scatter::io
