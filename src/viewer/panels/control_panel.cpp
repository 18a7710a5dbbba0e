#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "lod/policy_catalog.h"
#include "viewer/panels/panels.h"

namespace scatter::viewer {
namespace {

constexpr float kColumn = 118.0F;  // pixels, of the second of two in a line

void showBudget(ViewerState& state) {
  float& budget = state.draggedBudget;
  if (!ImGui::IsAnyItemActive()) budget = static_cast<float>(state.control.now().budget.milliseconds);
  ImGui::SetNextItemWidth(140.0F);
  ImGui::SliderFloat("budget, ms", &budget, 0.0F, 33.0F, budget > 0.0F ? "%.1f ms" : "none");
  // A budget learns what its milliseconds are worth: not anew for every pixel that the slider is dragged.
  if (ImGui::IsItemDeactivatedAfterEdit()) {
    state.control.setBudgetMilliseconds(budget < 0.1F ? 0.0 : static_cast<double>(budget));
  }
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Processor milliseconds that a physics step may cost");
}

void showPolicies(WorldControl& control) {
  std::vector<std::string> chosen = control.now().policies;
  for (std::size_t i = 0; i < lod::knownPolicies().size(); ++i) {
    const lod::PolicyInfo& policy = lod::knownPolicies()[i];
    const std::string name(policy.name);
    const auto at = std::find_if(chosen.begin(), chosen.end(), [&](const std::string& one) {
      return one == name || one.rfind(name + ":", 0) == 0;
    });
    bool on = at != chosen.end();
    if (i % 2 == 1) ImGui::SameLine(kColumn);
    const bool clicked = ImGui::Checkbox(name.c_str(), &on);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(policy.summary).c_str());
    if (!clicked) continue;
    if (on) {
      chosen.push_back(name);
    } else {
      chosen.erase(at);
    }
    control.setPolicies(control.now().policy, chosen);
    return;
  }
}

void showEverything(WorldControl& control) {
  static constexpr std::array<std::pair<Policy, const char*>, 4> kBase{{{Policy::kNone, "none"},
                                                                        {Policy::kProximity, "proximity"},
                                                                        {Policy::kFinest, "all finest"},
                                                                        {Policy::kCoarsest, "all coarsest"}}};
  for (const auto& [policy, name] : kBase) {
    const bool firstOfLine = policy == Policy::kNone || policy == Policy::kFinest;
    if (!firstOfLine) ImGui::SameLine(kColumn);
    if (ImGui::RadioButton(name, control.now().policy == policy))
      control.setPolicies(policy, control.now().policies);
  }
}

void showHybridWorld(ViewerState& state) {
  WorldControl& control = state.control;
  showBudget(state);
  const bool pairs = control.now().switching == Switching::kPair;
  if (ImGui::RadioButton("switch pairs", pairs)) control.setSwitching(Switching::kPair);
  ImGui::SameLine(kColumn);
  if (ImGui::RadioButton("switch bodies", !pairs)) control.setSwitching(Switching::kBody);
  ImGui::TextUnformatted("policies");
  showEverything(control);
  if (pairs) showPolicies(control);
}

void showStrengths(HandTools& hands) {
  ImGui::SetNextItemWidth(140.0F);
  if (hands.tool == Tool::kPush)
    ImGui::SliderFloat("push, m/s", &hands.impulse, 0.1F, 50.0F, "%.1f", ImGuiSliderFlags_Logarithmic);
  if (hands.tool == Tool::kThrow)
    ImGui::SliderFloat("throw, m/s", &hands.throwSpeed, 1.0F, 200.0F, "%.0f", ImGuiSliderFlags_Logarithmic);
}

}  // namespace

void showControlPanel(ViewerState& state, const Layout& layout) {
  if (layout.leftWidth() > 0.0F) placePanel({0.0F, 0.0F}, {layout.leftWidth(), layout.sideHeight()});
  if (ImGui::Begin("Lab")) {
    for (const char* group : {"Views", "Hands (left button)", "Levels", "Camera", "Window"}) {
      if (!ImGui::CollapsingHeader(group, ImGuiTreeNodeFlags_DefaultOpen)) continue;
      commandButtons(state.commands, group);
      if (std::string_view(group) == "Hands (left button)") showStrengths(state.hands);
    }
    if (state.control.exists() && ImGui::CollapsingHeader("Hybrid world", ImGuiTreeNodeFlags_DefaultOpen)) {
      showHybridWorld(state);
    }
  }
  ImGui::End();
}

}  // namespace scatter::viewer
