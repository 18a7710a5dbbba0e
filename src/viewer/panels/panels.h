#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/layout.h"
#include "viewer/viewer_state.h"

struct ImDrawList;

namespace scatter::viewer {

/// All panels of a window; called inside a frame of Dear ImGui.
void showPanels(ViewerState& state, const Layout& layout);

/// The single panels, in the order of the screen. Each is a part of showPanels().
/// @{
void showTimePanel(ViewerState& state, const Layout& layout);
void showControlPanel(ViewerState& state, const Layout& layout);
void showNumbersPanel(ViewerState& state, const Layout& layout);
void showInspectorPanel(ViewerState& state, const Layout& layout);
/// @}

/// What the help panel says of something that is no command.
struct HelpLine {
  std::string key{};
  std::string what{};
  std::string help{};  ///< Empty in a heading.
};

/// Of a window whose pointer has nothing to do but to steer the camera.
[[nodiscard]] std::vector<HelpLine> cameraHelp();

/// Tells of the mouse, of all commands, and of what else there is: the lines after.
void showHelpPanel(const Commands& commands, std::vector<HelpLine> mouse, const Layout& layout,
                   const std::vector<HelpLine>& after = {});

/// The same of a lab window, whose mouse has hands and whose panels have sliders.
void showLabHelp(const ViewerState& state, const Layout& layout);

/// Begins a panel that is there and nowhere else. Returns whether there is something to be shown in it; to be
/// ended with ImGui::End() in any case.
[[nodiscard]] bool beginPanel(const char* title, const Place& place, bool titled = true);

/// The same of one that folds: `open` follows the user's click on its title, and the title follows `open`.
[[nodiscard]] bool beginFoldingPanel(const char* title, const Place& place, bool& open);

/// A bar of colours from that of 0 to that of 1.
void drawColorBar(ImDrawList& list, const Place& place, const std::function<Color(float)>& colorAt);

/// A command as a button, lit if it is on; its help and its key are the tip.
void commandButton(const Commands& commands, std::string_view name);

/// All of a group, in as many lines as it takes.
void commandButtons(const Commands& commands, std::string_view group);

}  // namespace scatter::viewer
