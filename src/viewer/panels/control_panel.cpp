#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "viewer/palette.h"
#include "viewer/panels/panels.h"
#include "viewer/policy_choice.h"

namespace scatter::viewer {
namespace {

void showBudget(ViewerState& state) {
  float& budget = state.draggedBudget;
  if (!ImGui::IsAnyItemActive()) budget = static_cast<float>(state.control.now().budget.milliseconds);
  ImGui::SetNextItemWidth(-1.0F);
  ImGui::SliderFloat("##budget", &budget, 0.0F, 33.0F, budget > 0.0F ? "budget %.1f ms" : "no budget");
  // A budget learns what its milliseconds are worth: not anew for every pixel that the slider is dragged.
  if (ImGui::IsItemDeactivatedAfterEdit()) {
    state.control.setBudgetMilliseconds(budget < 0.1F ? 0.0 : static_cast<double>(budget));
  }
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Processor milliseconds that a physics step may cost");
  const std::string words = state.control.describeBudget();
  if (!words.empty()) ImGui::TextWrapped("%s", words.c_str());
}

/// Of bodies one policy, of pairs as many as are wanted.
void showPolicies(WorldControl& control) {
  const bool one = control.now().switching == Switching::kBody;
  if (!ImGui::TreeNode(one ? "policy" : "policies")) return;
  for (const PolicyChoice& choice : policyChoices(control.now())) {
    bool chosen = choice.chosen;
    const bool clicked =
        one ? ImGui::RadioButton(choice.name.c_str(), chosen) : ImGui::Checkbox(choice.name.c_str(), &chosen);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", choice.summary.c_str());
    if (!clicked) continue;
    const ChosenPolicies wanted = choosePolicy(control.now(), choice.name, one || chosen);
    control.setPolicies(wanted.policy, wanted.named);
    break;
  }
  ImGui::TreePop();
}

void showHybridWorld(ViewerState& state) {
  WorldControl& control = state.control;
  showBudget(state);
  const bool pairs = control.now().switching == Switching::kPair;
  ImGui::TextUnformatted("levels of");
  if (ImGui::RadioButton("pairs", pairs)) control.setSwitching(Switching::kPair);
  ImGui::SameLine();
  if (ImGui::RadioButton("bodies", !pairs)) control.setSwitching(Switching::kBody);
  showPolicies(control);
}

void showStrengths(HandTools& hands) {
  constexpr ImGuiSliderFlags kFlags = ImGuiSliderFlags_Logarithmic;
  ImGui::SetNextItemWidth(-1.0F);
  if (hands.tool == Tool::kPush)
    ImGui::SliderFloat("##push", &hands.impulse, 0.1F, 50.0F, "push %.1f m/s", kFlags);
  if (hands.tool == Tool::kThrow)
    ImGui::SliderFloat("##throw", &hands.throwSpeed, 1.0F, 200.0F, "throw %.0f m/s", kFlags);
}

void showScenes(ViewerState& state) {
  const std::string& now = state.panes.front()->experiment().options().scene;
  ImGui::SetNextItemWidth(-1.0F);
  if (ImGui::BeginCombo("##scene", now.c_str(), ImGuiComboFlags_HeightLarge)) {
    // Files of scenes come and go.
    if (ImGui::IsWindowAppearing()) state.scenes = SceneRegistry::instance().all();
    for (const auto& scene : state.scenes) {
      if (ImGui::Selectable(scene->name.c_str(), scene->name == now)) state.wantedScene = scene->name;
      if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", scene->summary.c_str());
    }
    ImGui::EndCombo();
  }
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip("%s", state.panes.front()->experiment().options().summary.c_str());
  commandButtons(state.commands, "Scene");
}

/// A bar of colours with words at its ends.
void showLegend(const char* first, const char* last, const std::function<Color(float)>& colorAt) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const glm::vec2 size(ImGui::GetContentRegionAvail().x, 0.4F * ImGui::GetTextLineHeight());
  drawColorBar(*ImGui::GetWindowDrawList(), {{corner.x, corner.y}, size}, colorAt);
  ImGui::Dummy({1.0F, size.y});
  ImGui::TextUnformatted(first);
  ImGui::SameLine(std::max(0.0F, ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(last).x));
  ImGui::TextUnformatted(last);
}

void showLegends(const DebugViewSet& views) {
  if (views.has(DebugView::kLevels) || views.has(DebugView::kPairLevels)) {
    constexpr int kLevels = 5;
    showLegend("coarse", "fine",
               [](float share) { return levelColor(1 + static_cast<int>(share * kLevels), kLevels); });
  }
  if (views.has(DebugView::kCost)) {
    showLegend("0.5 us", "200 us",
               [](float share) { return costColor(kLeastCost * std::pow(kMostCost / kLeastCost, share)); });
  }
}

/// What most users want to see, and below, folded, every view by itself.
void showViews(ViewerState& state) {
  commandButtons(state.commands, "Show");
  showLegends(state.views);
  ImGui::TextUnformatted("shadows");
  commandButtons(state.commands, "Shadows");
  if (ImGui::TreeNode("single views")) {
    commandButtons(state.commands, "Views");
    ImGui::TreePop();
  }
}

bool section(const char* title, bool open) {
  return ImGui::CollapsingHeader(title, open ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
}

}  // namespace

void showControlPanel(ViewerState& state, const Layout& layout) {
  if (beginFoldingPanel("Lab", layout.lab(), state.open.lab)) {
    if (section("Scene", true)) showScenes(state);
    if (section("Show", true)) showViews(state);
    if (section("Hands", true)) {
      commandButtons(state.commands, "Hands");
      showStrengths(state.hands);
    }
    if (state.control.exists() && section("Hybrid world", true)) showHybridWorld(state);
    if (section("Camera", false)) commandButtons(state.commands, "Camera");
    if (section("Ask for levels", false)) commandButtons(state.commands, "Levels");
    if (section("Window", false)) commandButtons(state.commands, "Window");
  }
  ImGui::End();
}

}  // namespace scatter::viewer
