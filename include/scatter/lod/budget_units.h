#pragma once

namespace scatter {

/// What a step may cost, in units: ever better known while it is made. Of a budget of units all three are the
/// same.
struct BudgetUnits {
  double given = 0.0;    ///< When the step began; 0 without a budget.
  double revised = 0.0;  ///< What of it the clock had left among the pairs,
  double settled = 0.0;  ///< and once all contacts were known.

  // Not a default one, as BulletHybrid's headers are for programs of any standard from C++11 on.
  friend bool operator==(const BudgetUnits& a, const BudgetUnits& b) {
    return a.given == b.given && a.revised == b.revised && a.settled == b.settled;
  }
};

}  // namespace scatter
