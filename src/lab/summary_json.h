#pragma once

#include <scatter/lab/summary.h>

#include <nlohmann/json.hpp>

namespace scatter::lab {

/// Keeps its keys in the order in which they were added.
using Json = nlohmann::ordered_json;

[[nodiscard]] Json summaryJson(const Summary& summary);

/// What was asked for: the world, frames, seed, physics.
[[nodiscard]] Json runOptionsJson(const Summary& summary);
[[nodiscard]] Json buildJson(const BuildInfo& build);
[[nodiscard]] Json machineJson(const MachineInfo& machine);

}  // namespace scatter::lab
