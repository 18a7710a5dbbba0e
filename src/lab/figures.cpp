#include <scatter/io/file.h>
#include <scatter/lab/figures.h>

#include <scatter/lab/output_folder.h>

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

Result<void> draw(const lab::FigureScript& figure, const fs::path& folder) {
  const fs::path script = folder / (figure.name + ".gnuplot");
  if (auto written = writeFile(script, lab::gnuplotScript(figure)); !written) {
    return written;
  }
  // -d: whatever the user's own gnuplot settings are.
  if (auto drawn = lab::runGnuplot({"-d", script.filename().string()}, folder); !drawn) {
    return drawn;
  }
  std::error_code error;
  for (const char* ending : {".svg", ".png"}) {
    const auto bytes = fs::file_size(folder / (figure.name + ending), error);
    if (error || bytes == 0) {
      return fail("gnuplot drew nothing into " + figure.name + ending +
                  "; see that the disk is not full and that gnuplot has its svg and pngcairo terminals");
    }
  }
  fs::remove(script, error);
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
    if (auto drawn = draw(figure, staged->path()); !drawn) {
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
