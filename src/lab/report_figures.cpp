#include <scatter/lab/report_test.h>

#include <algorithm>
#include <utility>

#include "lab/figure_drawing.h"
#include "lab/figure_panels.h"
#include "lab/report_meetings.h"
#include "lab/run_files.h"

namespace scatter {

namespace {

using lab::FigureData;
using lab::FigureScript;
using lab::FrameRange;
using lab::Panel;

constexpr double kAroundCollision = 20.0;

template <class MakePanel>
std::vector<Panel> aPanelEach(const FigureData& data, const FrameRange& frames, const MakePanel& make) {
  std::vector<Panel> panels;
  for (std::size_t world = 0; world < data.worlds(); ++world) {
    panels.push_back(make(data, world, frames));
  }
  return panels;
}

// From before the bounds overlap until after they have parted, in all tests.
FrameRange collisionOf(const std::vector<const ReportTest*>& tests) {
  FrameRange frames{.first = 1e9, .last = 1.0};
  for (const ReportTest* test : tests) {
    const auto meetings = lab::findMeetings(lab::ReportRun(test->run, {}));
    const auto all = static_cast<double>(test->run.table.frames());
    const auto first = static_cast<double>(meetings.overlap.value_or(1));
    const auto last = meetings.apart ? static_cast<double>(*meetings.apart) : all;
    frames.first = std::max(0.0, std::min(frames.first, first - kAroundCollision));
    frames.last = std::min(all, std::max(frames.last, last + kAroundCollision));
  }
  return frames;
}

// Around the first test's peak of the impact, as the report has it.
FrameRange impactOf(const std::vector<const ReportTest*>& tests) {
  const auto impact = lab::findImpact(lab::ReportRun(tests.front()->run, {}));
  const auto first = static_cast<double>(impact.overlap.value_or(1));
  return {.first = std::max(0.0, first - kAroundCollision), .last = static_cast<double>(impact.end)};
}

Panel crowdPanel(const FigureData& data, std::size_t world, const FrameRange& frames) {
  Panel panel = lab::manifoldsPanel(data, world, frames);
  panel.curves.push_back(lab::curveOf(world, "pairs_with_hybrid",
                                      lab::coloured("lines linewidth 1.2", lab::color::kSkyBlue),
                                      "pairs with a hybrid", "x1y2"));
  panel.curves.push_back(lab::curveOf(world, "pairs_without_hybrid",
                                      lab::coloured("lines linewidth 1.2", lab::color::kOrange),
                                      "pairs without a hybrid", "x1y2"));
  return panel;
}

FigureScript manifoldFigure(const FigureData& data, const std::string& number, const FrameRange& frames,
                            bool detail) {
  return {.name = "fig-5-0" + number,
          .title = "Figure 5." + number + ", Scene 1" + (detail ? ", detail" : "") +
                   ": manifolds and narrowphase pairs",
          .caption =
              "Manifolds and narrowphase pairs of the two ships, in the default build and, below, the "
              "hybrid build.",
          .frames = frames,
          .panels = aPanelEach(data, frames, lab::manifoldsPanel)};
}

std::vector<FigureScript> twoShipsFigures(const FigureData& data, const FrameRange& collision) {
  return {manifoldFigure(data, "5", data.allFrames(), false), manifoldFigure(data, "6", collision, true)};
}

FigureScript objectsFigure(const FigureData& data) {
  const FrameRange all = data.allFrames();
  return {
      .name = "fig-5-08",
      .title = "Figure 5.8, Scene 2: objects and contact points",
      .caption = "Objects and contact points in both builds. Here a try adds no object: the lines coincide.",
      .frames = all,
      .panels = {lab::worldsPanel(data, all, "objects", "Objects", "objects"),
                 lab::worldsPanel(data, all, "contacts", "Contact points", "contact points")}};
}

// The report reads attempts and switches from the number of objects; here they are counted.
FigureScript attemptsFigure(const FigureData& data, const FrameRange& impact) {
  return {.name = "fig-5-09",
          .title = "Figure 5.9, Scene 2, detail: objects, waiting requests and switches",
          .caption = "What the report reads from the number of objects: requests that wait, and switches.",
          .frames = impact,
          .panels = {lab::worldsPanel(data, impact, "objects", "Objects", "objects"),
                     lab::worldsPanel(data, impact, "requests", "Requests that wait", "requests"),
                     lab::switchesPanel(data, impact)},
          .panelHeight = 170.0};
}

FigureScript profileFigure(const FigureData& data, const std::string& number, const FrameRange& frames,
                           bool detail) {
  return {.name = "fig-5-" + number,
          .title = "Figure 5." + number + ", Scene 2" + (detail ? ", detail" : "") +
                   ": where the physics spends its time",
          .caption = "The stages of each physics step, stacked; the black line is the whole step.",
          .frames = frames,
          .panels = aPanelEach(data, frames, lab::stagesPanel),
          .panelHeight = 290.0};
}

std::vector<FigureScript> crowdFigures(const FigureData& data, const FrameRange& impact) {
  const FrameRange all = data.allFrames();
  FigureScript manifolds{.name = "fig-5-07",
                         .title = "Figure 5.7, Scene 2: manifolds and narrowphase pairs",
                         .caption = "Manifolds, and narrowphase pairs with and without a hybrid.",
                         .frames = all,
                         .panels = aPanelEach(data, all, crowdPanel)};
  return {std::move(manifolds), objectsFigure(data), attemptsFigure(data, impact),
          profileFigure(data, "10", all, false), profileFigure(data, "11", impact, true)};
}

}  // namespace

Result<std::vector<Figure>> drawReportFigures(const std::vector<const ReportTest*>& tests,
                                              const std::filesystem::path& folder) {
  if (tests.empty()) {
    return fail("there is no report test to draw figures of; give at least one");
  }
  std::vector<FigureWorld> worlds;
  for (const ReportTest* test : tests) {
    worlds.push_back(lab::figureWorld(test->run.options, test->run.table));
  }
  const RunOptions& options = tests.front()->run.options;
  const FigureOptions figures{.scene = options.scene, .budgetMs = options.budgetMs, .folder = folder};
  const bool twoShips = tests.front()->number <= 2;
  return lab::drawFigureSet(worlds, figures, [&](const FigureData& data) {
    return twoShips ? twoShipsFigures(data, collisionOf(tests)) : crowdFigures(data, impactOf(tests));
  });
}

}  // namespace scatter
