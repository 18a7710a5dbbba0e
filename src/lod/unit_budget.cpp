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
  shared_ = before.shared_;
  left_ = before.left_;
  taken_ = before.taken_;
  if (machine_ != before.machine_) return;
  machineStep_ = before.machineStep_;
  unitTime_ = before.unitTime_;
  revision_ = before.revision_;
  settlement_ = before.settlement_;
}

void UnitBudget::share(int steps) {
  shared_ = left_ = std::max(steps, 1);
  taken_ = 0.0;
}

/// What those before have left, to equal parts; and something if they have left nothing.
double UnitBudget::ofShared(double units) {
  if (left_ == 0) share(1);
  const double part = (units - taken_) / left_;
  --left_;
  return std::max(part, kLeastShare * units / shared_);
}

double UnitBudget::next() {
  revision_.begin();
  settlement_.begin();
  given_ = nextUnits();
  return given_;
}

double UnitBudget::revise(double units, double milliseconds) {
  return milliseconds_ > 0.0 ? roomAt(revision_, units, milliseconds) : orGiven(now_.revised);
}

double UnitBudget::settle(double units, double milliseconds) {
  return milliseconds_ > 0.0 ? roomAt(settlement_, units, milliseconds) : orGiven(now_.settled);
}

double UnitBudget::roomAt(StepPoint& point, double units, double measured) {
  point.pass(units, timeOf(units, measured));
  const double known = unitTime_.millisecondsPerUnit();
  const double room = point.room(given_, known > 0.0 ? known : 1.0 / kUnitsPerMillisecond);
  return std::max(room, kLeastShare * given_);
}

double UnitBudget::nextUnits() {
  if (milliseconds_ > 0.0) {
    const double units = unitTime_.unitsIn(milliseconds_);
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
  if (!machine_.empty()) machineStep_ = (machineStep_ + 1) % machine_.size();
  // In a light step most of the time goes into what no unit stands for.
  constexpr double kLight = 0.25;
  const double share = milliseconds_ / shared_;
  const double known = unitTime_.unitsIn(share);
  const double allowed = known > 0.0 ? known : share * kUnitsPerMillisecond;
  if (units < kLight * allowed && milliseconds < kLight * share) return;
  unitTime_.learn(units, milliseconds);
  revision_.learn(units, milliseconds);
  settlement_.learn(units, milliseconds);
}

}  // namespace scatter::lod
