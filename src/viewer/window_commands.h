#pragma once

#include "viewer/commands.h"
#include "viewer/debug_views.h"
#include "viewer/outputs.h"

namespace scatter::viewer {

/// Commands that every window has, whatever it shows. What they act on must outlive them.
/// @{
void addView(const DebugViewInfo& info, DebugViewSet& views, Commands& commands);
void addScreenshot(Outputs& outputs, Commands& commands);
void addFilm(Outputs& outputs, Commands& commands);
/// @}

/// Those of a window with a bar and no other panels: the bar, pictures, films, and the window's end.
void addBarAndOutput(bool& barShown, bool& closing, Outputs& outputs, Commands& commands);

}  // namespace scatter::viewer
