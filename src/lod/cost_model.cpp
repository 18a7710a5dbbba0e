#include "lod/cost_model.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace scatter::lod {
namespace {

// Of the difference to the newest step. A rise is believed sooner: it may be a pile that forms.
constexpr double kRise = 0.2;
constexpr double kFall = 0.1;

// What of a pair's costs shows at other levels, as a power of how many times as much it takes; 0.5 for pairs
// that are not on credit. On credit a pair takes more as looks at its finest shapes get late, which tells
// little of what these would take: with 0.5 the towers of `tower_bench`, where credit saves nothing, stay on
// it, and in a fifth of the steps a cube is faster than 2 cm/s, with 0.2 in a 25th. docs/budget-figures.md
// has what other powers did.
constexpr double kShowsOnCredit = 0.2;

// Pairs whose mean a kind's mean forgets no faster than.
constexpr double kMeanPairs = 2000.0;

// What a kind is taken to have seen before its first pair: so that a few odd ones do not decide.
constexpr double kPriorPairs = 8.0;

// Nothing is free: keeps ratios finite.
constexpr double kLeastUnits = 0.01;

// The cost of a level against the next finer one, as long as nothing is known.
constexpr double kUnknownRatio = 0.4;
constexpr double kUnknownTouching = 6.0;
constexpr double kUnknownApart = 1.0;

/// What a pair does shows at other levels too, but less.
double shownAtOthers(double ratio, bool onCredit) {
  return onCredit ? std::pow(ratio, kShowsOnCredit) : std::sqrt(ratio);
}

// All changes go through here, so that what is remembered of a level does not drift while others are in use.
void follow(PairCost& cost, std::size_t slot, double units, bool onCredit, double rise = kRise) {
  const double before = cost.units[slot];
  if (before <= 0.0) {
    cost.units[slot] = static_cast<float>(std::max(units, kLeastUnits));
    return;
  }
  const double change = units - before;
  const double now = std::max(before + change * (change > 0.0 ? rise : kFall), kLeastUnits);
  const auto scale = static_cast<float>(shownAtOthers(now / before, onCredit));
  for (float& remembered : cost.units) remembered *= scale;
  cost.units[slot] = static_cast<float>(now);
}

}  // namespace

void CostModel::Mean::add(double value) {
  weight = std::min(weight + 1.0, kMeanPairs);
  units += (value - units) / weight;
}

double CostModel::Mean::with(double prior) const {
  return std::max((units * weight + prior * kPriorPairs) / (weight + kPriorPairs), kLeastUnits);
}

double CostModel::units(const PairWorkload& work, int pairs) const {
  const PairWork& counts = work.counts;
  const int awake = counts.childPairs - counts.childPairsAsleep;
  return weights_.pair * pairs + weights_.rebuild * counts.rebuilds + weights_.childPair * awake +
         weights_.gjkIteration * counts.gjkIterations + weights_.detectorRun * counts.detectorRuns +
         weights_.halfSpaceRun * counts.halfSpaceRuns + weights_.contact * work.contacts +
         weights_.manifold * work.manifolds + weights_.piece * counts.pieces;
}

double CostModel::contactUnits(const PairWorkload& work) const {
  return weights_.contact * work.contacts + (weights_.manifold + weights_.childPair) * work.manifolds;
}

double CostModel::commonUnits(const PairWorkload& work) const {
  return weights_.pair + weights_.rebuild * work.counts.rebuilds;
}

double CostModel::boundUnits(const PairWorkload& work) const {
  return commonUnits(work) + weights_.piece * work.counts.pieces;
}

double CostModel::units(const StepLoad& load) const {
  return weights_.step + weights_.object * load.objects + weights_.awakeBody * load.awake +
         weights_.broadphasePair * load.broadphasePairs + weights_.joint * load.joints;
}

double CostModel::units(const LooseContacts& contacts) const {
  return weights_.looseManifold * contacts.manifolds + weights_.contact * contacts.points;
}

void CostModel::learn(PairCost& cost, int level, int finest, bool touching, const PairUnits& units) {
  assert(level >= 1 && level <= finest);
  grow(finest);
  Kind& kind = kinds_[indexOf(level, finest)];
  const std::size_t slot = PairCost::slotOf(level, finest);
  if (cost.level == level) {
    // The second step at a level is the first that shows what it costs there now.
    follow(cost, slot, units.all, units.onCredit, cost.isNew ? 1.0 : kRise);
    cost.isNew = false;
    if (units.all > 0.0) {
      addToMeans(cost, level, finest, touching, units.all);
      kind.byTouch[touching ? 1 : 0].common.add(std::min(units.common, units.all));
    }
  } else {
    // The first step at a level makes lists anew: what that takes does not belong to the level. What its
    // contacts take does.
    const double expected = predict(cost, level, cost.level, finest, touching);
    cost.isNew = cost.level != 0;
    cost.level = static_cast<std::uint8_t>(level);
    follow(cost, slot, std::max(std::min(units.all, expected), units.contacts), units.onCredit);
  }
  cost.touching[slot] = touching;
  constexpr std::uint32_t kEvery = 64;
  if (kind.byTouch[touching ? 1 : 0].all.weight < kEvery || ++learned_ % kEvery == 0) updateEstimates(finest);
}

void CostModel::addToMeans(const PairCost& cost, int level, int finest, bool touching, double units) {
  const std::size_t touch = touching ? 1 : 0;
  Costs& costs = kinds_[indexOf(level, finest)].byTouch[touch];
  costs.all.add(units);
  if (level == finest || !(cost.units[0] > 0.0F) || cost.touching[0] != touching) return;
  costs.here.add(units);
  costs.finest.add(cost.units[0]);
  kinds_[indexOf(finest, finest)].byTouch[touch].all.add(cost.units[0]);
}

double CostModel::unknown(int level, int finest, bool touching) {
  return (touching ? kUnknownTouching : kUnknownApart) * std::pow(kUnknownRatio, finest - level);
}

/// Where nothing is known, a level costs what the best `known` one (0: none) makes likely, at the usual ratio
/// but for what any level costs.
double CostModel::likely(int level, int known, int finest, std::size_t touch) const {
  if (known == 0) return unknown(level, finest, touch == 1);
  const Costs& costs = kinds_[indexOf(known, finest)].byTouch[touch];
  const double units = std::max(costs.all.units, kLeastUnits);
  const double common = std::min(costs.common.units, units);
  return common + (units - common) * std::pow(kUnknownRatio, known - level);
}

void CostModel::grow(int finest) {
  int known = 0;
  while (indexOf(1, known + 1) < kinds_.size()) ++known;
  if (known >= finest) return;
  kinds_.resize(indexOf(finest, finest) + 1);
  for (int levels = known + 1; levels <= finest; ++levels) updateEstimates(levels);
}

void CostModel::updateEstimates(int finest) {
  updateEstimates(finest, 0);
  updateEstimates(finest, 1);
}

void CostModel::updateEstimates(int finest, std::size_t touch) {
  const auto costsOf = [&](int level) -> Costs& { return kinds_[indexOf(level, finest)].byTouch[touch]; };
  int best = 0;
  for (int level = finest; level >= 1; --level) {
    if (costsOf(level).all.weight > (best > 0 ? costsOf(best).all.weight : 0.0)) best = level;
  }
  const Costs& finestCosts = costsOf(finest);
  for (int level = finest; level >= 1; --level) {
    Costs& costs = costsOf(level);
    const double own = costs.all.with(likely(level, best, finest, touch));
    const double ratio = costs.here.units / std::max(costs.finest.units, kLeastUnits);
    const double known = costs.here.weight / (costs.here.weight + kPriorPairs);
    costs.estimate = std::max(own + (ratio * finestCosts.estimate - own) * known, kLeastUnits);
    costs.perEstimate = 1.0 / costs.estimate;
  }
}

void UnitTime::learn(double units, double milliseconds) {
  constexpr double kAlmostNone = 20.0;
  if (units < kAlmostNone || !(milliseconds > 0.0)) return;
  perUnit_.add(milliseconds / units);
  lately_.add(milliseconds / units);
}

double UnitTime::unitsIn(double milliseconds) const {
  const double perUnit = millisecondsPerUnit();
  return perUnit > 0.0 ? milliseconds / perUnit : 0.0;
}

double UnitTime::millisecondsPerUnit() const {
  // Steps in which units take longer than usual should fit too, but odd ones need not. A machine that has
  // become slower is believed after five steps, one that has become faster after sixteen.
  constexpr double kUsual = 0.5;
  constexpr double kSlow = 0.95;
  constexpr double kSlowest = 1.06;
  // A slow step is rarely alone: the next may be slower by as much again. What is very slow happens once.
  constexpr double kAgain = 1.05;
  constexpr double kOdd = 1.5;
  const double usual = std::max(perUnit_.at(kUsual), lately_.at(kUsual));
  if (!(usual > 0.0)) return 0.0;
  const double last = std::clamp(perUnit_.last(), usual, kOdd * usual);
  return std::max(std::min(perUnit_.at(kSlow), kSlowest * usual), last * std::min(last / usual, kAgain));
}

}  // namespace scatter::lod
