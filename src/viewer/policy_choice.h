#pragma once

#include <scatter/world/level_switching.h>

#include <string>
#include <vector>

namespace scatter::viewer {

/// A policy as a panel offers it.
struct PolicyChoice {
  std::string name{};
  std::string summary{};  ///< One line.
  bool chosen = false;
};

/// The policies that a world can have that switches like this, each once. Of pairs any number can be chosen,
/// of bodies always one.
[[nodiscard]] std::vector<PolicyChoice> policyChoices(const SwitchingDef& now);

/// What the world is given when one of them is chosen, or chosen no more. Parameters of others are kept.
struct ChosenPolicies {
  Policy policy = Policy::kNone;
  std::vector<std::string> named{};
};
[[nodiscard]] ChosenPolicies choosePolicy(const SwitchingDef& now, const std::string& name, bool chosen);

}  // namespace scatter::viewer
