#pragma once

#include <array>
#include <string_view>

#include "viewer/commands.h"
#include "viewer/debug_views.h"

namespace scatter::viewer {

/// Views that are shown together, for a question that is often asked.
struct ViewPreset {
  std::string_view name;   ///< What commands and scripts call it, such as "show-levels".
  std::string_view label;  ///< On its button.
  std::string_view help;   ///< A line.
  Key key;
  DebugViewSet views;  ///< These and no others.
};

inline constexpr std::size_t kViewPresetCount = 4;
[[nodiscard]] const std::array<ViewPreset, kViewPresetCount>& viewPresets();

/// A command for each. The views must outlive them.
void addPresets(DebugViewSet& views, Commands& commands);

}  // namespace scatter::viewer
