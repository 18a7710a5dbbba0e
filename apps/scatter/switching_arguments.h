#pragma once

#include <scatter/result.h>
#include <scatter/world/physics.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "world_spec.h"

namespace CLI {
class App;
}

namespace scatter::app {

/// The arguments that say how levels are switched in hybrid worlds, as they stand on the command line.
struct SwitchingArguments {
  std::optional<std::string> switching;
  std::vector<std::string> policies;  ///< Cut at every comma, also between a policy's parameters.
  std::optional<double> budgetMs;     ///< Also what frames are counted against, in any world.
  std::optional<double> budgetUnits;
  std::optional<std::string> replay;
  std::optional<int> creditLevel;
  bool noCredit = false;
  std::optional<int> retryInterval;
  std::optional<int> quietSteps;
  std::optional<float> proximitySteps;
  std::optional<std::uint32_t> loadFinePairs;
  bool unsafeSwitching = false;
};

/// `arguments` must outlive the parsing.
void addSwitchingArguments(CLI::App& command, SwitchingArguments& arguments);

/// What the arguments mean, worlds apart.
struct SwitchingChoices {
  std::optional<Switching> switching;
  std::optional<Policy> policy;
  std::vector<std::string> policies;  ///< That pair switching alone has.
  BudgetDef budget;                   ///< Of worlds that take one and bring none.
};

/// Fails on unknown names, on policies or parameters that are wrong, on more than one budget, and on a
/// recording that cannot be replayed.
[[nodiscard]] Result<SwitchingChoices> chooseSwitching(const SwitchingArguments& arguments);

/// What a hybrid world does about levels, if its narrowphase is this one.
[[nodiscard]] SwitchingDef makeSwitching(const SwitchingArguments& arguments, const SwitchingChoices& choices,
                                         const WorldSpec& world, Narrowphase narrowphase);

/// Fails on an argument that has no meaning in any of these worlds, of which each has its physics.
[[nodiscard]] Result<void> checkSwitching(const SwitchingArguments& arguments,
                                          const SwitchingChoices& choices,
                                          const std::vector<WorldSpec>& worlds,
                                          const std::vector<PhysicsDef>& physics);

}  // namespace scatter::app
