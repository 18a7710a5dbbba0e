#include "viewer/panels/panels.h"

#include <imgui.h>
#include <scatter/lab/frame_table.h>

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace scatter::viewer {
namespace {

/// What the step to a frame cost; empty before the first.
std::string costOf(const Experiment& experiment, std::uint64_t frame) {
  const std::vector<double>& costs = experiment.table().values("physics_cpu_ms");
  if (frame == 0 || frame > costs.size()) return {};
  char cost[32];
  std::snprintf(cost, sizeof cost, ": %.1f ms", costs[frame - 1]);
  return cost;
}

/// What a world is, and what a step of it cost, as far as there is room.
std::string labelOf(const Experiment& experiment, std::uint64_t frame, float room) {
  const std::string& world = experiment.options().label;
  const std::string cost = costOf(experiment, frame);
  for (const std::string& text : {experiment.options().scene + ", " + world + cost, world + cost}) {
    if (ImGui::CalcTextSize(text.c_str()).x <= room) return text;
  }
  return world;
}

/// The name of each world at the top of its picture.
void showLabels(const ViewerState& state, const Layout& layout) {
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  for (std::size_t i = 0; i < state.panes.size(); ++i) {
    const Experiment& experiment = state.panes[i]->experiment();
    const float around = 4.0F * layout.scale();
    const std::string text = labelOf(experiment, state.playback.shown(), layout.size().x - 4.0F * around);
    const glm::vec2 corner = layout.corner(i);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float left = corner.x + 0.5F * (layout.size().x - size.x);
    const float top = 8.0F * layout.scale();
    draw.AddRectFilled({left - around, top - around}, {left + size.x + around, top + size.y + around},
                       IM_COL32(8, 10, 16, 150), around);
    draw.AddText({left, top}, IM_COL32(235, 240, 245, 255), text.c_str());
    if (i > 0) draw.AddLine({corner.x, 0.0F}, {corner.x, layout.size().y}, IM_COL32(200, 210, 220, 120));
  }
}

/// What is under the pointer.
void showHovered(const ViewerState& state) {
  if (!state.hovered.empty() && !ImGui::GetIO().WantCaptureMouse)
    ImGui::SetTooltip("%s", state.hovered.c_str());
}

}  // namespace

bool beginPanel(const char* title, const Place& place, bool titled) {
  ImGui::SetNextWindowPos({place.corner.x, place.corner.y});
  ImGui::SetNextWindowSize({place.size.x, place.size.y});
  ImGuiWindowFlags flags = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize;
  if (!titled) flags |= ImGuiWindowFlags_NoTitleBar;
  return ImGui::Begin(title, nullptr, flags);
}

bool beginFoldingPanel(const char* title, const Place& place, bool& open) {
  ImGui::SetNextWindowCollapsed(!open);
  const bool shown = beginPanel(title, place);
  open = !ImGui::IsWindowCollapsed();
  return shown;
}

void drawColorBar(ImDrawList& list, const Place& place, const std::function<Color(float)>& colorAt) {
  constexpr int kSteps = 32;
  const float step = place.size.x / static_cast<float>(kSteps);
  for (int i = 0; i < kSteps; ++i) {
    const Color color = colorAt((static_cast<float>(i) + 0.5F) / static_cast<float>(kSteps));
    const float left = place.corner.x + static_cast<float>(i) * step;
    list.AddRectFilled({left, place.corner.y}, {left + step, place.corner.y + place.size.y},
                       ImGui::ColorConvertFloat4ToU32({color.r, color.g, color.b, 1.0F}));
  }
}

void showPanels(ViewerState& state, const Layout& layout) {
  showLabels(state, layout);
  if (state.switches.help) {
    showLabHelp(state, layout);
  } else if (state.switches.panels) {
    showControlPanel(state, layout);
    showNumbersPanel(state, layout);
    showInspectorPanel(state, layout);
    showTimePanel(state, layout);
    showHovered(state);
  }
}

}  // namespace scatter::viewer
