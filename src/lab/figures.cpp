#include <scatter/io/file.h>
#include <scatter/lab/figures.h>

#include <scatter/lab/output_folder.h>

#include "lab/figure_drawing.h"
#include "lab/figure_list.h"
#include "lab/gnuplot.h"

#include <filesystem>
#include <system_error>

namespace scatter {

namespace fs = std::filesystem;

namespace {

Result<void> requireFrames(const std::vector<FigureWorld>& worlds) {
  if (worlds.empty()) {
    return fail("there is no world to draw figures of; give at least one");
  }
  for (const FigureWorld& world : worlds) {
    if (world.table == nullptr || world.table->frames() == 0) {
      return fail("the " + world.label + " world has no frames to draw; run at least one");
    }
  }
  return {};
}

}  // namespace

Result<void> checkGnuplot() {
  return lab::runGnuplot({"--version"}, fs::path("/"));
}

Result<std::vector<Figure>> drawFigures(const std::vector<FigureWorld>& worlds,
                                        const FigureOptions& options) {
  if (auto checked = requireFrames(worlds); !checked) {
    return tl::unexpected(checked.error());
  }
  auto staged = StagedFolder::create(options.folder);
  if (!staged) {
    return tl::unexpected(staged.error());
  }
  const lab::FigureData data(worlds, options);
  if (auto written = data.write(staged->path()); !written) {
    return tl::unexpected(written.error());
  }
  std::vector<Figure> figures;
  for (const lab::FigureScript& figure : lab::figureList(data)) {
    if (auto drawn = lab::drawFigure(figure, staged->path()); !drawn) {
      return tl::unexpected(drawn.error());
    }
    figures.push_back({.name = figure.name, .title = figure.title, .caption = figure.caption});
  }
  std::error_code ignored;
  for (std::size_t world = 0; world < data.worlds(); ++world) {
    fs::remove(staged->path() / lab::FigureData::fileOf(world), ignored);
  }
  if (auto committed = staged->commit(); !committed) {
    return tl::unexpected(committed.error());
  }
  return figures;
}

}  // namespace scatter
