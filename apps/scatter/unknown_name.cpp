#include "unknown_name.h"

#include "text/nearest_name.h"

namespace scatter::app {

std::string unknownName(std::string_view kind, std::string_view name, const std::vector<std::string>& known) {
  std::string message = "unknown " + std::string(kind) + " \"" + std::string(name) + "\"; ";
  const std::string_view nearest = nearestName(name, known);
  message += nearest.empty() ? "known: " : "did you mean \"" + std::string(nearest) + "\"? Known: ";
  for (const std::string& one : known) {
    message += (&one == &known.front() ? "" : ", ") + one;
  }
  return message;
}

}  // namespace scatter::app
