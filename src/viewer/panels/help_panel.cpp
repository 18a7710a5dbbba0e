#include <imgui.h>

#include <string>

#include "viewer/panels/panels.h"

namespace scatter::viewer {
namespace {

void row(const char* key, const char* what, const char* help) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(key);
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(what);
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(help);
}

void showCommands(const Commands& commands) {
  std::string group;
  for (const Command& command : commands.all()) {
    if (command.group != group) {
      group = command.group;
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      ImGui::TableNextColumn();
      ImGui::TextColored({0.5F, 0.85F, 0.75F, 1.0F}, "%s", group.c_str());
    }
    row(std::string(keyName(command.key)).c_str(), command.label.c_str(), command.help.c_str());
  }
}

void showMouse() {
  row("left", "hand", "Does what the chosen hand does; in both worlds, if there are two");
  row("right drag", "turn", "Turns the camera");
  row("middle drag", "move", "Moves the camera sideways");
  row("wheel", "zoom", "Comes nearer or goes away");
  row("W A S D Q E", "fly", "Move the flying camera: forward, left, back, right, down, up");
}

/// What has no key: sliders and boxes of the panels.
void showSliders() {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TableNextColumn();
  ImGui::TextColored({0.5F, 0.85F, 0.75F, 1.0F}, "Sliders and boxes");
  row("", "frame", "The bar at the bottom: any frame that is kept");
  row("", "rate of time", "Of the physics, 0.05 to 4; Ctrl and click to type");
  row("", "push, throw", "Change of speed of a push, speed of a throw, m/s");
  row("", "budget, ms", "Processor time of a physics step, for hybrid worlds");
  row("", "switch", "Levels of pairs, or of bodies");
  row("", "policies", "What asks for levels; see `scatter list`");
}

}  // namespace

void showHelpPanel(ViewerState& state, const Layout& layout) {
  const ImVec2 middle(0.5F * layout.window().x, 0.5F * layout.window().y);
  ImGui::SetNextWindowPos(middle, ImGuiCond_Appearing, {0.5F, 0.5F});
  ImGui::SetNextWindowSize({640.0F, 0.9F * layout.window().y}, ImGuiCond_Appearing);
  if (ImGui::Begin("Help", &state.helpShown)) {
    if (ImGui::BeginTable("keys", 3, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_RowBg)) {
      showMouse();
      showCommands(state.commands);
      showSliders();
      ImGui::EndTable();
    }
  }
  ImGui::End();
}

}  // namespace scatter::viewer
