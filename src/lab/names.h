#pragma once

#include <scatter/world/level_event.h>
#include <scatter/world/physics.h>

#include <string>

namespace scatter::lab {

/// As on the command line and in summary.json.
[[nodiscard]] std::string nameOf(WorldKind kind);
[[nodiscard]] std::string nameOf(Policy policy);
[[nodiscard]] std::string nameOf(Narrowphase narrowphase);
[[nodiscard]] std::string nameOf(ContactSolver solver);
[[nodiscard]] std::string nameOf(PairMidphase midphase);
[[nodiscard]] std::string nameOf(Switching switching);
[[nodiscard]] std::string nameOf(LevelEventKind kind);

}  // namespace scatter::lab
