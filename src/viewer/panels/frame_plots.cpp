#include "viewer/panels/frame_plots.h"

#include <algorithm>
#include <array>
#include <utility>

namespace scatter::viewer {
namespace {

constexpr std::array<ImU32, kStageCount> kStageColors{
    IM_COL32(120, 170, 230, 255), IM_COL32(170, 200, 240, 255), IM_COL32(240, 150, 80, 255),
    IM_COL32(150, 130, 210, 255), IM_COL32(220, 120, 180, 255), IM_COL32(225, 95, 95, 255),
    IM_COL32(130, 200, 130, 255), IM_COL32(160, 160, 160, 255), IM_COL32(200, 200, 130, 255),
    IM_COL32(90, 215, 190, 255)};

}  // namespace

std::string stageName(Stage stage) {
  std::string name(stageColumn(stage));
  name = name.substr(0, name.size() - 3);
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

PlotDef stagesPlot(const ChannelValues& values, const std::string& label) {
  PlotDef plot;
  plot.title = label.empty() ? "stages" : "stages, " + label;
  plot.unit = "ms";
  plot.stacked = true;
  for (std::size_t i = 0; i < kStageCount; ++i) {
    const auto stage = static_cast<Stage>(i);
    std::vector<float> line = values(stageColumn(stage));
    const bool matters = std::any_of(line.begin(), line.end(), [](float value) { return value > 0.05F; });
    if (matters) plot.lines.push_back({stageName(stage), kStageColors[i], std::move(line)});
  }
  return plot;
}

PlotDef levelsPlot(const ChannelValues& values, const std::string& label) {
  PlotDef plot;
  plot.title = label.empty() ? "pairs by level" : "pairs by level, " + label;
  const std::vector<float> finest = values("finest_pairs");
  std::vector<float> coarser = values("narrowphase_pairs");
  for (std::size_t i = 0; i < std::min(finest.size(), coarser.size()); ++i)
    coarser[i] = std::max(0.0F, coarser[i] - finest[i]);
  plot.lines = {{"finest", IM_COL32(90, 215, 120, 255), finest},
                {"coarser", IM_COL32(235, 110, 80, 255), coarser}};
  plot.stacked = true;
  return plot;
}

}  // namespace scatter::viewer
