#include "lab/figure_list.h"

#include "lab/figure_panels.h"
#include "lab/text.h"

#include <algorithm>
#include <utility>

namespace scatter::lab {

namespace {

constexpr double kRangeOfBudgets = 1.5;

bool isGoverned(const FigureData& data) {
  for (std::size_t world = 0; world < data.worlds(); ++world) {
    if (data.governedMs(world) > 0.0) {
      return true;
    }
  }
  return false;
}

// A line for each world that is governed to a time, in the world's colour. One that is far above all frames
// must not press them flat.
void addGovernedLines(const FigureData& data, double highest, Panel& panel) {
  for (std::size_t world = 0; world < data.worlds(); ++world) {
    const double budget = data.governedMs(world);
    if (budget <= 0.0) {
      continue;
    }
    const bool inRange = budget <= kRangeOfBudgets * highest;
    panel.yMax = std::max(panel.yMax, inRange ? axisTop(budget) : 0.0);
    panel.curves.push_back(
        {.plot = shortestNumber(budget),
         .style = coloured("lines linewidth 1.4 dashtype (6,4)", worldColor(world)),
         .title = "its budget " + readableNumber(budget) + (inRange ? " ms" : " ms (above)")});
  }
}

std::string peakSentence(const FigureData& data, std::string_view column, const std::string& unit) {
  std::string text;
  for (std::size_t world = 0; world < data.worlds(); ++world) {
    const FramePeak peak = data.peak(world, column);
    text += (world == 0 ? "" : ", ") + data.label(world) + ' ' + readableNumber(peak.value) + unit +
            " (frame " + fixedNumber(peak.frame, 0) + ")";
  }
  return text;
}

// A ring; its value stands in the legend, where no two can cover each other.
std::string peakMark(const FigureData& data, std::size_t world) {
  const FramePeak peak = data.peak(world, "physics_cpu_ms");
  return "set label " + std::to_string(10 + world) + " '' at " + shortestNumber(peak.frame) + ',' +
         shortestNumber(peak.value) + " point pointtype 6 pointsize 1.2 linewidth 1.6 linecolor rgb " +
         quoted(worldColor(world)) + " front";
}

std::string peakTitle(const FigureData& data, std::size_t world) {
  return data.label(world) + ": peak " + readableNumber(data.peak(world, "physics_cpu_ms").value) + " ms";
}

// Why the peaks are not those of the table, which are of single runs.
std::string repeatsSentence(const FigureData& data) {
  const int repeats = data.options().repeats;
  return repeats == 1 ? std::string()
                      : " Every frame's time is its median over " + std::to_string(repeats) +
                            " repeats, so that the peaks are not those of single runs, as in the table.";
}

FigureScript overview(const FigureData& data) {
  const double highest = data.highest("physics_cpu_ms", data.allFrames());
  Panel panel{
      .title = data.options().repeats == 1
                   ? "Processor time of the physics, frame by frame: lower is better"
                   : "Processor time of the physics, each frame's median over the repeats: lower is better",
      .yLabel = "physics CPU time (ms)"};
  panel.yMax = axisTop(budgetInRange(data, highest) ? std::max(highest, data.options().budgetMs) : highest);
  for (std::size_t world = 0; world < data.worlds(); ++world) {
    panel.curves.push_back(curveOf(
        world, "physics_cpu_ms", coloured("lines linewidth 1.5", worldColor(world)), peakTitle(data, world)));
    panel.extra.push_back(peakMark(data, world));
  }
  addGovernedLines(data, highest, panel);
  // Worlds with a budget of their own are not judged by another one.
  if (Curve budget = budgetLine(data, highest); !budget.plot.empty() && !isGoverned(data)) {
    panel.curves.push_back(std::move(budget));
  }
  return {
      .name = "overview",
      .title = "Scene " + data.options().scene + ": what each frame's physics costs",
      .caption =
          "How long the processor worked on the physics of each frame. A frame that takes longer than the "
          "budget (dashed, where it is in range) cannot be shown in time. Peaks: " +
          peakSentence(data, "physics_cpu_ms", " ms") + "." + repeatsSentence(data),
      .frames = data.allFrames(),
      .panels = {std::move(panel)},
      .panelHeight = 360.0};
}

FigureScript manifoldsAndPairs(const FigureData& data, bool aroundPeak) {
  const FrameRange frames = aroundPeak ? data.peakFrames() : data.allFrames();
  FigureScript figure{.name = aroundPeak ? "manifolds_pairs_peak" : "manifolds_pairs",
                      .title = "Scene " + data.options().scene + ": manifolds and narrowphase pairs" +
                               (aroundPeak ? " around the peak" : ""),
                      .caption = {},
                      .frames = frames,
                      .panels = {}};
  for (std::size_t world = 0; world < data.worlds(); ++world) {
    figure.panels.push_back(manifoldsPanel(data, world, frames));
  }
  figure.caption =
      aroundPeak ? "The same counts around the most expensive frame of the " + data.label(0) +
                       " world (frame " + fixedNumber(data.peak(0, "physics_cpu_ms").frame, 0) +
                       "). A world that has switched to coarser shapes by then has fewer manifolds for as "
                       "many pairs."
                 : "A narrowphase pair is two objects close enough to be tested in detail; a manifold is "
                   "the record of one tested pair of their parts. Detailed objects make many manifolds from "
                   "few pairs: that is the overload. Peak manifolds: " +
                       peakSentence(data, "manifolds", "") + ". The panels have the same axes.";
  return figure;
}

FigureScript hybridPairs(const FigureData& data) {
  const FrameRange frames = data.allFrames();
  FigureScript figure{.name = "hybrid_pairs",
                      .title = "Scene " + data.options().scene + ": pairs with and without a hybrid",
                      .caption =
                          "Of the pairs tested in detail, those in which at least one object is a hybrid (an "
                          "object with several levels of detail) and those in which none is. Only the first "
                          "kind can be made cheaper by switching levels.",
                      .frames = frames,
                      .panels = {}};
  const double highest =
      std::max(data.highest("pairs_with_hybrid", frames), data.highest("pairs_without_hybrid", frames));
  for (std::size_t world = 0; world < data.worlds(); ++world) {
    Panel panel{.title = worldTitle(data, world), .yLabel = "narrowphase pairs"};
    panel.yMax = axisTop(highest);
    panel.curves = {
        curveOf(world, "pairs_with_hybrid", coloured("lines linewidth 1.5", color::kBlue), "with a hybrid"),
        curveOf(world, "pairs_without_hybrid", coloured("lines linewidth 1.5", color::kOrange),
                "without a hybrid")};
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

FigureScript objectsAndContacts(const FigureData& data) {
  const FrameRange all = data.allFrames();
  return {.name = "objects_contacts",
          .title = "Scene " + data.options().scene + ": contact points and objects",
          .caption =
              "Top: the points at which objects touch; a sharp rise is a collision of many objects at once. "
              "Bottom: the objects in each world. Switching adds none, so the lines should coincide. Peak "
              "contacts: " +
              peakSentence(data, "contacts", "") + ".",
          .frames = all,
          .panels = {worldsPanel(data, all, "contacts", "Contact points", "contact points"),
                     worldsPanel(data, all, "objects", "Objects", "objects")},
          .panelHeight = 200.0};
}

FigureScript switching(const FigureData& data) {
  const FrameRange all = data.allFrames();
  return {.name = "switching",
          .title = "Scene " + data.options().scene + ": levels of detail, requests and switches",
          .caption =
              "Top: pairs tested with both objects in full detail, the expensive kind. Middle: requests to "
              "change a level that could not be met yet, because something was in the way. Bottom: the "
              "changes made. A standard world has no requests and no switches.",
          .frames = all,
          .panels = {worldsPanel(data, all, "finest_pairs", "Pairs tested at the finest level", "pairs"),
                     worldsPanel(data, all, "requests", "Standing requests", "requests"),
                     switchesPanel(data, all)},
          .panelHeight = 170.0};
}

FigureScript stages(const FigureData& data, bool aroundPeak) {
  const FrameRange frames = aroundPeak ? data.peakFrames() : data.allFrames();
  FigureScript figure{
      .name = aroundPeak ? "stages_peak" : "stages",
      .title = "Scene " + data.options().scene + ": where the physics spends its time" +
               (aroundPeak ? ", around the peak" : ""),
      .caption = aroundPeak ? "The same profile around the most expensive frame of the " + data.label(0) +
                                  " world. The stage whose area grows is the one that is overloaded."
                            : "The stages of each physics step, stacked: the height of a colour is the time "
                              "its stage took in that frame, the black line is the whole step. The panels "
                              "have the same axes, so that areas can be compared.",
      .frames = frames,
      .panels = {},
      .panelHeight = 290.0};
  for (std::size_t world = 0; world < data.worlds(); ++world) {
    figure.panels.push_back(stagesPanel(data, world, frames));
  }
  return figure;
}

}  // namespace

std::vector<FigureScript> figureList(const FigureData& data) {
  return {overview(data),
          manifoldsAndPairs(data, false),
          manifoldsAndPairs(data, true),
          hybridPairs(data),
          objectsAndContacts(data),
          switching(data),
          stages(data, false),
          stages(data, true)};
}

}  // namespace scatter::lab
