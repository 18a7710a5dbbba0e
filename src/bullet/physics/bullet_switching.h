#pragma once

#include <scatter/world/level_switching.h>
#include <scatter/world/step_report.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bullet/physics/bodies.h"
#include "bullet/physics/engine.h"
#include "bullet/physics/level_listener.h"

namespace scatter {

/// The levels of a BulletPhysics. In a standard world bodies have levels too, and are always at the finest.
class BulletSwitching final : public LevelSwitching {
 public:
  /// `engine` was made with the same `def`; it and `bodies` outlive this.
  BulletSwitching(SwitchingDef def, BulletEngine& engine, BulletBodies& bodies);
  ~BulletSwitching() override;

  [[nodiscard]] int level(BodyId body) const override;
  [[nodiscard]] int levelCount(BodyId body) const override;
  bool requestLevel(BodyId body, int level, Scope scope) override;
  void retractRequest(BodyId body) override;
  void retractAllRequests() override;
  [[nodiscard]] int pairLevel(BodyId a, BodyId b) const override;
  void coarsestLevels(std::vector<std::uint8_t>& levels) const override;
  [[nodiscard]] BudgetUnits budgetUnits() const override { return budgetUnits_; }
  [[nodiscard]] BudgetState budgetState() const override;
  bool setBudget(const BudgetDef& budget) override;
  [[nodiscard]] Result<void> setPolicies(Policy policy, const std::vector<std::string>& policies) override;
  [[nodiscard]] Result<void> setSwitching(Switching switching) override;
  bool setHeld(BodyId body, bool held) override;
  void setFocus(const std::optional<ViewFocus>& focus) override;
  [[nodiscard]] std::span<const LevelEvent> levelEvents() const override { return listener_.events(); }

  /// How a body that is made now begins.
  [[nodiscard]] LevelStart levelStart() const;

  /// To be called before each step, with what the one before it has counted.
  void beginStep(const StepCounters& before);

  /// To be called after each step; adds the step's switching to `counters`, which hold all of its pairs.
  void endStep(StepCounters& counters);

 private:
  [[nodiscard]] bool switchesByPair() const;
  void askAllBodies();
  void applyFocus();

  SwitchingDef def_;
  BulletEngine& engine_;
  BulletBodies& bodies_;
  LevelListener listener_;
  std::optional<ViewFocus> focus_;
  BudgetUnits budgetUnits_;
};

}  // namespace scatter
