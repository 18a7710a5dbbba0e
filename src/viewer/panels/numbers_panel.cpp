#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "viewer/panels/panels.h"
#include "viewer/panels/plot.h"

namespace scatter::viewer {
namespace {

constexpr std::size_t kFrames = 300;

constexpr std::array<ImU32, 2> kPaneColors{IM_COL32(240, 160, 70, 255), IM_COL32(90, 215, 160, 255)};

constexpr std::array<ImU32, kStageCount> kStageColors{
    IM_COL32(120, 170, 230, 255), IM_COL32(170, 200, 240, 255), IM_COL32(240, 150, 80, 255),
    IM_COL32(150, 130, 210, 255), IM_COL32(220, 120, 180, 255), IM_COL32(225, 95, 95, 255),
    IM_COL32(130, 200, 130, 255), IM_COL32(160, 160, 160, 255), IM_COL32(200, 200, 130, 255),
    IM_COL32(90, 215, 190, 255)};

/// "collision detection" of "collision_detection_ms".
std::string stageName(Stage stage) {
  std::string name(stageColumn(stage));
  name = name.substr(0, name.size() - 3);
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

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

/// Levels in use: pairs at their finest level, and all pairs of the narrowphase, of the last world.
PlotDef levelsPlot(const ViewerState& state) {
  const FrameData& data = state.panes.back()->experiment().data();
  PlotDef plot;
  plot.title = "pairs by level, " + state.panes.back()->label();
  const std::vector<float> finest = values(data, "finest_pairs");
  std::vector<float> coarser = values(data, "narrowphase_pairs");
  for (std::size_t i = 0; i < coarser.size(); ++i) coarser[i] = std::max(0.0F, coarser[i] - finest[i]);
  plot.lines = {{"finest", IM_COL32(90, 215, 120, 255), finest},
                {"coarser", IM_COL32(235, 110, 80, 255), coarser}};
  plot.stacked = true;
  return plot;
}

PlotDef stagesPlot(const Pane& pane) {
  PlotDef plot;
  plot.title = "stages, " + pane.label();
  plot.unit = "ms";
  plot.stacked = true;
  for (std::size_t i = 0; i < kStageCount; ++i) {
    const auto stage = static_cast<Stage>(i);
    std::vector<float> line = values(pane.experiment().data(), stageColumn(stage));
    const bool matters = std::any_of(line.begin(), line.end(), [](float value) { return value > 0.05F; });
    if (matters) plot.lines.push_back({stageName(stage), kStageColors[i], std::move(line)});
  }
  return plot;
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

void showPlots(const ViewerState& state, float scale) {
  PlotDef time = plotOf(state, "physics", "physics_cpu_ms", "ms");
  time.limit = static_cast<float>(state.control.now().budget.milliseconds);
  time.height = 100.0F;
  drawPlot(time, scale);
  drawPlot(stagesPlot(*state.panes.back()), scale);
  drawPlot(plotOf(state, "manifolds", "manifolds", ""), scale);
  drawPlot(plotOf(state, "contacts", "contacts", ""), scale);
  drawPlot(plotOf(state, "pairs", "narrowphase_pairs", ""), scale);
  drawPlot(levelsPlot(state), scale);
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
