#pragma once

#include <scatter/world/physics.h>

#include <memory>
#include <string>
#include <vector>

#include "viewer/pane.h"

namespace scatter::viewer {

/// Budget, policies and switching of the hybrid worlds of a window, changed while they run, and for every
/// restart: of those that began with a budget, or of all if none did. So a world beside them that is always
/// at its finest level stays so.
class WorldControl {
 public:
  /// The panes must outlive it. Begins with what the first of these worlds was made with.
  explicit WorldControl(const std::vector<std::unique_ptr<Pane>>& panes);

  /// Whether there is a hybrid world at all.
  [[nodiscard]] bool exists() const { return !panes_.empty(); }

  [[nodiscard]] const SwitchingDef& now() const { return now_; }

  void setBudgetMilliseconds(double milliseconds);  ///< 0: no budget.
  void setPolicies(Policy policy, const std::vector<std::string>& policies);
  void setSwitching(Switching switching);

  /// Where the user looks, for the policy "focus".
  void setFocus(const ViewFocus& focus);

  /// Of the first of them that has a budget, as scatter::describe() says it; empty without one.
  [[nodiscard]] std::string describeBudget() const;

  /// What was refused last; empty if nothing was.
  [[nodiscard]] const std::string& message() const { return message_; }

 private:
  std::vector<Pane*> panes_;
  SwitchingDef now_;
  std::string message_;
};

}  // namespace scatter::viewer
