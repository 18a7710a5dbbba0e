#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>

#include "viewer/panels/panels.h"

namespace scatter::viewer {
namespace {

constexpr float kRateWidth = 140.0F;  // pixels at scale 1

std::string stateOf(const ViewerState& state) {
  for (const auto& pane : state.panes) {
    if (!pane->experiment().stopped().empty()) return pane->label() + ": " + pane->experiment().stopped();
  }
  if (state.playback.past()) return state.playback.paused() ? "the past" : "the past, playing";
  return state.playback.paused() ? "paused" : "running";
}

void showScrubber(ViewerState& state) {
  Playback& time = state.playback;
  const auto oldest = static_cast<int>(time.oldest());
  const auto newest = static_cast<int>(time.newest());
  int shown = static_cast<int>(time.shown());
  ImGui::SetNextItemWidth(-1.0F);
  char format[64];
  std::snprintf(format, sizeof format, "frame %%d of %d, %.2f s", newest, shown / 60.0);
  if (ImGui::SliderInt("##frame", &shown, oldest, std::max(newest, oldest + 1), format)) {
    time.show(static_cast<std::uint64_t>(std::clamp(shown, oldest, newest)));
  }
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Drag to look at any frame since %d, in all worlds", oldest);
}

void showRate(Playback& time, float scale) {
  auto rate = static_cast<float>(time.rate());
  ImGui::SetNextItemWidth(kRateWidth * scale);
  if (ImGui::SliderFloat("rate of time", &rate, static_cast<float>(Loop::kMinRate),
                         static_cast<float>(Loop::kMaxRate), "%.2f x", ImGuiSliderFlags_Logarithmic)) {
    time.setRate(static_cast<double>(rate));
  }
}

/// What can be done next, for whoever sees the window for the first time.
std::string hintOf(const ViewerState& state) {
  static constexpr std::array<const char*, kToolCount> kHints{
      "drag a body with the left button", "click a body to push it",
      "click to throw a copy of the picked body there", "hold the left button: everything comes there",
      "click to put a copy of the picked body there"};
  std::string hint = "drag the bar to any frame; End goes back to now";
  if (!state.playback.past()) hint = kHints[static_cast<std::size_t>(state.hands.tool)];
  return hint + " | right button turns, wheel zooms | N: next scene | F1: all keys";
}

void showState(const ViewerState& state) {
  ImGui::TextColored({0.5F, 0.85F, 0.75F, 1.0F}, "%s", stateOf(state).c_str());
  const std::string& said = !state.hands.message().empty()     ? state.hands.message()
                            : !state.control.message().empty() ? state.control.message()
                                                               : state.outputs.message();
  if (!said.empty()) {
    ImGui::SameLine();
    ImGui::TextUnformatted(said.c_str());
  }
  ImGui::SameLine();
  ImGui::TextDisabled("%s", hintOf(state).c_str());
}

}  // namespace

void showTimePanel(ViewerState& state, const Layout& layout) {
  if (beginPanel("Time", layout.time(), false)) {
    const ImGuiDir way = state.open.time ? ImGuiDir_Down : ImGuiDir_Up;
    if (ImGui::ArrowButton("fold", way)) state.open.time = !state.open.time;
    ImGui::SameLine();
    showScrubber(state);
    if (state.open.time) {
      commandButtons(state.commands, "Time");
      ImGui::SameLine();
      showRate(state.playback, layout.scale());
      showState(state);
    }
  }
  ImGui::End();
}

}  // namespace scatter::viewer
