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

  /// Once a step: units for it; infinite for no budget.
  [[nodiscard]] double next();

  /// After a step that cost so much and took so long; only a budget of milliseconds learns.
  void learn(double units, double milliseconds);

  /// A budget of milliseconds that is less than these.
  [[nodiscard]] bool isExceededBy(double milliseconds) const {
    return milliseconds_ > 0.0 && milliseconds > milliseconds_;
  }

  /// Of milliseconds: learn() must be told how long steps take.
  [[nodiscard]] bool needsTime() const { return milliseconds_ > 0.0; }

  [[nodiscard]] bool isLimited() const { return milliseconds_ > 0.0 || !units_.empty(); }

 private:
  double milliseconds_ = 0.0;
  std::vector<double> units_;
  std::size_t step_ = 0;
  UnitTime unitTime_;
};

}  // namespace scatter::lod
