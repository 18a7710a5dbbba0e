#include "lab/figure_drawing.h"

#include <scatter/io/file.h>
#include <scatter/lab/output_folder.h>

#include "lab/gnuplot.h"

#include <system_error>

namespace scatter::lab {

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

Result<void> drawFigure(const FigureScript& figure, const std::filesystem::path& folder) {
  const std::filesystem::path script = folder / (figure.name + ".gnuplot");
  if (auto written = writeFile(script, gnuplotScript(figure)); !written) {
    return written;
  }
  // -d: whatever the user's own gnuplot settings are.
  if (auto drawn = runGnuplot({"-d", script.filename().string()}, folder); !drawn) {
    return drawn;
  }
  std::error_code error;
  for (const char* ending : {".svg", ".png"}) {
    const auto bytes = std::filesystem::file_size(folder / (figure.name + ending), error);
    if (error || bytes == 0) {
      return fail("gnuplot drew nothing into " + figure.name + ending +
                  "; see that the disk is not full and that gnuplot has its svg and pngcairo terminals");
    }
  }
  std::filesystem::remove(script, error);
  return {};
}

Result<std::vector<Figure>> drawFigureSet(
    const std::vector<FigureWorld>& worlds, const FigureOptions& options,
    const std::function<std::vector<FigureScript>(const FigureData&)>& list) {
  if (auto checked = requireFrames(worlds); !checked) {
    return tl::unexpected(checked.error());
  }
  auto staged = StagedFolder::create(options.folder);
  if (!staged) {
    return tl::unexpected(staged.error());
  }
  const FigureData data(worlds, options);
  if (auto written = data.write(staged->path()); !written) {
    return tl::unexpected(written.error());
  }
  std::vector<Figure> figures;
  for (const FigureScript& figure : list(data)) {
    if (auto drawn = drawFigure(figure, staged->path()); !drawn) {
      return tl::unexpected(drawn.error());
    }
    figures.push_back({.name = figure.name, .title = figure.title, .caption = figure.caption});
  }
  std::error_code ignored;
  for (std::size_t world = 0; world < data.worlds(); ++world) {
    std::filesystem::remove(staged->path() / FigureData::fileOf(world), ignored);
  }
  if (auto committed = staged->commit(); !committed) {
    return tl::unexpected(committed.error());
  }
  return figures;
}

}  // namespace scatter::lab
