#include <scatter/lab/fidelity_study.h>

#include <scatter/io/file.h>
#include <scatter/lab/output_folder.h>

#include "lab/figure_drawing.h"
#include "lab/text.h"

#include <algorithm>
#include <system_error>

namespace scatter {

namespace {

constexpr const char* kData = "fidelity.dat";

// Of gnuplot, in the data file.
enum Column { kBudget = 1, kMean, kWorst, kOverlaps, kGap };

std::vector<WorldFigures> governedByTime(const std::vector<WorldFigures>& worlds) {
  std::vector<WorldFigures> governed;
  std::copy_if(worlds.begin(), worlds.end(), std::back_inserter(governed),
               [](const WorldFigures& world) { return world.governedMs > 0.0 && world.hasFidelity; });
  std::sort(governed.begin(), governed.end(),
            [](const WorldFigures& a, const WorldFigures& b) { return a.governedMs < b.governedMs; });
  return governed;
}

std::string dataOf(const std::vector<WorldFigures>& worlds) {
  std::string text;
  for (const WorldFigures& world : worlds) {
    for (const double value :
         {world.governedMs, 100.0 * world.finestShareMean, 100.0 * world.finestShareWorst,
          world.visibleOverlapPer100, world.contactGapP95Percent}) {
      text += lab::shortestNumber(value) + ' ';
    }
    text.back() = '\n';
  }
  return text;
}

lab::Curve curveOf(Column column, const char* rgb, const char* title) {
  return {.plot = lab::quoted(kData) + " using " + std::to_string(kBudget) + ':' + std::to_string(column),
          .style = "linespoints linewidth 2 pointtype 7 pointsize 0.7 linecolor rgb " + lab::quoted(rgb),
          .title = title};
}

// Room above the highest value; gnuplot refuses an empty range.
double topOf(const std::vector<WorldFigures>& worlds, double WorldFigures::*value) {
  double highest = 0.0;
  for (const WorldFigures& world : worlds) {
    highest = std::max(highest, world.*value);
  }
  return highest > 0.0 ? 1.1 * highest : 1.0;
}

lab::FigureScript scriptOf(const std::vector<WorldFigures>& worlds) {
  lab::Panel shares{.title = "Touching pairs at their finest level: higher is better", .yLabel = "share (%)"};
  shares.yMax = 105.0;
  shares.curves = {curveOf(kMean, lab::color::kBlue, "mean of the frames"),
                   curveOf(kWorst, lab::color::kVermillion, "worst frame")};
  lab::Panel overlaps{.title = "Pairs that are seen overlapping by more than 5 cm: lower is better",
                      .yLabel = "per 100 touching"};
  overlaps.yMax = topOf(worlds, &WorldFigures::visibleOverlapPer100);
  overlaps.curves = {curveOf(kOverlaps, lab::color::kPurple, "visible overlaps")};
  lab::Panel gaps{.title = "Gap between the finest shapes of pairs that touch coarsely: lower is better",
                  .yLabel = "% of the length"};
  gaps.yMax = topOf(worlds, &WorldFigures::contactGapP95Percent);
  gaps.curves = {curveOf(kGap, lab::color::kGreen, "95 % are smaller")};
  return {.name = "fidelity_budget",
          .title = "Scene " + worlds.front().scene + ": fidelity against budget",
          .caption = "What a budget for the physics of a frame leaves of the detail. Medians of " +
                     std::to_string(worlds.front().repeats) + " runs of " +
                     std::to_string(worlds.front().frames) + " frames at each budget.",
          .frames = {.first = 0.0, .last = 1.05 * worlds.back().governedMs},
          .panels = {std::move(shares), std::move(overlaps), std::move(gaps)},
          .panelHeight = 190.0,
          .xLabel = "budget (milliseconds of processor time a frame)"};
}

}  // namespace

Result<Figure> drawFidelity(const std::vector<WorldFigures>& worlds, const std::filesystem::path& folder) {
  const std::vector<WorldFigures> governed = governedByTime(worlds);
  if (governed.empty()) {
    return fail("no world was governed to a time and measured for fidelity; give at least one budget");
  }
  auto staged = StagedFolder::create(folder);
  if (!staged) {
    return tl::unexpected(staged.error());
  }
  if (auto written = writeFile(staged->path() / kData, dataOf(governed)); !written) {
    return tl::unexpected(written.error());
  }
  const lab::FigureScript script = scriptOf(governed);
  if (auto drawn = lab::drawFigure(script, staged->path()); !drawn) {
    return tl::unexpected(drawn.error());
  }
  std::error_code ignored;
  std::filesystem::remove(staged->path() / kData, ignored);
  if (auto committed = staged->commit(); !committed) {
    return tl::unexpected(committed.error());
  }
  return Figure{.name = script.name, .title = script.title, .caption = script.caption};
}

}  // namespace scatter
