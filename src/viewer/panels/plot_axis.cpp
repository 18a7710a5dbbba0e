#include "viewer/panels/plot_axis.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace scatter::viewer {
namespace {

constexpr float kDwarfed = 4.0F;  // times the peak of another line
constexpr float kHeadroom = 1.15F;
constexpr float kLogHeadroom = 1.6F;
constexpr float kMostDecades = 4.0F;
constexpr float kOftenAbove = 0.1F;  // share of the values that may be below the axis

/// What most values of a line are above; 0 if none are above 0.
float usualLow(const std::vector<float>& line) {
  std::vector<float> positive;
  std::copy_if(line.begin(), line.end(), std::back_inserter(positive),
               [](float value) { return value > 0.0F; });
  if (positive.empty()) return 0.0F;
  const auto at = static_cast<std::ptrdiff_t>(kOftenAbove * static_cast<float>(positive.size()));
  std::nth_element(positive.begin(), positive.begin() + at, positive.end());
  return positive[static_cast<std::size_t>(at)];
}

}  // namespace

float PlotAxis::shareOf(float value) const {
  if (!logarithmic) return (value - low) / (high - low);
  return std::log(std::max(value, low) / low) / std::log(high / low);
}

std::vector<float> PlotAxis::marks() const {
  std::vector<float> marks;
  if (!logarithmic) return marks;
  for (const float step : {1.0F, 2.0F, 5.0F}) {
    for (float ten = std::pow(10.0F, std::floor(std::log10(low))); ten < high; ten *= 10.0F) {
      if (step * ten >= low && step * ten <= high) marks.push_back(step * ten);
    }
  }
  return marks;
}

PlotAxis chooseAxis(std::span<const std::vector<float>> lines, float limit) {
  float highest = 0.0F;
  float lowestPeak = 0.0F;
  float low = 0.0F;
  for (const std::vector<float>& line : lines) {
    const float peak = line.empty() ? 0.0F : *std::max_element(line.begin(), line.end());
    highest = std::max(highest, peak);
    // A line that is nowhere above 0 cannot be dwarfed.
    if (!(peak > 0.0F)) continue;
    lowestPeak = lowestPeak > 0.0F ? std::min(lowestPeak, peak) : peak;
    const float usual = usualLow(line);
    low = low > 0.0F ? std::min(low, usual) : usual;
  }
  const float top = std::max(highest, limit);
  if (!(lowestPeak > 0.0F) || highest < kDwarfed * lowestPeak) {
    return {0.0F, top > 0.0F ? kHeadroom * top : 1.0F, false};
  }
  const float least = top * std::pow(10.0F, -kMostDecades);
  return {0.7F * std::max(low, least), kLogHeadroom * top, true};
}

}  // namespace scatter::viewer
