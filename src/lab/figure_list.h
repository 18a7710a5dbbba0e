#pragma once

#include "lab/figure_script.h"

#include <vector>

namespace scatter::lab {

/// The figures of a comparison, the overview first (report, Figures 5.5 to 5.11).
[[nodiscard]] std::vector<FigureScript> figureList(const FigureData& data);

}  // namespace scatter::lab
