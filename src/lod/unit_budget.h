#pragma once

#include <scatter/lod/budget_units.h>

#include <cstddef>
#include <vector>

#include "lod/cost_model.h"
#include "lod/step_point.h"

namespace scatter::lod {

/// What the next step may cost, in units, from what the user has given.
class UnitBudget {
 public:
  UnitBudget() = default;  ///< No budget.

  [[nodiscard]] static UnitBudget ofUnits(double units);  ///< > 0. Clock-free.

  /// > 0. As long as nothing was learned, a unit is taken for a microsecond.
  /// `machine`: milliseconds that a unit takes, each > 0, step by step, and from the first again: what a step
  /// takes is worked out from its units, clock-free. Empty: what is measured.
  [[nodiscard]] static UnitBudget ofMilliseconds(double milliseconds, std::vector<double> machine = {});

  /// What next(), revise() and settle() gave in an earlier run, step by step; where next() gave nothing above
  /// 0 there is no budget, and where the others did what next() gave stays. After the last step it stays.
  /// Empty: no budget.
  [[nodiscard]] static UnitBudget replay(std::vector<BudgetUnits> steps);

  /// In the place of the one before it: what that has learned of the machine stays known, if it is the same,
  /// and steps that shared its budget share what this one leaves of it.
  void takeOver(const UnitBudget& before);

  /// The next so many steps share one budget: those that the caller makes at once.
  void share(int steps);

  /// Once a step: units for it; infinite for no budget.
  [[nodiscard]] double next();

  /// After next(), among the contacts of the step, and when they are known: what it may cost now, at most
  /// what next() gave. Less of a budget of milliseconds if the `units` that it has made have taken longer
  /// than they say, so that the rest of it has less time. `milliseconds`: measured, if the budget
  /// needsTime().
  [[nodiscard]] double revise(double units, double milliseconds);
  [[nodiscard]] double settle(double units, double milliseconds);

  /// What the step did cost, for those that share its budget.
  void take(double units) { sharing_.taken += units; }

  /// Of a step that cost so much: what it took, measured or on the machine that was given.
  [[nodiscard]] double timeOf(double units, double measured) const {
    return machine_.empty() ? measured : units * machine_[learned_.step];
  }

  /// After a step that cost so much and took so long. Only a budget of milliseconds learns.
  void learn(double units, double milliseconds);

  /// A step's share of a budget of milliseconds that is less than these.
  [[nodiscard]] bool isExceededBy(double milliseconds) const {
    return milliseconds_ > 0.0 && milliseconds > milliseconds_ / sharing_.steps;
  }

  /// As a budget of milliseconds has learned it; 0 for others.
  [[nodiscard]] double millisecondsPerUnit() const {
    return milliseconds_ > 0.0 ? learned_.unitTime.millisecondsPerUnit() : 0.0;
  }

  /// Of milliseconds: learn() must be told how long steps take.
  [[nodiscard]] bool needsTime() const { return milliseconds_ > 0.0; }

  [[nodiscard]] bool isRecorded() const { return !recorded_.empty(); }

  [[nodiscard]] bool isLimited() const { return milliseconds_ > 0.0 || constant_ > 0.0 || isRecorded(); }

 private:
  [[nodiscard]] double nextUnits();
  [[nodiscard]] double roomAt(StepPoint& point, double units, double measured) const;
  [[nodiscard]] double orGiven(double units) const { return units > 0.0 ? units : given_; }
  [[nodiscard]] double ofShared(double units);

  /// Steps that share a budget.
  struct Sharing {
    int steps = 1;
    int left = 0;        ///< Of these, to come.
    double taken = 0.0;  ///< Units that those before them did cost.
  };

  /// What a machine needs for a unit.
  struct Learned {
    std::size_t step = 0;  ///< Of a machine that was given, the one under way.
    UnitTime unitTime;
    StepPoint revision;
    StepPoint settlement;
  };

  double milliseconds_ = 0.0;
  double constant_ = 0.0;        ///< Units.
  std::vector<double> machine_;  ///< Milliseconds that a unit takes; empty: measured.
  std::vector<BudgetUnits> recorded_;
  std::size_t step_ = 0;  ///< Of these, the one to come.
  BudgetUnits now_;       ///< Of these, the one under way.
  double given_ = 0.0;    ///< By next().
  Sharing sharing_;
  Learned learned_;
};

}  // namespace scatter::lod
