#include "viewer/panels/panels.h"

#include <imgui.h>

#include <string>

namespace scatter::viewer {
namespace {

/// The name of each world at the top of its picture.
void showLabels(const ViewerState& state, const Layout& layout) {
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  for (std::size_t i = 0; i < state.panes.size(); ++i) {
    const Experiment& experiment = state.panes[i]->experiment();
    const std::string text = experiment.options().scene + ", " + state.panes[i]->label();
    const glm::vec2 corner = layout.corner(i);
    const float left = corner.x + 0.5F * (layout.size().x - ImGui::CalcTextSize(text.c_str()).x);
    draw.AddText({left + 1.0F, 9.0F}, IM_COL32(0, 0, 0, 200), text.c_str());
    draw.AddText({left, 8.0F}, IM_COL32(235, 240, 245, 255), text.c_str());
    if (i > 0) draw.AddLine({corner.x, 0.0F}, {corner.x, layout.size().y}, IM_COL32(200, 210, 220, 120));
  }
}

}  // namespace

void placePanel(const glm::vec2& corner, const glm::vec2& size) {
  ImGui::SetNextWindowPos({corner.x, corner.y});
  ImGui::SetNextWindowSize({size.x, size.y});
}

void showPanels(ViewerState& state, const Layout& layout) {
  showLabels(state, layout);
  if (state.panelsShown) {
    showControlPanel(state, layout);
    showNumbersPanel(state, layout);
    showInspectorPanel(state, layout);
    showTimePanel(state, layout);
  }
  if (state.helpShown) showHelpPanel(state, layout);
}

}  // namespace scatter::viewer
