#pragma once

#include <scatter/result.h>
#include <scatter/world/physics.h>

#include <optional>
#include <string>

#include "choices.h"

namespace scatter::app {

/// As btHybridDynamicsWorld::setNumThreads takes them.
inline constexpr int kMostThreads = 64;

/// A world as the command line names it: a choice, and with "@5ms" or "@3000units" behind it a budget, with
/// "@2threads" a number of threads.
struct WorldSpec {
  WorldChoice world;
  std::optional<BudgetDef> budget{};
  std::optional<int> threads{};
  std::string label;  ///< Such as "hybrid-5ms".
};

/// Fails on an unknown world, on what is neither a budget nor a number of threads, and on one for a world
/// that takes none.
[[nodiscard]] Result<WorldSpec> parseWorld(const std::string& text);

}  // namespace scatter::app
