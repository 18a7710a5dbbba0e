#pragma once

#include <imgui.h>

#include <string>
#include <vector>

namespace scatter::viewer {

/// A line of a plot.
struct PlotLine {
  std::string name{};
  ImU32 color = 0;
  std::vector<float> values{};  ///< One a frame, the oldest first.
};

struct PlotDef {
  std::string title{};
  std::string unit{};             ///< Such as "ms"; empty for a count.
  std::vector<PlotLine> lines{};  ///< The first one's peak is marked.
  bool stacked = false;           ///< Lines are layers, each on top of those before.
  float limit = 0.0F;             ///< A horizontal line, such as a budget; 0: none.
  float height = 62.0F;           ///< Pixels in a window of 1280 x 720.
};

/// As wide as the panel, from 0 to the largest value, with its peak marked and the newest values written
/// beside the names. Where one line dwarfs another, on a logarithmic scale, which the title says. Says the
/// values under the pointer. `scale`: that of the panels.
void drawPlot(const PlotDef& plot, float scale);

}  // namespace scatter::viewer
