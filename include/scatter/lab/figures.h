#pragma once

#include <scatter/lab/frame_table.h>
#include <scatter/result.h>

#include <filesystem>
#include <string>
#include <vector>

namespace scatter {

/// A world as figures show it.
struct FigureWorld {
  std::string label;
  const FrameTable* table = nullptr;  ///< With the recorder's columns; not owned.
  double governedMs = 0.0;            ///< The time that its physics is governed to; 0 if it is not.
};

struct FigureOptions {
  std::string scene;
  double budgetMs = 1000.0 / 60.0;
  std::filesystem::path folder;  ///< Where the pictures go; must exist.
  int repeats = 1;               ///< Of which the times are medians, frame by frame.
};

/// One picture, as NAME.svg and NAME.png in the folder.
struct Figure {
  std::string name;     ///< Such as "stages_peak".
  std::string title;    ///< What it shows, in a few words.
  std::string caption;  ///< What a reader who knows nothing of the program should see in it.
};

/// Fails, naming the package that has it, if the gnuplot program cannot be run.
[[nodiscard]] Result<void> checkGnuplot();

/// Draws the report's Figures 5.5 to 5.11 for these worlds, one or more, on the same axes, and an overview.
/// "The peak" is that of the first world's physics_cpu_ms. Nothing is smoothed. Fails without gnuplot, on
/// a run without frames and on what gnuplot complains about.
[[nodiscard]] Result<std::vector<Figure>> drawFigures(const std::vector<FigureWorld>& worlds,
                                                      const FigureOptions& options);

}  // namespace scatter
