#include "unknown_name.h"

#include <algorithm>

#include "text/edit_distance.h"

namespace scatter::app {

std::string unknownName(std::string_view kind, std::string_view name, const std::vector<std::string>& known) {
  std::string message = "unknown " + std::string(kind) + " \"" + std::string(name) + "\"; ";
  const auto nearest = std::min_element(known.begin(), known.end(), [name](const auto& a, const auto& b) {
    return editDistance(name, a) < editDistance(name, b);
  });
  // More than half of it wrong is another word.
  const bool isNear = nearest != known.end() && 2 * editDistance(name, *nearest) <= name.size();
  message += isNear ? "did you mean \"" + *nearest + "\"? Known: " : "known: ";
  for (const std::string& one : known) {
    message += (&one == &known.front() ? "" : ", ") + one;
  }
  return message;
}

}  // namespace scatter::app
