#include <imgui.h>

#include <cassert>
#include <string>

#include "viewer/panels/panels.h"

namespace scatter::viewer {
namespace {

const ImVec4 kLit(0.16F, 0.48F, 0.42F, 1.0F);

std::string buttonText(const Command& command) {
  return command.label + "##" + command.name;
}

std::string tipOf(const Command& command) {
  if (command.key == Key::kNone) return command.help;
  return command.help + "  [" + std::string(keyName(command.key)) + "]";
}

void show(const Command& command) {
  const bool lit = command.isOn && command.isOn();
  if (lit) ImGui::PushStyleColor(ImGuiCol_Button, kLit);
  if (ImGui::Button(buttonText(command).c_str())) command.run();
  if (lit) ImGui::PopStyleColor();
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tipOf(command).c_str());
}

float widthOf(const Command& command) {
  const std::string text = buttonText(command);
  return ImGui::CalcTextSize(text.c_str(), nullptr, true).x + 2.0F * ImGui::GetStyle().FramePadding.x;
}

}  // namespace

void commandButton(const Commands& commands, std::string_view name) {
  const Command* command = commands.find(name);
  assert(command != nullptr);
  show(*command);
}

void commandButtons(const Commands& commands, std::string_view group) {
  float left = 0.0F;
  for (const Command& command : commands.all()) {
    if (command.group != group) continue;
    const float width = widthOf(command) + ImGui::GetStyle().ItemSpacing.x;
    if (left > 0.0F && width <= left) {
      ImGui::SameLine();
    } else {
      left = ImGui::GetContentRegionAvail().x + ImGui::GetStyle().ItemSpacing.x;
    }
    left -= width;
    show(command);
  }
}

}  // namespace scatter::viewer
