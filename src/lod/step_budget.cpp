#include "lod/step_budget.h"

#include <algorithm>
#include <utility>

#include "lod/solver_iterations.h"

namespace scatter::lod {

StepBudget::StepBudget()
    : costs_(CostWeights()), governor_(GovernorDef()), contacts_(costs_.weights().hiddenContact) {}

// A run that is repeated has begun with nothing learned.
void StepBudget::set(UnitBudget budget) {
  if (budget.isRecorded()) {
    forget();
  } else {
    budget.takeOver(budget_);
  }
  budget_ = std::move(budget);
}

// What pairs cost, which costs_ knows, is the same with a budget and without one.
void StepBudget::forget() {
  governor_ = Governor(GovernorDef());
  convergence_ = Convergence();
  contacts_ = ContactThinning(costs_.weights().hiddenContact);
  looseSaved_ = 0.0;
}

void StepBudget::begin(const StepLoad& load, StepClock clock) {
  clock_ = std::move(clock);
  const bool wasLimited = std::isfinite(allowed_.given);
  const double given = budget_.next();
  allowed_ = {given, given, given};
  if (isLimited() != wasLimited) forget();
  ownSpare_ = 0;
  shownUnits_ = 0.0;
  iterationsLeftOut_ = 0;
  iterationUnits_ = 0.0;
  contactsFound_ = 0;
  newPairs_ = std::max(load.broadphasePairs - load_.broadphasePairs, 0);
  load_ = load;
  savedUnits_ = looseSaved_;
  fixedUnits_ = costs_.units(load) + looseUnits_ - looseSaved_;
  units_ = fixedUnits_;
  isRevised_ = false;
  audits_.begin(given);
}

void StepBudget::look(std::span<const BodyView> bodies, float timeStep) {
  if (isLimited()) convergence_.advance(bodies, timeStep);
}

void StepBudget::plan(std::span<PlannedPair> pairs, int creditLevel) {
  governor_.awaitNew(newPairs_);
  governor_.expect(convergence_.pairsToCome());
  governor_.setCreditLevel(creditLevel);
  governor_.plan(pairs, costs_, fixedUnits_, allowed_.given);
}

void StepBudget::planNew(PlannedPair& pair) {
  pair.target = static_cast<std::uint8_t>(governor_.planNew(pair, costs_));
  pair.byBudget = pair.target < std::min(pair.wish.atMost, pair.view.finest);
}

bool StepBudget::isShortAfterQueries(int queries) const {
  return governor_.isShort(queries * costs_.weights().separationQuery);
}

// Of what belongs to no pair's usual work.
void StepBudget::spend(double units) {
  units_ += units;
  governor_.spend(units);
}

void StepBudget::spendQueries(int queries) {
  for (int i = 0; i < queries; ++i) spend(costs_.weights().separationQuery);
}

void StepBudget::revise() {
  if (isRevised_ || !isLimited() || governor_.shareSpent() < kEnough) return;
  isRevised_ = true;
  allowed_.revised = budget_.revise(unitsSoFar(), elapsed());
  governor_.revise(allowed_.revised);
}

PairUnits StepBudget::takeWork(PlannedPair& pair, const PairWorkload& work) {
  const int spare = ContactThinning::concerns(work.contacts) ? work.contacts : 0;
  const double saved = contacts_.expected(spare);
  const double hidden = costs_.weights().hiddenContact * spare;
  ownSpare_ += spare;
  contactsFound_ += work.contacts;
  savedUnits_ += saved;
  const double units = costs_.units(work) - saved;
  units_ += units;
  governor_.spend(pair, units, work.reuses ? std::max(static_cast<double>(pair.expected), units) : units);
  pair.bound = static_cast<float>(costs_.boundUnits(work));
  return {units, costs_.commonUnits(work), std::min(costs_.contactUnits(work) - hidden, units)};
}

void StepBudget::learn(PlannedPair& pair, bool touching, const PairUnits& units) {
  if (!isLimited()) return;
  costs_.learn(pair.cost, pair.view.level, pair.view.finest, touching, units);
}

void StepBudget::takeLoose(const LooseContacts& contacts) {
  const double known = looseUnits_;
  looseUnits_ = costs_.units(contacts);
  contactsFound_ += contacts.points;
  spend(looseUnits_ - known);
}

void StepBudget::settle(const SolverWork& solver, const ContactThinning::Find& find) {
  if (!isLimited()) return;
  allowed_.settled = budget_.settle(unitsSoFar(), elapsed());
  settleContacts(find);
  settleIterations(solver);
}

double StepBudget::unitsSoFar() const {
  const CostWeights& weights = costs_.weights();
  return units_ + savedUnits_ - weights.contact * contactsFound_ - weights.joint * load_.joints -
         weights.awakeBody * load_.awake;
}

// The governor plans as if none was shown that need not be: before detail is taken all of them are hidden.
void StepBudget::settleContacts(const ContactThinning::Find& find) {
  contacts_.settle(units_ + savedUnits_, allowed_.settled, find);
  spend(savedUnits_ - contacts_.mostSaved());
  savedUnits_ = contacts_.mostSaved();
  looseSaved_ = std::max(savedUnits_ - contacts_.expected(ownSpare_), 0.0);
  shownUnits_ = savedUnits_ - contacts_.saved();
  units_ += shownUnits_;
}

// The governor plans as if all of them were made: they are left out of steps that it has not foreseen. What
// lies still would tremble.
void StepBudget::settleIterations(const SolverWork& solver) {
  const CostWeights& weights = costs_.weights();
  const double each =
      weights.contactIteration * (contactsFound_ - hiddenContacts()) + weights.jointIteration * load_.joints;
  const int leftOut = lod::iterationsLeftOut(units_, allowed_.settled, each, solver.iterations);
  if (leftOut == 0 || (solver.isCalm && solver.isCalm())) return;
  iterationsLeftOut_ = leftOut;
  iterationUnits_ = each * iterationsLeftOut_;
  units_ -= iterationUnits_;
}

void StepBudget::finish(bool isPlanned) {
  if (isPlanned) governor_.learn(units_ - shownUnits_ + iterationUnits_);
  budget_.take(units_);
  lastUnits_ = units_;
}

bool StepBudget::takeTime() {
  const double milliseconds = budget_.timeOf(units_, elapsed());
  const bool isExceeded = budget_.isExceededBy(milliseconds);
  budget_.learn(units_, milliseconds);
  return isExceeded;
}

BudgetState StepBudget::state(double floor) const {
  constexpr double kKept = 1.02;
  BudgetState state;
  if (!isLimited()) return state;
  const double budget = allowed_.given;
  state.budget = budget;
  state.taken = units_;
  state.fixed = fixedUnits_;
  state.reachable = std::min(governor_.reachableUnits() - iterationUnits_, units_);
  state.millisecondsPerUnit = budget_.millisecondsPerUnit();
  state.verdict = BudgetVerdict::kKept;
  if (units_ <= kKept * budget) return state;
  state.floor = std::min(floor, units_);
  state.isVain = governor_.isVain();
  if (state.reachable > budget) {
    state.verdict = BudgetVerdict::kImpossible;
  } else {
    const bool isStuck = state.floor > budget;
    state.verdict = isStuck ? BudgetVerdict::kImpossibleNow : BudgetVerdict::kExceeded;
  }
  return state;
}

}  // namespace scatter::lod
