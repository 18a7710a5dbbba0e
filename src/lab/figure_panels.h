#pragma once

#include "lab/figure_script.h"

#include <scatter/world/step_report.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace scatter::lab {

/// The colour of a world's curves, the same in every figure.
[[nodiscard]] const char* worldColor(std::size_t world);

/// How a stage is called and coloured in every figure.
/// @{
[[nodiscard]] const char* stageName(Stage stage);
[[nodiscard]] const char* stageColor(Stage stage);
/// @}

[[nodiscard]] std::string coloured(const std::string& look, const char* rgb);

/// A column of a world's data; `axes` as gnuplot has them, such as "x1y2".
[[nodiscard]] Curve curveOf(std::size_t world, std::string_view column, std::string style, std::string title,
                            const std::string& axes = {});

/// Room above the highest value; gnuplot refuses an empty range.
[[nodiscard]] double axisTop(double highest, double room = 1.06);

[[nodiscard]] std::string worldTitle(const FigureData& data, std::size_t world);

/// Whether the budget of a frame is near enough to `highest` to be drawn beside it.
[[nodiscard]] bool budgetInRange(const FigureData& data, double highest);

/// Nothing is plotted where the budget is not in range.
[[nodiscard]] Curve budgetLine(const FigureData& data, double highest);

/// One world's manifolds, and its narrowphase pairs on the second axis.
[[nodiscard]] Panel manifoldsPanel(const FigureData& data, std::size_t world, const FrameRange& frames);

/// A column of every world.
[[nodiscard]] Panel worldsPanel(const FigureData& data, const FrameRange& frames, std::string_view column,
                                std::string title, std::string yLabel);

/// Switches of every world: up to a coarser level, down to a finer one.
[[nodiscard]] Panel switchesPanel(const FigureData& data, const FrameRange& frames);

/// The stages of one world's steps, stacked.
[[nodiscard]] Panel stagesPanel(const FigureData& data, std::size_t world, const FrameRange& frames);

}  // namespace scatter::lab
