#pragma once

#include <scatter/world/step_report.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/panels/plot.h"

namespace scatter::viewer {

/// The values of a channel of the frame data, one a frame; empty if there is none of that name.
using ChannelValues = std::function<std::vector<float>(std::string_view channel)>;

/// "collision detection" of "collision_detection_ms".
[[nodiscard]] std::string stageName(Stage stage);

/// Of one world, whose label is empty where there is no other: what the stages of its steps took, as far as
/// it is worth a colour.
[[nodiscard]] PlotDef stagesPlot(const ChannelValues& values, const std::string& label);

/// The same: pairs of the narrowphase that are at their finest level, and the others.
[[nodiscard]] PlotDef levelsPlot(const ChannelValues& values, const std::string& label);

}  // namespace scatter::viewer
