#include "lab/figure_panels.h"

#include "lab/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace scatter::lab {

namespace {

struct StageLook {
  const char* name;
  const char* color;
};

// By Stage. The ones that are hardly ever seen are grey.
constexpr std::array<StageLook, kStageCount> kStageLooks{{
    {"update AABBs", color::kSkyBlue},
    {"predict motion", color::kYellow},
    {"collision detection", color::kVermillion},
    {"islands", color::kPurple},
    {"non-contact constraints", color::kDarkGrey},
    {"contact constraints", color::kBlue},
    {"integrate transforms", color::kGreen},
    {"vehicles", color::kLightGrey},
    {"activation", color::kGrey},
    {"level planning", color::kOrange},
}};

constexpr std::array<const char*, 6> kWorldColors{color::kVermillion, color::kBlue,   color::kGreen,
                                                  color::kOrange,     color::kPurple, color::kSkyBlue};

// Wall time also holds what other programs took. A frame that was interrupted must not press all others flat:
// the axis ends somewhat above the highest processor time, and the title says what is beyond.
double stagesTop(const FigureData& data, const FrameRange& frames) {
  const double cpu = data.highest("physics_cpu_ms", frames);
  return std::min(data.highest("physics_ms", frames), 1.3 * cpu);
}

std::string stagesTitle(const FigureData& data, std::size_t world, const FrameRange& frames, double top) {
  const int beyond = data.countAbove(world, "physics_ms", frames, top);
  if (beyond == 0) {
    return worldTitle(data, world);
  }
  return worldTitle(data, world) + "; beyond the axis: " + std::to_string(beyond) +
         (beyond == 1 ? " frame, " : " frames, up to ") +
         readableNumber(data.highest(world, "physics_ms", frames)) + " ms, interrupted by other programs";
}

}  // namespace

const char* worldColor(std::size_t world) {
  return kWorldColors[world % kWorldColors.size()];
}

const char* stageName(Stage stage) {
  return kStageLooks[static_cast<std::size_t>(stage)].name;
}

const char* stageColor(Stage stage) {
  return kStageLooks[static_cast<std::size_t>(stage)].color;
}

std::string coloured(const std::string& look, const char* rgb) {
  return look + " linecolor rgb " + quoted(rgb);
}

Curve curveOf(std::size_t world, std::string_view column, std::string style, std::string title,
              const std::string& axes) {
  return {.plot = quoted(FigureData::fileOf(world)) + " using 1:" +
                  std::to_string(FigureData::columnOf(column)) + (axes.empty() ? "" : " axes " + axes),
          .style = std::move(style),
          .title = std::move(title)};
}

double axisTop(double highest, double room) {
  return highest > 0.0 ? highest * room : 1.0;
}

std::string worldTitle(const FigureData& data, std::size_t world) {
  return data.label(world) + " world";
}

bool budgetInRange(const FigureData& data, double highest) {
  return data.options().budgetMs <= highest * 1.5;
}

Curve budgetLine(const FigureData& data, double highest) {
  const double budget = data.options().budgetMs;
  if (!budgetInRange(data, highest)) {
    return {};
  }
  return {.plot = shortestNumber(budget),
          .style = coloured("lines linewidth 1.4 dashtype (6,4)", color::kBlack),
          .title = "budget " + readableNumber(budget) + " ms"};
}

Panel manifoldsPanel(const FigureData& data, std::size_t world, const FrameRange& frames) {
  Panel panel{.title = worldTitle(data, world), .yLabel = "manifolds", .yColor = color::kVermillion};
  panel.yMax = axisTop(data.highest("manifolds", frames));
  panel.y2Label = "narrowphase pairs";
  panel.y2Color = color::kBlue;
  panel.y2Max = axisTop(data.highest("narrowphase_pairs", frames));
  panel.curves = {
      curveOf(world, "narrowphase_pairs", coloured("lines linewidth 3.6", color::kBlue), "narrowphase pairs",
              "x1y2"),
      curveOf(world, "manifolds", coloured("lines linewidth 1.5", color::kVermillion), "manifolds", "x1y1")};
  return panel;
}

Panel worldsPanel(const FigureData& data, const FrameRange& frames, std::string_view column,
                  std::string title, std::string yLabel) {
  Panel panel{.title = std::move(title), .yLabel = std::move(yLabel)};
  panel.yMax = axisTop(data.highest(column, frames), 1.1);
  // The first is drawn wider, so that equal ones can be seen.
  for (std::size_t world = 0; world < data.worlds(); ++world) {
    const double width = world == 0 ? 2.6 : 1.3;
    panel.curves.push_back(curveOf(world, column,
                                   coloured("lines linewidth " + fixedNumber(width, 1), worldColor(world)),
                                   worldTitle(data, world)));
  }
  return panel;
}

Panel switchesPanel(const FigureData& data, const FrameRange& frames) {
  Panel panel{.title = "Switches in each frame: up to a coarser level, down to a finer one",
              .yLabel = "switches"};
  panel.yMax = axisTop(data.highest("switches_coarser", frames), 1.1);
  panel.yMin = -axisTop(data.highest("switches_finer", frames), 1.1);
  for (std::size_t world = 0; world < data.worlds(); ++world) {
    const std::string look = coloured("impulses linewidth 1.2", worldColor(world));
    panel.curves.push_back(curveOf(world, "switches_coarser", look, worldTitle(data, world)));
    Curve finer = curveOf(world, "switches_finer", look, {});
    finer.plot = quoted(FigureData::fileOf(world)) + " using 1:(-$" +
                 std::to_string(FigureData::columnOf("switches_finer")) + ")";
    panel.curves.push_back(std::move(finer));
  }
  panel.curves.push_back({.plot = "0", .style = coloured("lines linewidth 0.8", color::kGrey), .title = {}});
  return panel;
}

Panel stagesPanel(const FigureData& data, std::size_t world, const FrameRange& frames) {
  const double highest = stagesTop(data, frames);
  Panel panel{.title = {}, .yLabel = "wall time (ms)"};
  panel.yMax = axisTop(budgetInRange(data, highest) ? std::max(highest, data.options().budgetMs) : highest);
  panel.title = stagesTitle(data, world, frames, panel.yMax);
  // From the top of the stack down: each area hides the lower part of the one before it.
  for (std::size_t stage = kStageCount; stage-- > 0;) {
    panel.curves.push_back({.plot = quoted(FigureData::fileOf(world)) +
                                    " using 1:" + std::to_string(FigureData::stackColumn(stage + 1)),
                            .style = "filledcurves x1 fillstyle solid noborder fillcolor rgb " +
                                     quoted(kStageLooks[stage].color),
                            .title = kStageLooks[stage].name});
  }
  panel.curves.push_back(
      curveOf(world, "physics_ms", coloured("lines linewidth 1", color::kBlack), "total physics"));
  if (Curve budget = budgetLine(data, highest); !budget.plot.empty()) {
    panel.curves.push_back(std::move(budget));
  }
  return panel;
}

}  // namespace scatter::lab
