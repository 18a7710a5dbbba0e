#pragma once

#include <scatter/result.h>
#include <scatter/world/physics.h>

#include <optional>
#include <string>

#include "choices.h"

namespace scatter::app {

/// A world as the command line names it: a choice, and with "@5ms" or "@3000units" behind it a budget.
struct WorldSpec {
  WorldChoice world;
  std::optional<BudgetDef> budget{};
  std::string label;  ///< Such as "hybrid-5ms".
};

/// Fails on an unknown world, on a budget that is none, and on one for a world that takes none.
[[nodiscard]] Result<WorldSpec> parseWorld(const std::string& text);

}  // namespace scatter::app
