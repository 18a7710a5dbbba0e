#pragma once

#include <span>
#include <vector>

namespace scatter::viewer {

/// The values that a plot has room for, and how they are spread over its height.
struct PlotAxis {
  float low = 0.0F;
  float high = 1.0F;
  bool logarithmic = false;

  /// Where a value is, 0 at the bottom and 1 at the top; what is lower than all is at the bottom.
  [[nodiscard]] float shareOf(float value) const;

  /// Values worth a line across the plot, if there is room, the most welcome first: of a logarithmic axis
  /// powers of ten, then their doubles, then their halves; else none.
  [[nodiscard]] std::vector<float> marks() const;
};

/// From 0 to above the largest value, and to `limit` if there is one. If one line's peak is several times
/// another's, on which both would not be read, logarithmic.
[[nodiscard]] PlotAxis chooseAxis(std::span<const std::vector<float>> lines, float limit);

}  // namespace scatter::viewer
