#pragma once

#include <scatter/lab/figures.h>
#include <scatter/lab/world_figures.h>

#include <filesystem>
#include <vector>

namespace scatter {

/// Draws fidelity against budget, as fidelity_budget.svg and .png in the folder, which must exist: the share
/// of touching pairs at their finest level, visible overlaps and contact gaps of all worlds that are governed
/// to a time. Fails without such a world with fidelity, without gnuplot and on what gnuplot complains about.
[[nodiscard]] Result<Figure> drawFidelity(const std::vector<WorldFigures>& worlds,
                                          const std::filesystem::path& folder);

}  // namespace scatter
