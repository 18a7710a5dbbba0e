#include "viewer/world_control.h"

#include <algorithm>

namespace scatter::viewer {
namespace {

const SwitchingDef& switchingOf(const Pane& pane) {
  return pane.experiment().options().physics.switching;
}

bool hasBudget(const Pane* pane) {
  const BudgetDef& budget = switchingOf(*pane).budget;
  return budget.milliseconds > 0.0 || budget.units > 0.0 || !budget.recorded.empty();
}

}  // namespace

WorldControl::WorldControl(const std::vector<std::unique_ptr<Pane>>& panes) {
  for (const auto& pane : panes) {
    if (pane->experiment().world().physics().kind() == WorldKind::kHybrid) panes_.push_back(pane.get());
  }
  if (std::ranges::any_of(panes_, hasBudget))
    std::erase_if(panes_, [](const Pane* pane) { return !hasBudget(pane); });
  if (exists()) now_ = switchingOf(*panes_.front());
}

void WorldControl::setBudgetMilliseconds(double milliseconds) {
  const BudgetDef budget{.milliseconds = milliseconds};
  message_.clear();
  for (Pane* const pane : panes_) {
    if (!pane->experiment().setBudget(budget)) {
      message_ = "a budget needs switching by pairs";
      return;
    }
  }
  now_.budget = budget;
}

std::string WorldControl::describeBudget() const {
  for (const Pane* const pane : panes_) {
    const BudgetState state = pane->experiment().world().physics().switching().budgetState();
    if (state.verdict != BudgetVerdict::kNone) return describe(state);
  }
  return {};
}

void WorldControl::setPolicies(Policy policy, const std::vector<std::string>& policies) {
  message_.clear();
  for (Pane* const pane : panes_) {
    if (const auto set = pane->experiment().setPolicies(policy, policies); !set) {
      message_ = set.error().message;
      return;
    }
  }
  now_.policy = policy;
  now_.policies = policies;
}

void WorldControl::setSwitching(Switching switching) {
  message_.clear();
  for (Pane* const pane : panes_) {
    if (const auto set = pane->experiment().setSwitching(switching); !set) {
      message_ = set.error().message;
      return;
    }
  }
  now_.switching = switching;
}

void WorldControl::setFocus(const ViewFocus& focus) {
  const bool asked = std::any_of(now_.policies.begin(), now_.policies.end(),
                                 [](const std::string& policy) { return policy.rfind("focus", 0) == 0; });
  if (!asked) return;
  for (Pane* const pane : panes_) pane->experiment().world().physics().switching().setFocus(focus);
}

}  // namespace scatter::viewer
