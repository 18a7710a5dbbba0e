#pragma once

#include <cstddef>
#include <vector>

#include "lod/cost_model.h"

namespace scatter::lod {

/// What the next step may cost, in units, from what the user has given.
class UnitBudget {
 public:
  UnitBudget() = default;  ///< No budget.

  [[nodiscard]] static UnitBudget ofUnits(double units);  ///< > 0. Clock-free.

  /// > 0. As long as nothing was learned, a unit is taken for a microsecond.
  [[nodiscard]] static UnitBudget ofMilliseconds(double milliseconds);

  /// What next() gave in an earlier run, step by step; what is not above 0 is no budget. After the last one
  /// it stays. Empty: no budget.
  [[nodiscard]] static UnitBudget replay(std::vector<double> units);

  /// The next so many steps share one budget: those that the caller makes at once.
  void share(int steps);

  /// Once a step: units for it; infinite for no budget.
  [[nodiscard]] double next();

  /// What the step did cost, for those that share its budget.
  void take(double units) { taken_ += units; }

  /// After a step that cost so much and took so long; only a budget of milliseconds learns.
  void learn(double units, double milliseconds);

  /// A step's share of a budget of milliseconds that is less than these.
  [[nodiscard]] bool isExceededBy(double milliseconds) const {
    return milliseconds_ > 0.0 && milliseconds > milliseconds_ / shared_;
  }

  /// As a budget of milliseconds has learned it; 0 for others.
  [[nodiscard]] double millisecondsPerUnit() const {
    return milliseconds_ > 0.0 ? unitTime_.millisecondsPerUnit() : 0.0;
  }

  /// Of milliseconds: learn() must be told how long steps take.
  [[nodiscard]] bool needsTime() const { return milliseconds_ > 0.0; }

  [[nodiscard]] bool isLimited() const { return milliseconds_ > 0.0 || constant_ > 0.0 || !units_.empty(); }

 private:
  [[nodiscard]] double ofShared(double units);

  double milliseconds_ = 0.0;
  double constant_ = 0.0;  ///< Units.
  int shared_ = 1;         ///< Steps that share a budget.
  int left_ = 0;           ///< Of these, to come.
  double taken_ = 0.0;     ///< Units that those before them did cost.
  std::vector<double> units_;
  std::size_t step_ = 0;
  UnitTime unitTime_;
};

}  // namespace scatter::lod
