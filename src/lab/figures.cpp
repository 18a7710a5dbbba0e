#include <scatter/lab/figures.h>

#include "lab/figure_drawing.h"
#include "lab/figure_list.h"
#include "lab/gnuplot.h"

#include <filesystem>

namespace scatter {

Result<void> checkGnuplot() {
  return lab::runGnuplot({"--version"}, std::filesystem::path("/"));
}

Result<std::vector<Figure>> drawFigures(const std::vector<FigureWorld>& worlds,
                                        const FigureOptions& options) {
  return lab::drawFigureSet(worlds, options, lab::figureList);
}

}  // namespace scatter
