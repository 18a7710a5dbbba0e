#pragma once

#include <scatter/lod/budget_state.h>
#include <scatter/lod/budget_units.h>

#include <cmath>
#include <functional>
#include <limits>
#include <span>

#include "lod/audit_room.h"
#include "lod/contact_thinning.h"
#include "lod/convergence.h"
#include "lod/cost_model.h"
#include "lod/governor.h"
#include "lod/planned_pair.h"
#include "lod/unit_budget.h"

namespace scatter::lod {

/// What the solver does in a step.
struct SolverWork {
  int iterations = 0;  ///< As long as it is not told to leave some out.

  /// Whether most of what it is to solve lies still; asked before iterations are left out. Null: not so.
  std::function<bool()> isCalm{};
};

/// Milliseconds that the step under way has taken, measured; asked if needsTime(). None: 0.
using StepClock = std::function<double()>;

/// What the step under way costs and may cost: the governor with what it is given to govern by. Clock-free
/// but for revise(), settle() and takeTime().
class StepBudget {
 public:
  StepBudget();

  /// From the next step on. What was learned stays known as long as every step has a budget, so that it may
  /// be another one in each.
  void set(UnitBudget budget);

  /// Whether the step under way has a budget: one of a run that is replayed may have none.
  [[nodiscard]] bool isLimited() const { return budget_.isLimited() && std::isfinite(allowed_.given); }
  [[nodiscard]] bool needsTime() const { return budget_.needsTime(); }

  /// The next so many steps share one budget.
  void share(int steps) { budget_.share(steps); }

  /// Begins a step. Contacts that belong to no pair are taken to be those of the step before until
  /// takeLoose() tells. `clock`: until takeTime().
  void begin(const StepLoad& load, StepClock clock = {});

  /// Before begin(): whether the step is to be given bodies.
  [[nodiscard]] bool needsBodies() const {
    return budget_.isLimited() && (convergence_.isDue() || std::isinf(allowed_.given));
  }

  /// After begin(): looks at which bodies are going to meet. `bodies`: all of them, if the step needs them.
  void look(std::span<const BodyView> bodies, float timeStep);

  /// Gives every pair its target.
  void plan(std::span<PlannedPair> pairs, int creditLevel);

  /// Gives a pair that has come up since a target.
  void planNew(PlannedPair& pair);

  /// Now and then among the pairs of a step: looks at the clock, once, when enough of it has been made.
  void revise();

  /// Whether the step under way is about to exceed its budget, if so many units more are spent.
  [[nodiscard]] bool isShort(double more = 0.0) const { return governor_.isShort(more); }

  /// As Governor has them.
  [[nodiscard]] double missing() const { return governor_.missing(); }
  [[nodiscard]] double savedByKeeping(const PlannedPair& pair) const {
    return governor_.savedByKeeping(pair);
  }
  [[nodiscard]] bool isShortOfFiner(const PlannedPair& pair, bool fromNothing) const {
    return governor_.isShortOfFiner(pair, costs_, fromNothing);
  }

  /// Whether it would be if so many more queries about separation are made.
  [[nodiscard]] bool isShortAfterQueries(int queries) const;

  /// From how late on audits of pairs on credit are made now.
  [[nodiscard]] float auditsFrom() const {
    return audits_.from({governor_.isShort(), governor_.isOver(), governor_.admission()});
  }

  void spendSwitch() { spend(costs_.weights().switched); }
  void spendQueries(int queries);

  /// Of what takeWork() is told as well.
  void countAudit(const PairWorkload& work) { audits_.take(costs_.weights().audit + costs_.units(work)); }

  /// A pair was not audited that is later than may be; it is going to be so late in the next step.
  void countOverdue(float next) { audits_.takeOverdue(next); }

  /// What a pair's step did cost; its contacts as if all were hidden that may be.
  PairUnits takeWork(PlannedPair& pair, const PairWorkload& work);

  /// What a pair's step did cost where nothing is planned; and that of all such pairs of a step.
  [[nodiscard]] double unplanned(const PairWorkload& work) const { return costs_.units(work); }
  void takeUnplanned(const PairWorkload& work, int pairs) { spend(costs_.units(work, pairs)); }

  /// A pair was left without a look.
  void takeQuiet(PlannedPair& pair) { governor_.spend(pair, 0.0, 0.0); }

  /// What a pair costs a step at its level, for the plans to come; only a budget learns.
  void learn(PlannedPair& pair, bool touching, const PairUnits& units);

  /// A pair went to the finer level that it has now, which did cost so much in this step; before learn().
  void learnFiner(const PlannedPair& pair, double units) { governor_.learnFiner(pair, costs_, units); }

  /// What a pair that rests would take if it woke with its bodies, at its finest level if it is in contact;
  /// and units that the last plan has left for that.
  [[nodiscard]] double unitsAwake(const PlannedPair& pair) const {
    return governor_.unitsAwake(pair, costs_) + costs_.weights().awakeBody;
  }
  [[nodiscard]] double roomToWake() const { return governor_.room(); }

  /// After the narrowphase: contacts that belong to no pair.
  void takeLoose(const LooseContacts& contacts);

  /// Then: which contacts the solver is to be shown, and how many iterations it is to leave out.
  void settle(const SolverWork& solver, const ContactThinning::Find& find);
  [[nodiscard]] int hiddenContacts() const { return contacts_.hidden(); }
  [[nodiscard]] int iterationsLeftOut() const { return iterationsLeftOut_; }

  /// Ends a step; `isPlanned`: plan() was called in it.
  void finish(bool isPlanned);

  /// After a step, if needsTime(): looks at the clock, and learns. Whether it has taken more than its budget.
  bool takeTime();

  [[nodiscard]] double units() const { return units_; }  ///< Of the step under way, or made last.
  [[nodiscard]] double lastUnits() const { return lastUnits_; }
  [[nodiscard]] double plannedUnits() const { return governor_.planned(); }
  [[nodiscard]] BudgetUnits budgetUnits() const { return isLimited() ? allowed_ : BudgetUnits(); }
  [[nodiscard]] bool isExceeded() const { return isLimited() && units_ > allowed_.given; }

  /// Of the step that has ended; `floor`: its floorUnits(), if it isExceeded(). What pairs have given up is
  /// the planner's to tell.
  [[nodiscard]] BudgetState state(double floor) const;

  /// As Governor has it, with as few iterations as the step had.
  [[nodiscard]] double floorUnits(std::span<const PlannedPair> pairs) const {
    return governor_.floorUnits(pairs, costs_) - iterationUnits_;
  }

 private:
  [[nodiscard]] double elapsed() const { return clock_ && needsTime() ? clock_() : 0.0; }
  void forget();
  void spend(double units);
  void settleContacts(const ContactThinning::Find& find);
  void settleIterations(const SolverWork& solver);

  /// Of the step under way, without what comes after its contacts.
  [[nodiscard]] double unitsSoFar() const;

  /// Of a step, as much as must have been made before the clock says something of the rest. `scatter bench
  /// budget --machine bench/machines/twice_as_slow.csv --families implosion,bowl,wheels_box,rooms,sleepers,
  /// ships_mesh --seeds 1,2 --scale 0.5`: as many frames are over with 0.15, a few more with 0.5.
  static constexpr double kEnough = 0.3;

  StepClock clock_{};
  CostModel costs_;
  Governor governor_;
  Convergence convergence_;
  UnitBudget budget_;
  ContactThinning contacts_;
  AuditRoom audits_;
  double savedUnits_ = 0.0;  ///< What contacts that need not be shown are taken to save of units_.
  double looseSaved_ = 0.0;  ///< Of these, by contacts that belong to no pair.
  double shownUnits_ = 0.0;  ///< Of the units that these may save, those that they do not.
  int iterationsLeftOut_ = 0;
  double iterationUnits_ = 0.0;  ///< What these save.
  int contactsFound_ = 0;        ///< Of pairs, and of no pair.
  StepLoad load_{};
  int newPairs_ = 0;  ///< By how many more the broadphase has than in the step before.
  int ownSpare_ = 0;  ///< Contacts of pairs that may have some to spare.
  double fixedUnits_ = 0.0;
  double looseUnits_ = 0.0;  ///< Of these, as they are taken to be.
  double units_ = 0.0;
  double lastUnits_ = 0.0;
  BudgetUnits allowed_{.given = std::numeric_limits<double>::infinity()};  ///< Infinite for none.
  bool isRevised_ = false;                                                 ///< In this step.
};

}  // namespace scatter::lod
