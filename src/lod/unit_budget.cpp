#include "lod/unit_budget.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace scatter::lod {
namespace {

constexpr double kUnitsPerMillisecond = 1000.0;

/// Of a budget, what a step has in any case.
constexpr double kLeastShare = 0.1;

}  // namespace

UnitBudget UnitBudget::ofUnits(double units) {
  assert(units > 0.0);
  UnitBudget budget;
  budget.constant_ = units;
  return budget;
}

UnitBudget UnitBudget::ofMilliseconds(double milliseconds, std::vector<double> machine) {
  assert(milliseconds > 0.0);
  UnitBudget budget;
  budget.milliseconds_ = milliseconds;
  budget.machine_ = std::move(machine);
  return budget;
}

UnitBudget UnitBudget::replay(std::vector<BudgetUnits> steps) {
  UnitBudget budget;
  budget.recorded_ = std::move(steps);
  return budget;
}

void UnitBudget::takeOver(const UnitBudget& before) {
  sharing_ = before.sharing_;
  if (machine_ == before.machine_) learned_ = before.learned_;
}

void UnitBudget::share(int steps) {
  const int sharers = std::max(steps, 1);
  sharing_ = {.steps = sharers, .left = sharers};
}

/// What those before have left, to equal parts; and something if they have left nothing.
double UnitBudget::ofShared(double units) {
  if (sharing_.left == 0) share(1);
  const double part = (units - sharing_.taken) / sharing_.left;
  --sharing_.left;
  return std::max(part, kLeastShare * units / sharing_.steps);
}

double UnitBudget::next() {
  learned_.revision.begin();
  learned_.settlement.begin();
  given_ = nextUnits();
  return given_;
}

double UnitBudget::revise(double units, double milliseconds) {
  return milliseconds_ > 0.0 ? roomAt(learned_.revision, units, milliseconds) : orGiven(now_.revised);
}

double UnitBudget::settle(double units, double milliseconds) {
  return milliseconds_ > 0.0 ? roomAt(learned_.settlement, units, milliseconds) : orGiven(now_.settled);
}

double UnitBudget::roomAt(StepPoint& point, double units, double measured) const {
  point.pass(units, timeOf(units, measured));
  const double known = learned_.unitTime.millisecondsPerUnit();
  const double room = point.room(given_, known > 0.0 ? known : 1.0 / kUnitsPerMillisecond);
  return std::max(room, kLeastShare * given_);
}

double UnitBudget::nextUnits() {
  if (milliseconds_ > 0.0) {
    const double units = learned_.unitTime.unitsIn(milliseconds_);
    return ofShared(units > 0.0 ? units : milliseconds_ * kUnitsPerMillisecond);
  }
  if (constant_ > 0.0) return ofShared(constant_);
  if (recorded_.empty()) return std::numeric_limits<double>::infinity();
  now_ = recorded_[std::min(step_, recorded_.size() - 1)];
  ++step_;
  return now_.given > 0.0 ? now_.given : std::numeric_limits<double>::infinity();
}

void UnitBudget::learn(double units, double milliseconds) {
  if (milliseconds_ <= 0.0) return;
  if (!machine_.empty()) learned_.step = (learned_.step + 1) % machine_.size();
  // In a light step most of the time goes into what no unit stands for.
  constexpr double kLight = 0.25;
  const double share = milliseconds_ / sharing_.steps;
  const double known = learned_.unitTime.unitsIn(share);
  const double allowed = known > 0.0 ? known : share * kUnitsPerMillisecond;
  if (units < kLight * allowed && milliseconds < kLight * share) return;
  learned_.unitTime.learn(units, milliseconds);
  learned_.revision.learn(units, milliseconds);
  learned_.settlement.learn(units, milliseconds);
}

}  // namespace scatter::lod
