#pragma once

#include "viewer/layout.h"
#include "viewer/viewer_state.h"

namespace scatter::viewer {

/// All panels of a window; called inside a frame of Dear ImGui.
void showPanels(ViewerState& state, const Layout& layout);

/// The single panels, in the order of the screen. Each is a part of showPanels().
/// @{
void showTimePanel(ViewerState& state, const Layout& layout);
void showControlPanel(ViewerState& state, const Layout& layout);
void showNumbersPanel(ViewerState& state, const Layout& layout);
void showInspectorPanel(ViewerState& state, const Layout& layout);
void showHelpPanel(ViewerState& state, const Layout& layout);
/// @}

/// Begins a panel that is there and nowhere else. Returns whether there is something to be shown in it; to be
/// ended with ImGui::End() in any case.
[[nodiscard]] bool beginPanel(const char* title, const Place& place, bool titled = true);

/// The same of one that folds: `open` follows the user's click on its title, and the title follows `open`.
[[nodiscard]] bool beginFoldingPanel(const char* title, const Place& place, bool& open);

/// A command as a button, lit if it is on; its help and its key are the tip.
void commandButton(const Commands& commands, std::string_view name);

/// All of a group, in as many lines as it takes.
void commandButtons(const Commands& commands, std::string_view group);

}  // namespace scatter::viewer
