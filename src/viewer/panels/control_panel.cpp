#include <imgui.h>

#include "viewer/panels/panels.h"
#include "viewer/policy_choice.h"

namespace scatter::viewer {
namespace {

constexpr const char* kHandsGroup = "Hands";

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
  ImGui::TextUnformatted(one ? "policy" : "policies");
  for (const PolicyChoice& choice : policyChoices(control.now())) {
    bool chosen = choice.chosen;
    const bool clicked =
        one ? ImGui::RadioButton(choice.name.c_str(), chosen) : ImGui::Checkbox(choice.name.c_str(), &chosen);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", choice.summary.c_str());
    if (!clicked) continue;
    const ChosenPolicies wanted = choosePolicy(control.now(), choice.name, one || chosen);
    control.setPolicies(wanted.policy, wanted.named);
    return;
  }
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

}  // namespace

void showControlPanel(ViewerState& state, const Layout& layout) {
  if (beginFoldingPanel("Lab", layout.lab(), state.open.lab)) {
    const auto section = [](const char* title) {
      return ImGui::CollapsingHeader(title, ImGuiTreeNodeFlags_DefaultOpen);
    };
    for (const char* group : {"Camera", "Views", kHandsGroup, "Levels"}) {
      if (!section(group)) continue;
      commandButtons(state.commands, group);
      if (group == kHandsGroup) showStrengths(state.hands);
    }
    if (state.control.exists() && section("Hybrid world")) showHybridWorld(state);
    if (section("Window")) commandButtons(state.commands, "Window");
  }
  ImGui::End();
}

}  // namespace scatter::viewer
