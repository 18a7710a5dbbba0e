#include "lod/governor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scatter::lod {
namespace {

// Of the capacity: up to where all may have their wish, from where on nobody, and what relief aims at.
constexpr double kAllBelow = 0.94;
constexpr double kNoneFrom = 1.02;
constexpr double kRelieved = 0.99;

// Of the capacity: up to where detail is given back if all that is missing would not fit; what that may take
// in one step, and pairs that are apart and get finer or coarser: as much as is left, within bounds.
constexpr double kGiveBackBelow = 0.9;
constexpr double kGiveBack = 0.05;
constexpr double kFiner = 0.03;
constexpr double kLeastCoarser = 0.03;
constexpr double kCoarser = 0.12;

// Steps in which what pairs cost is a guess, half a second: a scene that begins with a pile would lose detail
// that it could afford. docs/budget-figures.md has what else was tried.
constexpr int kUnsureSteps = 30;

// Of the capacity: a load with all detail that is as good as fitting, and one that certainly does not fit.
constexpr double kFits = 1.05;
constexpr double kFitsNot = 1.3;

// Budgets, in what all pairs would cost at the middle level: enough for it, and too little again.
constexpr double kMiddleRoom = 1.3;
constexpr double kMiddleKept = 1.1;

// Of the budget: what is kept for what is not foreseen, as much as almost all of the last steps needed,
// within bounds.
constexpr double kMissShare = 0.95;
constexpr double kLeastHeadroom = 0.03;
constexpr double kMostHeadroom = 0.25;
constexpr double kLeastKept = 0.02;

// Of what pairs in contact cost at their finest level, in what contacts that are reused save: on what can be
// counted, as no pair does it twice running.
constexpr double kReused = 0.3;

// Steps by which the trend is foreseen. Of ten implosions (`scatter bench budget --families implosion --scale
// 0.5`, seeds 21 to 30), with 4, 6, 8, 10 steps 0.16, 0.11, 0.06, 0.01 % of the frames are over 1.02 and
// 0.07, 0.01, 0, 0 % over 1.05; with 1.5 floors 73, 62, 56, 56 of a hundred touching pairs are at their
// finest level.
constexpr double kForesight = 6.0;
constexpr double kTrendShare = 0.25;

// Steps in which what is given may be had back: so far ahead room is kept for what there is no way around.
constexpr double kHorizon = Convergence::kHorizon;

// Pairs to come, in what a pair that is apart takes as coarse as it may be: each of those that may have
// their wish before contact is taken for so many, as some of them will touch. And of what is free with all
// as coarse as they may be: up to so much of it for those to come, detail is given back to others all the
// same. docs/budget-figures.md has what others did.
constexpr double kOfPairToCome = 1.5;
constexpr double kFewToCome = 0.7;

// Steps from one look at that to the next, and how much of the newest trend, which is the middle one of
// three, is believed: less of one that falls, as a pile that is forming grows by fits and starts.
// docs/budget-figures.md has what other shares did.
constexpr int kFloorEvery = 4;
constexpr double kRisingShare = 0.3;
constexpr double kFallingShare = 0.15;

// Of what there is no way around: detail that is not worth giving up if the budget is impossible, as much as
// a budget may be exceeded by; from where on it is again. `scatter bench budget --seeds 1,2 --scale 0.5
// --floors 0.3,0.6,0.9`: with these it stays where many other bodies are, and nowhere else.
constexpr double kVain = 0.05;
constexpr double kVainNoMore = 0.08;

// What a pair costs on credit: the contacts that it holds, and looking at its finest shapes now and then.
// The guess counts as much as so many looks at a pair on credit.
constexpr double kHeldUnits = 3.0;
constexpr double kPriorLooks = 10.0;
constexpr double kAuditShare = 0.3;

// Of the capacity: what switches to relieve a step may cost in it. They are looked at at both levels.
constexpr double kRelief = 0.06;
constexpr double kReliefShare = 0.25;  // Of what is too much, where that is more.

// So many units must a switch save a step.
constexpr double kWorthwhile = 1.0;

// What a touching pair loses on credit, and at a coarser level without, in the detail of a finest pair.
constexpr float kCreditLoss = 0.3F;
constexpr float kCoarseLoss = 0.8F;

// Once admitted, a pair is not turned away for a little less room.
constexpr double kLoyalty = 0.1;

// Of the last steps' actual against predicted units, for the correction.
constexpr double kCorrectionShare = 0.6;
constexpr double kLeastCorrection = 0.5;
constexpr double kMostCorrection = 2.5;

constexpr float kLeastImportance = 0.01F;
constexpr float kMostImportance = 100.0F;

int lowest(const PlannedPair& pair) {
  return std::clamp<int>(pair.wish.atLeast, 1, pair.view.finest);
}

int highest(const PlannedPair& pair) {
  return std::max(std::min<int>(pair.wish.atMost, pair.view.finest), lowest(pair));
}

// The level that is taken on credit: with two levels the coarser one.
int middleOf(const PlannedPair& pair, int creditLevel) {
  return std::max(std::min<int>(creditLevel, pair.view.finest - 1), 1);
}

// In this order, what is not a number becomes the least.
float importanceOf(const PlannedPair& pair) {
  return std::min(std::max(kLeastImportance, pair.wish.importance), kMostImportance);
}

// Evenly spread over 0 to 1.
double lot(std::uint32_t identity) {
  constexpr std::uint32_t kGolden = 2654435769U;
  return static_cast<double>(identity * kGolden) / 4294967296.0;
}

// How much more cheap pairs are preferred than they are cheaper.
constexpr double kThrift = 3.0;

// What a body and its ground may take in the step in which it goes finer, in what they take in others: each
// of its parts is looked at, and from nothing. Of hundreds of parts it is 1.4 to 3.1, of few what firstLook_
// has learned. Without and with it `scatter bench budget --families rooms --scale 0.5` has 5 and 3 frames
// over 1.05 in 11520 of seeds 1 to 6, 14 and 4 in 19200 of 11 to 15 and 21 to 25. Two bodies keep more of
// what they know: if they wait as well, slabs of 64 bricks never get back the detail that they could afford.
constexpr double kFirstLook = 3.0;

// Keeps ratios finite.
constexpr double kLeastKindUnits = 0.01;

// Lists made anew, and pieces of a ground looked up: 1 to 2 units of most switches, 7 of bodies on a mesh.
// With none, a step that made 180 pairs coarser at once took 1.13 of its budget (`scatter bench budget
// --families ships_mesh --seeds 3 --scale 0.5`).
constexpr double kNewLists = 4.0;

double switchUnits(const CostModel& costs) {
  return costs.weights().switched + costs.weights().separationQuery;
}

/// Besides what a pair usually takes at its new level.
double freshSwitchUnits(const CostModel& costs) {
  return switchUnits(costs) + kNewLists;
}

double predict(const PlannedPair& pair, const CostModel& costs, int level) {
  const PairView& view = pair.view;
  return costs.predict(pair.cost, level, view.level, view.finest, view.touching);
}

/// What a pair is going to take if it stays at its level: nothing if it rests, whatever it did take before.
double predictNext(const PlannedPair& pair, const CostModel& costs) {
  return pair.rests ? 0.0 : predict(pair, costs, pair.view.level);
}

}  // namespace

void Governor::plan(std::span<PlannedPair> pairs, const CostModel& costs, double fixed, double budget) {
  fixed_ = fixed;
  predicted_ = spent_ = saved_ = 0.0;
  budget_ = budget;
  if (std::isinf(budget)) {
    planUnlimited(pairs, costs);
    return;
  }
  const double detail = survey(pairs, costs);
  foreseeFloor(pairs, costs);
  weighDetail(budget);
  if (isVain()) {
    grantAll(pairs, costs, kFiner * (fixed_ + coarsest_));
    return;
  }
  forecast(budget, detail);
  shareOut();
  for (PlannedPair& pair : pairs) planPair(pair, costs);
  const double foreseen = planned() + kForesight * std::max(trend_, 0.0);
  if (foreseen > kRelieved * capacity_) relieve(pairs, costs, foreseen - kRelieved * capacity_);
  const double upTo = giveBackLimit(foreseen);
  if (foreseen < upTo) giveBack(pairs, costs, upTo - foreseen);
  for (PlannedPair& pair : pairs) pair.byBudget = pair.target < highest(pair) && pair.blockedSteps == 0;
  await();
}

/// The narrowphase comes next.
void Governor::await() {
  remaining_ = predicted_;
  took_ = {};
  foreseen_ = planned();
}

/// Detail that is given back makes a pile denser, and dearer than its pairs cost now: where all that is
/// missing would not fit, there must be room for that. So there must be for pairs to come: of bodies that
/// detail has let come closer there are more, and they stay when it is taken again.
double Governor::giveBackLimit(double foreseen) const {
  const double load = (foreseen + correction_ * missingUnits_) / capacity_;
  const double tightness = std::clamp((load - kFits) / (kFitsNot - kFits), 0.0, 1.0);
  const double toCome = apartUnits_ * std::min(toCome_.foreseen, toCome_.expected) -
                        kFewToCome * (capacity_ - reachableUnits());
  return (kAllBelow + (kGiveBackBelow - kAllBelow) * tightness) * capacity_ - std::max(toCome, 0.0);
}

void Governor::planUnlimited(std::span<PlannedPair> pairs, const CostModel& costs) {
  coarsest_ = middle_ = floorTrend_ = 0.0;
  growths_ = {};
  vainSteps_ = 0;
  grantAll(pairs, costs, std::numeric_limits<double>::infinity());
}

/// `room`: units for pairs that get finer; those that find none left wait for the next steps.
void Governor::grantAll(std::span<PlannedPair> pairs, const CostModel& costs, double room) {
  capacity_ = std::numeric_limits<double>::infinity();
  admission_ = 1.0;
  predicted_ = 0.0;
  shareOut();
  for (PlannedPair& pair : pairs) {
    const int level = pair.view.level;
    const bool mustWait = level > 0 && level < highest(pair) && room <= 0.0;
    pair.target = static_cast<std::uint8_t>(mustWait ? std::max(level, lowest(pair)) : highest(pair));
    pair.byBudget = pair.mustSave = false;
    pair.expected = pair.rests ? 0.0F : static_cast<float>(predict(pair, costs, pair.target));
    if (pair.target > level && level > 0 && !pair.rests)
      room -= correction_ * (freshSwitchUnits(costs) + static_cast<double>(pair.expected));
    predicted_ += static_cast<double>(pair.expected);
  }
  await();
}

/// What the pairs cost now; how much of that is detail in contacts.
double Governor::survey(std::span<PlannedPair> pairs, const CostModel& costs) {
  double detail = 0.0;
  contactUnits_ = missingUnits_ = 0.0;
  for (PlannedPair& pair : pairs) {
    pair.expected = 0.0F;
    if (pair.view.level == 0) continue;
    const double units = predictNext(pair, costs);
    predicted_ += units;
    pair.expected = static_cast<float>(units);
    if (pair.rests || (!pair.view.touching && !pair.view.credited)) continue;
    if (pair.view.level < pair.view.finest) missingUnits_ += std::max(finestUnits(pair, costs) - units, 0.0);
    if (!pair.view.touching) continue;
    if (pair.view.credited || pair.view.level == pair.view.finest) detail += units;
    if (!pair.view.credited && pair.view.level == pair.view.finest) {
      contactUnits_ += units;
      learnKind(pair, units);
    }
  }
  return detail;
}

/// Where all pairs as coarse as they may be are going to. What is foreseen is what there is no way around:
/// detail that is given while bodies are on their way must leave room for it.
void Governor::foreseeFloor(std::span<const PlannedPair> pairs, const CostModel& costs) {
  if (stepsToFloor_ > 0) {
    --stepsToFloor_;
    return;
  }
  stepsToFloor_ = kFloorEvery - 1;
  double coarsest = 0.0;
  double middle = 0.0;
  double apart = 0.0;
  int numApart = 0;
  for (const PlannedPair& pair : pairs) {
    const int level = pair.view.level;
    if (level == 0 || pair.rests) continue;
    const int low = std::min(lowest(pair), level);
    const int between = std::min(std::max(middleOf(pair, def_.creditLevel), low), level);
    const double least = predict(pair, costs, low);
    coarsest += least;
    middle += predict(pair, costs, between);
    if (pair.view.touching) continue;
    apart += least;
    ++numApart;
  }
  apartUnits_ = costs.weights().broadphasePair + std::max(correction_, 1.0) * apart / std::max(numApart, 1);
  // Where pairs take less than was predicted, as in a lull, they need not do so when they meet.
  const bool isFirst = !(coarsest_ > 0.0);
  coarsest_ = std::max(correction_, 1.0) * coarsest;
  middle_ = correction_ * middle;
  if (!isFirst) {
    growths_.add((reachableUnits() - lastFloor_) / kFloorEvery);
    const double news = growths_.at(0.5) - floorTrend_;
    floorTrend_ += (news > 0.0 ? kRisingShare : kFallingShare) * news;
  }
  lastFloor_ = reachableUnits();
  weighStakes(pairs, costs);
}

/// As large a share of the pairs that are apart as touches now, or did a second ago, may soon touch as well.
void Governor::weighStakes(std::span<const PlannedPair> pairs, const CostModel& costs) {
  constexpr double kMemory = kFloorEvery / 60.0;
  double apart = 0.0;
  double touching = 0.0;
  int all = 0;
  stake_ = 0.0;
  for (const PlannedPair& pair : pairs) {
    if (pair.view.level == 0 || pair.rests || highest(pair) <= lowest(pair)) continue;
    ++all;
    touching += pair.view.touching ? 1.0 : 0.0;
    (pair.view.touching ? stake_ : apart) += stakeOf(pair, costs);
  }
  if (all > 0) touchingShare_ = std::max(touching / all, touchingShare_ - kMemory * touchingShare_);
  stake_ *= correction_;
  stakeToCome_ = stake_ + correction_ * touchingShare_ * apart;
}

/// What a pair costs more in contact as it wishes than as coarse as it may be.
double Governor::stakeOf(const PlannedPair& pair, const CostModel& costs) const {
  const auto inContact = [&](int level) {
    return costs.predict(pair.cost, level, pair.view.level, pair.view.finest, true);
  };
  const int high = highest(pair);
  const double most = high == pair.view.finest ? finestUnits(pair, costs) : inContact(high);
  return std::max(most - inContact(lowest(pair)), 0.0);
}

void Governor::weighDetail(double budget) {
  const double least = fixed_ + coarsest_;
  const double part = isVain() ? kVainNoMore : kVain;
  const bool isImpossible = least > budget;
  const bool isLittle = stake_ <= part * least && stakeToCome_ <= 2.0 * part * least;
  vainSteps_ = isImpossible && isLittle ? std::min(vainSteps_ + 1, kVainSteps) : 0;
}

void Governor::forecast(double budget, double detail) {
  const double headroom = std::clamp(misses_.at(kMissShare), kLeastHeadroom * budget, kMostHeadroom * budget);
  const double reusable = kReused * reuseSaves_ * correction_ * contactUnits_;
  capacity_ = budget - std::max(headroom - reusable, kLeastKept * budget);
  // One level for all whom it refuses their wish, not changed for a little.
  const double growth =
      std::max(kHorizon * std::max(floorTrend_, 0.0), kOfPairToCome * apartUnits_ * toCome_.expected);
  isMiddle_ = capacity_ > (isMiddle_ ? kMiddleKept : kMiddleRoom) * (fixed_ + middle_ + growth);
  // What there will be no way around, as far as it does not cost it yet.
  const double reserve = std::max(fixed_ + coarsest_ + growth - (planned() - correction_ * detail), 0.0);
  const double foreseen = planned() + kForesight * std::max(trend_, 0.0) + reserve;
  admission_ =
      std::clamp((kNoneFrom * capacity_ - foreseen) / ((kNoneFrom - kAllBelow) * capacity_), 0.0, 1.0);
  isFull_ = admission_ <= 0.0 && learnedSteps_ >= kUnsureSteps;
  finerRoom_ = kFiner * capacity_;
  coarserRoom_ = std::clamp(capacity_ - planned(), kLeastCoarser * capacity_, kCoarser * capacity_);
}

// Lists made anew, and pieces of a ground looked up: a few large bodies take most of it.
void Governor::learnFiner(const PlannedPair& pair, const CostModel& costs, double units) {
  constexpr double kMemory = 1.0 / 16.0;
  const double usual = predict(pair, costs, pair.view.level);
  firstLook_ += kMemory * (std::max(units - usual, 0.0) - firstLook_);
}

bool Governor::isShortOfFiner(const PlannedPair& pair, const CostModel& costs, bool fromNothing) const {
  if (isVain()) return false;
  if (!fromNothing) return isShort(firstLook_);
  const double usual = std::max(predict(pair, costs, pair.view.level), predict(pair, costs, pair.target));
  return isShort(std::max(firstLook_, kFirstLook * usual - static_cast<double>(pair.expected)));
}

void Governor::learnKind(const PlannedPair& pair, double units) {
  constexpr double kMemory = 2000.0;  // pairs times steps
  Kind& kind = kinds_[pair.kind];
  kind.weight = std::min(kind.weight + 1.0, kMemory);
  kind.units += (units - kind.units) / kind.weight;
}

/// What pairs on credit cost against what they did, most of it in the last few hundred looks at one. The
/// dearest were chosen, of which many would have become cheaper: half of what they did cost more is left out.
void Governor::learnCredit(const PlannedPair& pair, double units) {
  constexpr double kKept = 0.998;
  if (!(pair.relieved > 0.0F) || pair.view.level >= pair.view.finest) return;
  Kind& kind = kinds_[pair.kind];
  kind.onCredit = kKept * kind.onCredit + units;
  kind.beforeCredit = kKept * kind.beforeCredit + 0.5 * (static_cast<double>(pair.relieved) + kind.units);
}

/// As detail costs less in one kind of pairs than in another, a larger share of them is admitted. Nothing is
/// known of kinds without weight.
void Governor::shareOut() {
  double units = 0.0;
  double weight = 0.0;
  for (const Kind& kind : kinds_) {
    units += kind.units * kind.weight;
    weight += kind.weight;
  }
  const double loyalty = std::min(kLoyalty, admission_);
  for (Kind& kind : kinds_) {
    for (const bool has : {false, true}) {
      double& share = kind.share[has ? 1 : 0];
      share = std::min(admission_ + (has ? loyalty : 0.0), 1.0);
      if (share >= 1.0 || kind.weight <= 0.0) continue;
      const double cheapness = units / (weight * std::max(kind.units, kLeastKindUnits));
      share = 1.0 - std::pow(1.0 - share, std::pow(cheapness, kThrift));
    }
  }
}

bool Governor::isAdmitted(const PlannedPair& pair) const {
  const bool has = pair.view.level == highest(pair);
  const double share = kinds_[pair.kind].share[has ? 1 : 0];
  const float importance = importanceOf(pair);
  if (importance == 1.0F || share <= 0.0 || share >= 1.0) return lot(pair.identity) < share;
  // As if so many pairs drew lots for it.
  return lot(pair.identity) < 1.0 - std::pow(1.0 - share, static_cast<double>(importance));
}

/// Of a pair that is apart: what it wishes for, else a middle level, else the least.
int Governor::levelFor(const PlannedPair& pair, bool isAdmitted) const {
  const int low = lowest(pair);
  const int high = highest(pair);
  if (isAdmitted) return high;
  return isMiddle_ ? std::clamp(middleOf(pair, def_.creditLevel), low, high) : low;
}

/// What a pair takes less in this step, and in those after it, if it goes to `level`.
double Governor::savedUnits(const PlannedPair& pair, const CostModel& costs, int level) const {
  return correction_ * (predict(pair, costs, pair.view.level) - predict(pair, costs, level));
}

/// Where a pair that is apart should be. At a middle level it hardly costs less than at its finest, where it
/// is near others: it goes there if there is no room at all, and it is one of those that do.
int Governor::levelApart(const PlannedPair& pair, const CostModel& costs, int now) const {
  const bool admitted = isAdmitted(pair);
  const int level = levelFor(pair, admitted);
  if (admitted || !isMiddle_) return level;
  const bool isTaken = isFull_ && savedUnits(pair, costs, level) > kWorthwhile;
  return isTaken ? std::min(level, now) : now;
}

/// The same as far as the step has room for switches. Where there is none for detail, one that gets coarser
/// pays with what it saves at once: the dearest are not held up.
int Governor::switchApart(const PlannedPair& pair, const CostModel& costs, int now) {
  const int level = levelApart(pair, costs, now);
  if (level == pair.view.level) return now;
  const bool isCoarser = level < pair.view.level;
  const double saved = isCoarser && isFull_ ? savedUnits(pair, costs, level) : 0.0;
  const double cost = freshSwitchUnits(costs) - std::max(saved, 0.0);
  double& room = isCoarser ? coarserRoom_ : finerRoom_;
  if (cost > 0.0 && room <= 0.0) return now;
  room -= std::max(cost, 0.0);
  return level;
}

// The wish's bounds, and pairs that are apart.
void Governor::planPair(PlannedPair& pair, const CostModel& costs) {
  const PairView& view = pair.view;
  const int high = highest(pair);
  int target = std::clamp<int>(view.level, lowest(pair), high);
  // Credit that does not pay.
  const bool isDear = !pair.rests && view.credited && view.touching && pair.blockedSteps == 0 &&
                      target < high &&
                      finestUnits(pair, costs) + kWorthwhile < predict(pair, costs, view.level);
  if (isDear) target = high;
  pair.mustSave = isDear;
  const bool isFree = !pair.rests && !view.touching && !view.credited && pair.blockedSteps == 0;
  if (isFree) target = switchApart(pair, costs, target);
  pair.target = static_cast<std::uint8_t>(target);
}

/// Pairs in contact on credit: what saves most for what is lost.
void Governor::relieve(std::span<PlannedPair> pairs, const CostModel& costs, double excess) {
  offers_.clear();
  for (std::uint32_t i = 0; i < pairs.size(); ++i) {
    const PlannedPair& pair = pairs[i];
    const int coarser = std::max(lowest(pair), middleOf(pair, def_.creditLevel));
    if (pair.rests || !pair.view.touching || pair.view.credited) continue;
    if (pair.target <= coarser || pair.blockedSteps > 0) continue;
    const double now = predict(pair, costs, pair.view.level);
    const double saved = now - creditUnits(pair, coarser, now);
    if (saved < kWorthwhile) continue;
    const auto units = static_cast<float>(saved * correction_);
    offers_.push_back(
        {units / (kCreditLoss * importanceOf(pair)), units, i, static_cast<std::uint8_t>(coarser)});
  }
  acceptRelief(pairs, costs, excess);
}

/// The best offers that save the excess, as far as the step has room for their switches. Lists made anew are
/// not among these: relief that waits costs more.
void Governor::acceptRelief(std::span<PlannedPair> pairs, const CostModel& costs, double excess) {
  const double each = switchUnits(costs);
  PriceCut cut = search_.find(offers_, std::max(excess, bestCost()));
  std::erase_if(offers_, [&](const Offer& offer) { return !cut.take(offer); });
  for (Offer& offer : offers_) {
    PlannedPair& pair = pairs[offer.pair];
    pair.relieved = static_cast<float>(predict(pair, costs, pair.view.level));
    offer.cost = static_cast<float>(correction_ * (each + static_cast<double>(pair.relieved)));
  }
  accept(pairs, std::max({kRelief * capacity_, kReliefShare * excess, bestCost()}), 1.0);
}

/// What a pair that costs `now` in contact would cost on credit at `level`: as it did, else as others of its
/// kind do; as long as little is known of these, as most do.
double Governor::creditUnits(const PlannedPair& pair, int level, double now) const {
  const std::size_t slot = PairCost::slotOf(level, pair.view.finest);
  const bool isKnown = pair.cost.units[slot] > 0.0F && pair.cost.touching[slot];
  if (isKnown) return static_cast<double>(pair.cost.units[slot]);
  const Kind& kind = kinds_[pair.kind];
  const double prior = kPriorLooks * now;
  const double ratio =
      (kind.onCredit + kPriorLooks * (kHeldUnits + kAuditShare * now)) / (kind.beforeCredit + prior);
  return ratio * now;
}

double Governor::finestUnits(const PlannedPair& pair, const CostModel& costs) const {
  const Kind& kind = kinds_[pair.kind];
  const bool isKnown = pair.cost.units[0] > 0.0F && pair.cost.touching[0];
  return isKnown || kind.weight <= 0.0 ? predict(pair, costs, pair.view.finest) : kind.units;
}

double Governor::unitsAwake(const PlannedPair& pair, const CostModel& costs) const {
  return pair.view.touching ? finestUnits(pair, costs) : predict(pair, costs, pair.view.level);
}

/// Pairs in contact, or on credit, at a finer level again: where most is seen for what it costs.
void Governor::giveBack(std::span<PlannedPair> pairs, const CostModel& costs, double room) {
  offers_.clear();
  for (std::uint32_t i = 0; i < pairs.size(); ++i) {
    const PlannedPair& pair = pairs[i];
    const int high = highest(pair);
    if (pair.rests || !(pair.view.touching || pair.view.credited)) continue;
    if (pair.target >= high || pair.blockedSteps > 0) continue;
    const double dearer = finestUnits(pair, costs) - predict(pair, costs, pair.view.level);
    const auto extra = static_cast<float>(correction_ * (std::max(dearer, 0.0) + costs.weights().switched));
    if (extra > room) continue;
    const float gain = (pair.view.credited ? kCreditLoss : kCoarseLoss) * importanceOf(pair);
    offers_.push_back({gain / extra, extra, i, static_cast<std::uint8_t>(high)});
  }
  accept(pairs, std::min(room, std::max(kGiveBack * capacity_, bestCost())), 1.0);
}

/// Of the best offer: with room for that, nothing that is too dear stands in the way of the others.
double Governor::bestCost() const {
  const auto best = std::max_element(offers_.begin(), offers_.end(),
                                     [](const Offer& a, const Offer& b) { return a.price < b.price; });
  return best == offers_.end() ? 0.0 : best->cost;
}

/// The best offers that fit into the room. `sign`: of what they add to the step's units.
void Governor::accept(std::span<PlannedPair> pairs, double room, double sign) {
  PriceCut cut = search_.find(offers_, room);
  for (const Offer& offer : offers_) {
    if (!cut.take(offer)) continue;
    pairs[offer.pair].target = offer.level;
    const double change = sign * (static_cast<double>(offer.cost) / correction_);
    predicted_ += change;
    pairs[offer.pair].expected += static_cast<float>(change);
  }
}

int Governor::planNew(const PlannedPair& pair, const CostModel& costs) {
  awaited_ = std::max(awaited_ - 1, 0);
  const int level = levelFor(pair, (isVain() || !isShort()) && isAdmitted(pair));
  predicted_ += predict(pair, costs, level);
  return level;
}

double Governor::room() const {
  return isVain() ? 0.0 : std::max(kAllBelow * capacity_ - planned(), 0.0);
}

double Governor::floorUnits(std::span<const PlannedPair> pairs, const CostModel& costs) const {
  double least = 0.0;
  for (const PlannedPair& pair : pairs) {
    const int level = pair.view.level;
    if (level == 0) continue;
    const int coarser = pair.view.touching ? middleOf(pair, def_.creditLevel) : 1;
    const int allowed = std::min(std::max(coarser, lowest(pair)), level);
    const auto taken = static_cast<double>(pair.taken);
    const double coarse =
        std::max(correction_ * predict(pair, costs, allowed), static_cast<double>(pair.bound));
    least += allowed < level ? std::min(coarse, taken) : taken;
  }
  return fixed_ + least;
}

void Governor::learn(double units) {
  const double actualUnits = units + saved_;
  misses_.add(actualUnits - foreseen_);
  if (lastActual_ > 0.0) trend_ += kTrendShare * (actualUnits - lastActual_ - trend_);
  lastActual_ = actualUnits;
  // Too little to tell anything.
  constexpr double kAlmostNone = 10.0;
  if (predicted_ < kAlmostNone) return;
  learnedSteps_ = std::min(learnedSteps_ + 1, kUnsureSteps);
  ratios_.add((actualUnits - fixed_) / predicted_);
  correction_ = std::clamp(ratios_.at(kCorrectionShare), kLeastCorrection, kMostCorrection);
}

}  // namespace scatter::lod
