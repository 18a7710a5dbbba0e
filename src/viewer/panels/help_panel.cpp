#include <imgui.h>

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "viewer/panels/panels.h"

namespace scatter::viewer {
namespace {

void addHeading(const std::string& title, std::vector<HelpLine>& lines) {
  lines.push_back({"", title, ""});
}

void addCommandLines(const Commands& commands, std::vector<HelpLine>& lines) {
  std::string group;
  for (const Command& command : commands.all()) {
    if (command.group != group) addHeading(group = command.group, lines);
    lines.push_back({std::string(keyName(command.key)), command.label, command.help});
  }
}

void showLine(const HelpLine& line) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(line.key.c_str());
  ImGui::TableNextColumn();
  if (line.help.empty()) {
    ImGui::TextColored({0.5F, 0.85F, 0.75F, 1.0F}, "%s", line.what.c_str());
    return;
  }
  ImGui::TextUnformatted(line.what.c_str());
  ImGui::TableNextColumn();
  ImGui::TextWrapped("%s", line.help.c_str());
}

/// The heading next to the middle: there the second column begins.
std::size_t secondColumn(std::span<const HelpLine> lines) {
  std::size_t best = 0;
  const auto fromMiddle = [&](std::size_t i) {
    return 2 * i > lines.size() ? 2 * i - lines.size() : lines.size() - 2 * i;
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].help.empty() && fromMiddle(i) < fromMiddle(best)) best = i;
  }
  return best;
}

void showColumn(const char* name, std::span<const HelpLine> lines, float width, float scale) {
  if (ImGui::BeginTable(name, 3, ImGuiTableFlags_RowBg, ImVec2(width, 0.0F))) {
    ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthFixed, 66.0F * scale);
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthFixed, 92.0F * scale);
    ImGui::TableSetupColumn("help");
    for (const HelpLine& line : lines) showLine(line);
    ImGui::EndTable();
  }
}

}  // namespace

std::vector<HelpLine> cameraHelp() {
  return {{"", "Mouse", ""},
          {"right", "turn", "Drag: turn the camera"},
          {"middle", "move", "Drag: move the camera sideways"},
          {"wheel", "zoom", "Come nearer or go away"}};
}

void showHelpPanel(const Commands& commands, std::vector<HelpLine> mouse, const Layout& layout,
                   const std::vector<HelpLine>& after) {
  std::vector<HelpLine> lines = std::move(mouse);
  addCommandLines(commands, lines);
  lines.insert(lines.end(), after.begin(), after.end());
  const std::size_t second = secondColumn(lines);
  const float scale = layout.scale();
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(4.0F * scale, 1.0F * scale));
  if (beginPanel("Help", layout.help(), false)) {
    commandButton(commands, "help");
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const ImVec2 corner = ImGui::GetCursorPos();
    const float width = 0.5F * (ImGui::GetContentRegionAvail().x - gap);
    showColumn("first", std::span(lines).first(second), width, scale);
    ImGui::SetCursorPos({corner.x + width + gap, corner.y});
    showColumn("second", std::span(lines).subspan(second), width, scale);
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

void showLabHelp(const ViewerState& state, const Layout& layout) {
  std::vector<HelpLine> mouse = cameraHelp();
  mouse.insert(mouse.begin() + 1, {"left", "hand", "What the chosen hand does, in both worlds"});
  mouse.push_back({"WASDQE", "fly", "Move the flying camera"});
  showHelpPanel(state.commands, std::move(mouse), layout,
                {{"", "Sliders", ""},
                 {"", "frame", "The bar at the bottom: any frame that is kept"},
                 {"", "rate of time", "Of the physics, 0.05 to 4; Ctrl and click to type"},
                 {"", "push, throw", "Speed that a push or a throw gives, m/s"},
                 {"", "budget", "Processor time of a physics step, for hybrid worlds"},
                 {"", "levels of", "What has a level: pairs, or bodies"},
                 {"", "policies", "What asks for levels; see `scatter list`"}});
}

}  // namespace scatter::viewer
