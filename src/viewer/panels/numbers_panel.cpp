#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "viewer/panels/frame_plots.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/plot.h"

namespace scatter::viewer {
namespace {

constexpr std::size_t kFrames = 300;

constexpr std::array<ImU32, 2> kPaneColors{IM_COL32(240, 160, 70, 255), IM_COL32(90, 215, 160, 255)};

std::vector<float> values(const FrameData& data, std::string_view channel) {
  std::vector<float> values;
  const auto id = data.find(channel);
  if (!id) return values;
  for (const double value : data.window(*id, std::min(kFrames, data.available())))
    values.push_back(static_cast<float>(value));
  return values;
}

/// One channel of all worlds.
PlotDef plotOf(const ViewerState& state, const char* title, std::string_view channel, const char* unit) {
  PlotDef plot;
  plot.title = title;
  plot.unit = unit;
  for (std::size_t i = 0; i < state.panes.size(); ++i) {
    const Pane& pane = *state.panes[i];
    plot.lines.push_back(
        {pane.label(), kPaneColors[i % kPaneColors.size()], values(pane.experiment().data(), channel)});
  }
  return plot;
}

ChannelValues valuesOf(const Pane& pane) {
  return [&data = pane.experiment().data()](std::string_view channel) { return values(data, channel); };
}

struct StageFigures {
  double now = 0.0;
  double mean = 0.0;
  double worst = 0.0;
};

StageFigures figuresOf(const FrameData& data, std::string_view channel) {
  StageFigures figures;
  const auto id = data.find(channel);
  if (!id || data.available() == 0) return figures;
  figures.now = data.value(*id);
  for (const double value : data.window(*id, data.available())) {
    figures.mean += value;
    figures.worst = std::max(figures.worst, value);
  }
  figures.mean /= static_cast<double>(data.available());
  return figures;
}

void stageRow(const char* name, const StageFigures& figures) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextWrapped("%s", name);
  for (const double value : {figures.now, figures.mean, figures.worst}) {
    ImGui::TableNextColumn();
    ImGui::Text("%5.1f", value);
  }
}

void showStageTable(const Pane& pane) {
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(2.0F, 1.0F));
  if (ImGui::BeginTable(("stages of " + pane.label()).c_str(), 4)) {
    const float number = ImGui::CalcTextSize("worst").x;
    ImGui::TableSetupColumn(pane.label().c_str());
    for (const char* title : {"now", "mean", "worst"})
      ImGui::TableSetupColumn(title, ImGuiTableColumnFlags_WidthFixed, number);
    ImGui::TableHeadersRow();
    const FrameData& data = pane.experiment().data();
    stageRow("physics, CPU", figuresOf(data, "physics_cpu_ms"));
    for (std::size_t i = 0; i < kStageCount; ++i) {
      const auto stage = static_cast<Stage>(i);
      stageRow(stageName(stage).c_str(), figuresOf(data, stageColumn(stage)));
    }
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
}

/// A click goes to a frame of the past.
void draw(PlotDef plot, const ViewerState& state, float scale) {
  std::size_t count = 0;
  for (const PlotLine& line : plot.lines) count = std::max(count, line.values.size());
  if (count == 0) return;
  Playback& time = state.playback;
  const std::uint64_t first = time.newest() + 1 - std::min<std::uint64_t>(count, time.newest() + 1);
  // What is older than the plot is shown by none of its values.
  const std::uint64_t now = time.shown() >= first ? time.shown() - first : count;
  plot.time = PlotTime{.values = count, .now = static_cast<std::size_t>(now), .firstFrame = first};
  if (const auto held = drawPlot(plot, scale)) time.show(std::max(time.oldest(), first + *held));
}

void showPlots(const ViewerState& state, float scale) {
  PlotDef time = plotOf(state, "physics", "physics_cpu_ms", "ms");
  time.limit = static_cast<float>(state.control.now().budget.milliseconds);
  time.height = 100.0F;
  draw(time, state, scale);
  const Pane& last = *state.panes.back();
  draw(stagesPlot(valuesOf(last), last.label()), state, scale);
  draw(plotOf(state, "manifolds", "manifolds", ""), state, scale);
  draw(plotOf(state, "contacts", "contacts", ""), state, scale);
  draw(plotOf(state, "pairs", "narrowphase_pairs", ""), state, scale);
  draw(levelsPlot(valuesOf(last), last.label()), state, scale);
}

}  // namespace

void showNumbersPanel(ViewerState& state, const Layout& layout) {
  const Place place = layout.numbers(state.hands.picked().has_value());
  if (beginFoldingPanel("Numbers", place, state.open.numbers)) {
    showPlots(state, layout.scale());
    if (ImGui::CollapsingHeader("Stages, last 600 frames, ms", ImGuiTreeNodeFlags_DefaultOpen)) {
      for (const auto& pane : state.panes) showStageTable(*pane);
    }
    ImGui::TextWrapped("picture %.1f ms, %zu bodies, %zu k faces", state.drawMilliseconds,
                       state.statistics.items, state.statistics.triangles / 1000);
  }
  ImGui::End();
}

}  // namespace scatter::viewer
