#pragma once

#include <scatter/result.h>

#include <filesystem>

#include "lab/figure_script.h"

namespace scatter::lab {

/// Draws NAME.svg and NAME.png in `folder`, where the figure's data are. Fails with gnuplot's own words, and
/// if it draws nothing.
[[nodiscard]] Result<void> drawFigure(const FigureScript& figure, const std::filesystem::path& folder);

}  // namespace scatter::lab
