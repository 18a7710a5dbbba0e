#pragma once

#include <scatter/lab/figures.h>
#include <scatter/result.h>

#include <filesystem>
#include <functional>
#include <vector>

#include "lab/figure_data.h"
#include "lab/figure_script.h"

namespace scatter::lab {

/// Draws NAME.svg and NAME.png in `folder`, where the figure's data are. Fails with gnuplot's own words, and
/// if it draws nothing.
[[nodiscard]] Result<void> drawFigure(const FigureScript& figure, const std::filesystem::path& folder);

/// Draws what `list` makes of the worlds into the folder of the options, all or nothing. Fails on a world
/// without frames and as drawFigure() does.
[[nodiscard]] Result<std::vector<Figure>> drawFigureSet(
    const std::vector<FigureWorld>& worlds, const FigureOptions& options,
    const std::function<std::vector<FigureScript>(const FigureData&)>& list);

}  // namespace scatter::lab
