#pragma once

#include <imgui.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace scatter::viewer {

/// A line of a plot.
struct PlotLine {
  std::string name{};  ///< Empty: the plot's title says it.
  ImU32 color = 0;
  std::vector<float> values{};  ///< One a frame, the oldest first.
};

/// Of a plot: how many values there are in all, of which lines may have the first only, and
/// which of them is that of the moment that is shown. A value stands for so many frames, from the number of
/// the first one on.
struct PlotTime {
  std::size_t values = 0;
  std::size_t now = 0;
  std::uint64_t firstFrame = 0;
  std::uint64_t framesEach = 1;
};

struct PlotDef {
  std::string title{};
  std::string unit{};             ///< Such as "ms"; empty for a count.
  std::vector<PlotLine> lines{};  ///< The first one's peak is marked.
  bool stacked = false;           ///< Lines are layers, each on top of those before.
  float limit = 0.0F;             ///< A horizontal line, such as a budget; 0: none.
  float height = 62.0F;           ///< Pixels in a window of 1280 x 720.
  PlotTime time{};
};

/// As wide as the panel, from 0 to the largest value, with its peak marked and the values of now written
/// beside the names. Where one line dwarfs another, on a logarithmic scale, which the title says. Says the
/// values under the pointer. `scale`: that of the panels. Returns the value at which the pointer is held
/// down.
std::optional<std::size_t> drawPlot(const PlotDef& plot, float scale);

}  // namespace scatter::viewer
