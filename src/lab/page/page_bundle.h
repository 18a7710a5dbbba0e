#pragma once

#include <string_view>

namespace scatter::lab {

/// What web/report is bundled to when the program is built; all empty in a build without it.
struct PageBundle {
  std::string_view script;
  std::string_view style;
  std::string_view licences;  ///< Of what is in the script, as text.

  [[nodiscard]] bool exists() const { return !script.empty(); }
};

[[nodiscard]] PageBundle pageBundle();

}  // namespace scatter::lab
