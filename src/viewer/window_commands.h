#pragma once

#include "viewer/commands.h"
#include "viewer/debug_views.h"
#include "viewer/outputs.h"

namespace scatter::viewer {

/// Where a window's shadows fall if nobody says: on everything, but not where that takes a processor long.
[[nodiscard]] Shadows usualShadows(const Renderer& renderer);

/// What of a window itself a user switches.
struct WindowSwitches {
  bool panels = true;  ///< Shown.
  bool help = false;   ///< Shown, over everything.
  bool closing = false;
};

/// Commands that every window has, whatever it shows. What they act on must outlive them.
/// @{
void addView(const DebugViewInfo& info, DebugViewSet& views, Commands& commands);
void addShadows(Shadows& shadows, Commands& commands);
void addPanels(WindowSwitches& switches, Commands& commands);
/// A panel that folds, by its name.
void addFold(const std::string& panel, Key key, bool& open, Commands& commands);

void addScreenshot(Outputs& outputs, Commands& commands);
void addFilm(Outputs& outputs, Commands& commands);
void addClose(WindowSwitches& switches, Commands& commands);
/// @}

/// All of those but views and shadows, for a window that has no others of its kind.
void addWindow(WindowSwitches& switches, Outputs& outputs, Commands& commands);

}  // namespace scatter::viewer
