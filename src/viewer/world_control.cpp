#include "viewer/world_control.h"

#include <algorithm>

namespace scatter::viewer {
namespace {

Physics& physicsOf(const std::unique_ptr<Pane>& pane) {
  return pane->experiment().world().physics();
}

bool isHybrid(const std::unique_ptr<Pane>& pane) {
  return physicsOf(pane).kind() == WorldKind::kHybrid;
}

}  // namespace

WorldControl::WorldControl(std::vector<std::unique_ptr<Pane>>& panes) : panes_(panes) {
  const auto hybrid = std::find_if(panes.begin(), panes.end(), isHybrid);
  exists_ = hybrid != panes.end();
  if (exists_) now_ = (*hybrid)->experiment().options().physics.switching;
}

void WorldControl::setBudgetMilliseconds(double milliseconds) {
  const BudgetDef budget{.milliseconds = milliseconds};
  message_.clear();
  for (const auto& pane : panes_) {
    if (!isHybrid(pane)) continue;
    if (!pane->experiment().setBudget(budget)) {
      message_ = "a budget needs switching by pairs";
      return;
    }
  }
  now_.budget = budget;
}

std::string WorldControl::describeBudget() const {
  for (const auto& pane : panes_) {
    const BudgetState state = physicsOf(pane).switching().budgetState();
    if (state.verdict != BudgetVerdict::kNone) return describe(state);
  }
  return {};
}

void WorldControl::setPolicies(Policy policy, const std::vector<std::string>& policies) {
  message_.clear();
  for (const auto& pane : panes_) {
    if (!isHybrid(pane)) continue;
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
  for (const auto& pane : panes_) {
    if (!isHybrid(pane)) continue;
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
  for (const auto& pane : panes_) physicsOf(pane).switching().setFocus(focus);
}

}  // namespace scatter::viewer
