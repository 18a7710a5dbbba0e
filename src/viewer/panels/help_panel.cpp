#include <imgui.h>

#include <span>
#include <string>
#include <vector>

#include "viewer/panels/panels.h"

namespace scatter::viewer {
namespace {

struct HelpLine {
  std::string key{};
  std::string what{};
  std::string help{};  ///< Empty in a heading.
};

void addHeading(const std::string& title, std::vector<HelpLine>& lines) {
  lines.push_back({"", title, ""});
}

void addMouse(std::vector<HelpLine>& lines) {
  addHeading("Mouse and flying", lines);
  lines.push_back({"left", "hand", "What the chosen hand does, in both worlds"});
  lines.push_back({"right", "turn", "Drag: turn the camera"});
  lines.push_back({"middle", "move", "Drag: move the camera sideways"});
  lines.push_back({"wheel", "zoom", "Come nearer or go away"});
  lines.push_back({"WASDQE", "fly", "Move the flying camera"});
}

void addCommandLines(const Commands& commands, std::vector<HelpLine>& lines) {
  std::string group;
  for (const Command& command : commands.all()) {
    if (command.group != group) addHeading(group = command.group, lines);
    lines.push_back({std::string(keyName(command.key)), command.label, command.help});
  }
}

/// What has no key: sliders and boxes of the panels.
void addSliders(std::vector<HelpLine>& lines) {
  addHeading("Sliders and boxes", lines);
  lines.push_back({"", "frame", "The bar at the bottom: any frame that is kept"});
  lines.push_back({"", "rate of time", "Of the physics, 0.05 to 4; Ctrl and click to type"});
  lines.push_back({"", "push, throw", "Speed that a push or a throw gives, m/s"});
  lines.push_back({"", "budget", "Processor time of a physics step, for hybrid worlds"});
  lines.push_back({"", "levels of", "What has a level: pairs, or bodies"});
  lines.push_back({"", "policies", "What asks for levels; see `scatter list`"});
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

void showColumn(const char* name, std::span<const HelpLine> lines, float scale) {
  const ImVec2 size(0.5F * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x), 0.0F);
  if (ImGui::BeginTable(name, 3, ImGuiTableFlags_RowBg, size)) {
    ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthFixed, 66.0F * scale);
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthFixed, 92.0F * scale);
    ImGui::TableSetupColumn("help");
    for (const HelpLine& line : lines) showLine(line);
    ImGui::EndTable();
  }
}

}  // namespace

void showHelpPanel(ViewerState& state, const Layout& layout) {
  std::vector<HelpLine> lines;
  addMouse(lines);
  addCommandLines(state.commands, lines);
  addSliders(lines);
  // The column begins with a heading.
  auto second = lines.begin() + static_cast<std::ptrdiff_t>(lines.size() / 2);
  while (second != lines.begin() && !second->help.empty()) --second;
  const auto count = static_cast<std::size_t>(second - lines.begin());
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(4.0F * layout.scale(), 0.0F));
  if (beginPanel("Help", layout.help(), false)) {
    commandButton(state.commands, "help");
    const ImVec2 top = ImGui::GetCursorPos();
    showColumn("first", std::span(lines).first(count), layout.scale());
    ImGui::SetCursorPos({0.5F * (layout.window().x + ImGui::GetStyle().ItemSpacing.x), top.y});
    showColumn("second", std::span(lines).subspan(count), layout.scale());
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace scatter::viewer
