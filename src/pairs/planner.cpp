#include "pairs/planner.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "lod/make_policy.h"
#include "pairs/ground_step.h"

namespace scatter::pairs {

using lod::PairView;
using lod::PlannedPair;
using lod::SwitchKind;
using lod::Wish;

namespace {

/// Policies look at a pair every so many steps, and at a new one at once.
constexpr int kAdviceInterval = 4;

/// Whether what has fallen asleep without its detail can have it is looked at every so many steps: half a
/// second, as it goes through all pairs.
constexpr int kOwedInterval = 30;

/// Portions of the pairs of a step that may put off their look, after each of which threads wait for each
/// other: half of them, half of what is left, and so on, as the more is known of a step the later it is.
/// `scatter bench budget --families rooms,implosion,bowl,sleepers --seeds 1,2,3 --scale 0.5`: of 22320 frames
/// with 5 portions 8 are over 1.02 and 4 over 1.05, with 7 portions 4 and 3, with 20 equal ones 6 and 3.
constexpr int kPortions = 7;

/// A pair on credit is taken to cost what it did in about so many steps.
constexpr float kCostMemory = 8.0F;

// Twice the logarithm to base 2, so that kinds differ by less than a half.
std::uint8_t kindOf(double numChildPairs) {
  const int kind = static_cast<int>(2 * std::log2(std::max(numChildPairs, 1.0)));
  return static_cast<std::uint8_t>(std::min(kind, PlannedPair::kKinds - 1));
}

// Contacts, if the budget asks for it.
bool mayKeep(const PlannedPair& planned) {
  const PairView& view = planned.view;
  const bool isPlain = planned.hasContacts && (!view.credited || view.level == view.finest);
  return isPlain && planned.wish.atLeast < view.finest;
}

int portionAt(int place, int count) {
  int portion = 0;
  for (int left = count - place; portion + 1 < kPortions && 2 * left <= count; left *= 2) ++portion;
  return portion;
}

// Of a pair that would have been coarser if that had been safe.
bool wasRefused(const PairOutcome& outcome, int target) {
  if (!outcome.tried) return false;
  return outcome.choice.kind == SwitchKind::kBlocked || outcome.choice.level > target;
}

// But for new pairs.
bool hasGoneFiner(const PairOutcome& outcome, int before) {
  const bool switches =
      outcome.choice.kind == SwitchKind::kFree || outcome.choice.kind == SwitchKind::kOnCredit;
  return outcome.tried && switches && before > 0 && outcome.choice.level > before;
}

}  // namespace

Result<void> Planner::addPolicy(std::string_view specification) {
  auto policy = lod::makePolicy(specification, policies_.grouping());
  if (!policy) return fail(policy.error().message);
  policies_.add(std::move(*policy));
  return {};
}

Result<void> Planner::checkPolicy(std::string_view specification) const {
  const auto policy = lod::makePolicy(specification, policies_.grouping());
  if (!policy) return fail(policy.error().message);
  return {};
}

void Planner::removePolicies() {
  policies_ = lod::PolicyList();
  advisesAll_ = true;
  for (PlannedPair& planned : planned_) planned.wish = Wish();
}

void Planner::setHeld(std::vector<const void*> objects) {
  held_ = std::move(objects);
  advisesAll_ = true;
}

void Planner::addPair(PlannedBody& a, PlannedBody& b, int levels, double numChildPairs, int* place) {
  PlannedPair planned;
  planned.view.finest = static_cast<std::uint8_t>(levels);
  planned.target = planned.view.finest;
  planned.identity = numCreated_++;
  planned.kind = kindOf(numChildPairs);
  *place = countPairs();
  planned_.push_back(planned);
  known_.push_back({.bodies = {&a, &b}, .place = place, .targetBefore = planned.target, .step = step_});
}

void Planner::addGround(PlannedBody& body, PlannedBody& ground, int levels, int parts, int* place) {
  addPair(body, ground, levels, parts, place);
  known_.back().isGround = true;
  known_.back().coarsest = coarsestOnGround(levels);
  planned_.back().wish.atLeast = static_cast<std::uint8_t>(known_.back().coarsest);
}

void Planner::removePair(int pair) {
  const auto i = static_cast<std::size_t>(pair);
  if (known_[i].request.stands) {
    ++counts_.retractions;
    tell(LevelEventKind::kRetracted, i, planned_[i].view.level, planned_[i].target, false);
  }
  planned_[i] = planned_.back();
  planned_.pop_back();
  known_[i] = known_.back();
  *known_[i].place = pair;
  known_.pop_back();
}

void Planner::lookUpBodies(std::size_t pair) {
  planned_[pair].view.a = known_[pair].bodies[0]->index();
  planned_[pair].view.b = known_[pair].bodies[1]->index();
}

void Planner::showPairs() {
  views_.resize(planned_.size());
  for (std::size_t i = 0; i < planned_.size(); ++i) {
    lookUpBodies(i);
    views_[i] = planned_[i].view;
  }
}

void Planner::advise(std::size_t pair) {
  PlannedPair& planned = planned_[pair];
  const Known& known = known_[pair];
  planned.wish = Wish();
  const std::size_t bodies = situation_.bodies.size();
  if (!policies_.empty() && planned.view.a < bodies && planned.view.b < bodies)
    planned.wish = policies_.advise(situation_, planned.view);
  if (known.coarsest > 1) {
    planned.wish.atLeast = std::max(planned.wish.atLeast, static_cast<std::uint8_t>(known.coarsest));
    planned.wish.atMost = std::max(planned.wish.atMost, planned.wish.atLeast);
  }
  // A sensor that is told of what is not there would not be of use.
  for (const PlannedBody* body : known.bodies) {
    if (!body->hasResponse() || isHeld(*body)) planned.wish.atLeast = planned.view.finest;
  }
}

bool Planner::isHeld(const PlannedBody& body) const {
  return !held_.empty() && std::ranges::find(held_, body.object()) != held_.end();
}

void Planner::applyAsked(std::size_t pair) {
  Wish& wish = planned_[pair].wish;
  for (const PlannedBody* body : known_[pair].bodies) {
    const int asked = body->askedLevel();
    if (asked <= 0 || asked >= wish.atMost) continue;
    wish.atMost = static_cast<std::uint8_t>(asked);
    wish.askedBy = kByProgram;
  }
}

void Planner::plan(const PlanInput& input) {
  ++step_;
  own_ = {};
  const std::size_t turns = std::exchange(turns_, 0);
  budget_.begin(input.load, input.clock);
  plans_ = budget_.isLimited() || !policies_.empty() || asks_ || numBelowFinest_ > 0;
  if (!plans_) return;
  budget_.look(input.bodies, input.timeStep);
  if (!policies_.empty()) {
    showPairs();
    situation_.bodies = input.bodies;
    situation_.pairs = views_;
    situation_.step = static_cast<std::uint64_t>(step_);
    situation_.load.units = budget_.lastUnits();
    situation_.load.budget = budget_.budgetUnits().given;
    policies_.observe(situation_);
  }
  for (std::size_t i = 0; i < planned_.size(); ++i) {
    PlannedPair& planned = planned_[i];
    if (planned.blockedSteps > 0) --planned.blockedSteps;
    planned.taken = planned.bound = 0.0F;
    const bool isItsTurn = (static_cast<int>(i) + step_) % kAdviceInterval == 0;
    if (isItsTurn || asks_ || advisesAll_) advise(i);
    if (asks_) applyAsked(i);
    known_[i].targetBefore = planned.target;
  }
  advisesAll_ = false;
  budget_.plan(planned_, settings_.creditLevel);
  for (std::size_t i = 0; i < planned_.size(); ++i) followRequest(i);
  partOut(turns);
}

// In the order in which their turns came in the step before, as it changes little. Who had none comes last.
void Planner::findTurns(std::size_t turns) {
  const bool isLimited = budget_.isLimited();
  inTurn_.assign(isLimited ? turns : 0, kNobody);
  for (std::size_t i = 0; i < planned_.size(); ++i) {
    const PlannedPair& planned = planned_[i];
    Known& known = known_[i];
    known.keeps = false;
    known.portion = kNoPortion;
    if (!isLimited || planned.target != planned.view.level || !mayKeep(planned)) continue;
    if (known.step == step_ - 1 && known.turn < turns) {
      inTurn_[known.turn] = i;
    } else {
      inTurn_.push_back(i);
    }
  }
  std::erase(inTurn_, kNobody);
}

void Planner::partOut(std::size_t turns) {
  findTurns(turns);
  const auto count = static_cast<int>(inTurn_.size());
  portions_.assign(kPortions, {});
  for (int next = 0; next < count; ++next) {
    const int portion = portionAt(next, count);
    const auto place = static_cast<std::size_t>(next);
    known_[inTurn_[place]].portion = portion;
    Portion& its = portions_[static_cast<std::size_t>(portion)];
    if (its.end == 0) its.first = place;
    its.end = place + 1;
  }
}

// As many keep their contacts as save what is missing, those first that did not in the step before: who has
// kept some may have come too far by now. A pair that has another place by now, as one before it has ended,
// looks for them.
void Planner::beginPortion(int index) {
  Portion& portion = portions_[static_cast<std::size_t>(index)];
  if (portion.hasBegun) return;
  portion.hasBegun = true;
  budget_.revise();
  double missing = budget_.missing();
  for (const bool hasKept : {false, true}) {
    for (std::size_t place = portion.first; place < portion.end && missing > 0.0; ++place) {
      const std::size_t i = inTurn_[place];
      if (i >= planned_.size() || known_[i].portion != index || known_[i].hasKept != hasKept) continue;
      known_[i].keeps = true;
      missing -= budget_.savedByKeeping(planned_[i]);
    }
  }
}

void Planner::followRequest(std::size_t pair) {
  const PlannedPair& planned = planned_[pair];
  PairRequest& request = known_[pair].request;
  const std::uint8_t before = known_[pair].targetBefore;
  if (planned.view.level == 0) return;
  if (planned.target == planned.view.level) {
    if (!request.stands) return;
    request.stands = request.tried = false;
    ++counts_.retractions;
    tell(LevelEventKind::kRetracted, pair, planned.view.level, before, false);
    return;
  }
  if (request.stands && planned.target == before) return;
  if (!request.stands) request.stepMade = step_;
  request.stands = true;
  request.tried = false;
  tell(LevelEventKind::kRequested, pair, planned.view.level, planned.target, false);
}

void Planner::acknowledge(std::size_t pair) {
  PairRequest& request = known_[pair].request;
  if (!request.stands || request.tried) return;
  request.tried = true;
  tell(LevelEventKind::kAcknowledged, pair, planned_[pair].view.level, planned_[pair].target, false);
}

void Planner::tell(LevelEventKind kind, std::size_t pair, int from, int to, bool onCredit) const {
  if (listener_ == nullptr) return;
  listener_->hear({.kind = kind,
                   .a = known_[pair].bodies[0],
                   .b = known_[pair].bodies[1],
                   .from = from,
                   .to = to,
                   .onCredit = onCredit,
                   .asker = askerOf(static_cast<int>(pair))});
}

Asker Planner::askerOf(int index) const {
  const PlannedPair& planned = pair(index);
  const bool byProgram = planned.wish.askedBy == kByProgram;
  const bool isKnown = byProgram || planned.wish.askedBy < policies_.size();
  const bool isWish = planned.wish.atMost < planned.view.finest && planned.target <= planned.wish.atMost;
  if (planned.byBudget || !isKnown || !isWish)
    return budget_.isLimited() ? Asker{"governor", Scope::kGlobal} : Asker{"default", Scope::kLocal};
  if (byProgram) return {"program", Scope::kLocal};
  const lod::Policy& policy = policies_[planned.wish.askedBy];
  return {policy.name().data(), policy.scope()};
}

int Planner::targetOf(std::size_t pair) {
  PlannedPair& planned = planned_[pair];
  if (planned.view.level > 0) return planned.target;
  planned.target = planned.view.finest;
  if (!plans_) return planned.target;
  lookUpBodies(pair);
  advise(pair);
  if (asks_) applyAsked(pair);
  budget_.planNew(planned);
  return planned.target;
}

lod::SwitchRules Planner::rulesOf(std::size_t pair) const {
  const PlannedPair& planned = planned_[pair];
  lod::SwitchRules rules;
  // What saves cost must not cost: a pair that is apart goes coarser for the budget only where that is free.
  rules.credit = settings_.credit && (planned.view.touching || !planned.byBudget);
  rules.safe = settings_.safe;
  rules.creditLevel = std::min(settings_.creditLevel, planned.view.finest - 1);
  return rules;
}

bool Planner::easesContacts(std::size_t pair) const {
  const Known& known = known_[pair];
  return known.bodies[0]->easesContacts() && known.bodies[1]->easesContacts();
}

// Queries that a pair with contacts must have made before it should keep its contacts for this step, as the
// budget is about to be exceeded. Those of coarser shapes on credit are held ones, whose audits are put off.
int Planner::keepsFrom(std::size_t pair) {
  const PlannedPair& planned = planned_[pair];
  if (!plans_ || !mayKeep(planned)) return PairPlan::kNever;
  const int portion = known_[pair].portion;
  if (portion != kNoPortion) {
    beginPortion(portion);
    return known_[pair].keeps ? 0 : PairPlan::kNever;
  }
  for (int queries = 0; queries <= planned.view.finest; ++queries) {
    if (budget_.isShortAfterQueries(queries)) return queries;
  }
  return PairPlan::kNever;
}

float Planner::auditsFrom() const {
  if (!(settings_.auditDistance > 0.0F)) return lod::lateness::kNever;
  return plans_ ? budget_.auditsFrom() : lod::lateness::kDue;
}

PairPlan Planner::planPair(int index) {
  const auto i = static_cast<std::size_t>(index);
  PairPlan plan;
  plan.target = targetOf(i);
  const PlannedPair& planned = planned_[i];
  plan.view = planned.view;
  const bool canWait =
      plan.target > plan.view.level && plan.view.level >= planned.wish.atLeast && !planned.mustSave;
  const bool isPutOff =
      plan.view.level > 0 && (planned.blockedSteps > 0 ||
                              (canWait && plans_ && budget_.isShortOfFiner(planned, known_[i].isGround)));
  plan.tries = plan.target != plan.view.level && !isPutOff;
  plan.rules = rulesOf(i);
  if (plan.tries && plan.rules.credit) plan.rules.credit = easesContacts(i);
  plan.auditDistance = settings_.auditDistance;
  plan.auditsFrom = auditsFrom();
  plan.keepsFrom = keepsFrom(i);
  return plan;
}

void Planner::take(int index, const PairOutcome& outcome) {
  if (!plans_ && isPlain(outcome)) {
    takeUnplanned(index, outcome, unplanned_);
    return;
  }
  const auto i = static_cast<std::size_t>(index);
  const int before = planned_[i].view.level;
  if (outcome.tried) acknowledge(i);
  takeQueries(outcome.choiceQueries);
  if (outcome.tried) takeChoice(i, outcome.choice);
  counts_.unsafeSwitches += outcome.isUnsafe ? 1 : 0;
  assert(!outcome.isUnsafe || !settings_.safe);
  takeQueries(outcome.gapQueries);
  if (outcome.audited) {
    ++counts_.audits;
    ++counts_.separationQueries;
    budget_.countAudit(outcome.auditWork);
  }
  if (outcome.late >= lod::lateness::kLate) {
    ++counts_.overduePairs;
    budget_.countOverdue(outcome.lateNext);
  }
  takeWork(i, outcome, before);
}

void Planner::takeQueries(int queries) {
  counts_.separationQueries += queries;
  budget_.spendQueries(queries);
}

void Planner::takeBlocked(std::size_t pair) {
  PlannedPair& planned = planned_[pair];
  ++counts_.blockedTries;
  // Not all at once again.
  const int interval = settings_.retryInterval;
  const int wait = interval + static_cast<int>(planned.identity % static_cast<unsigned>(interval));
  planned.blockedSteps = static_cast<std::uint8_t>(std::min(wait, 255));
  tell(LevelEventKind::kBlocked, pair, planned.view.level, planned.target, false);
}

void Planner::takeChoice(std::size_t pair, const lod::SwitchChoice& choice) {
  PlannedPair& planned = planned_[pair];
  const int from = planned.view.level;
  if (choice.kind == SwitchKind::kBlocked) {
    takeBlocked(pair);
    return;
  }
  planned.view.level = static_cast<std::uint8_t>(choice.level);
  known_[pair].isOwed = planned.byBudget;
  if (from == 0) return;
  const bool onCredit = choice.kind == SwitchKind::kOnCredit;
  budget_.spendSwitch();
  counts_.creditSwitches += onCredit ? 1 : 0;
  ++(choice.level < from ? counts_.switchesCoarser : counts_.switchesFiner);
  tell(LevelEventKind::kSwitched, pair, from, choice.level, onCredit);
  if (choice.level == planned.target) known_[pair].request.stands = known_[pair].request.tried = false;
}

void Planner::count(const PlannedPair& planned) {
  ++counts_.pairs;
  counts_.finestPairs += planned.view.level == planned.view.finest ? 1 : 0;
  counts_.creditedPairs += planned.view.credited ? 1 : 0;
}

void Planner::takeQuiet(int index) {
  if (!plans_) {
    takeQuiet(index, unplanned_);
    return;
  }
  const auto i = static_cast<std::size_t>(index);
  const int portion = portionOf(index);
  if (portion != kNoPortion) beginPortion(portion);
  known_[i].step = step_;
  budget_.takeQuiet(planned_[i]);
  budget_.learn(planned_[i], planned_[i].view.touching, {});
  count(planned_[i]);
}

void Planner::takeQuiet(int index, UnplannedPairs& pairs) const {
  ++pairs.all;
  ++pairs.quiet;
  pairs.atFinest += isAtFinest(index) ? 1 : 0;
}

void Planner::takeUnplanned(int index, const PairOutcome& outcome, UnplannedPairs& pairs) {
  const auto i = static_cast<std::size_t>(index);
  PlannedPair& planned = planned_[i];
  known_[i].step = step_;
  planned.taken = static_cast<float>(budget_.unplanned(outcome.work));
  takeContacts(planned, outcome);
  const int finest = isAtFinest(index) ? 1 : 0;
  const int touching = outcome.touching ? 1 : 0;
  pairs += {.all = 1,
            .atFinest = finest,
            .touching = touching,
            .touchingFinest = finest * touching,
            .work = outcome.work};
}

void Planner::settleUnplanned() {
  counts_.pairs += unplanned_.all;
  counts_.finestPairs += unplanned_.atFinest;
  counts_.touchingPairs += unplanned_.touching;
  counts_.touchingFinest += unplanned_.touchingFinest;
  budget_.takeUnplanned(unplanned_.work, unplanned_.all - unplanned_.quiet);
  unplanned_ = {};
}

void Planner::takeWork(std::size_t pair, const PairOutcome& outcome, int before) {
  PlannedPair& planned = planned_[pair];
  PairView& view = planned.view;
  Known& known = known_[pair];
  lod::PairUnits units = budget_.takeWork(planned, outcome.work);
  known.step = step_;
  known.turn = turns_++;
  known.hasKept = outcome.work.reuses;
  if (wasRefused(outcome, planned.target)) planned.bound = planned.taken;
  if (hasGoneFiner(outcome, before)) budget_.learnFiner(planned, units.all);
  own_.manifolds += outcome.work.manifolds;
  own_.points += outcome.work.contacts;
  counts_.reusedPairs += outcome.work.reuses ? 1 : 0;
  units.onCredit = outcome.credited && view.level < view.finest;
  if (units.onCredit) {
    known.averageUnits += (static_cast<float>(units.all) - known.averageUnits) / kCostMemory;
    units.all = static_cast<double>(known.averageUnits);
  }
  if (!outcome.work.reuses) budget_.learn(planned, outcome.touching, units);
  takeContacts(planned, outcome);
  count(planned);
  counts_.touchingPairs += outcome.touching ? 1 : 0;
  counts_.touchingFinest += outcome.touching && view.level == view.finest ? 1 : 0;
}

void Planner::takeContacts(PlannedPair& planned, const PairOutcome& outcome) {
  PairView& view = planned.view;
  constexpr std::uint16_t kMost = std::numeric_limits<std::uint16_t>::max();
  if (!outcome.touching) {
    view.contactSteps = 0;
  } else if (view.contactSteps < kMost) {
    ++view.contactSteps;
  }
  view.touching = outcome.touching;
  planned.hasContacts = outcome.work.contacts > 0;
  view.credited = outcome.credited;
}

void Planner::finish() {
  settleUnplanned();
  budget_.finish(plans_);
  numBelowFinest_ = numOwed_ = 0;
  for (std::size_t i = 0; plans_ && i < planned_.size(); ++i) finishPair(i);
  counts_.units = budget_.units();
  counts_.plannedUnits = plans_ ? budget_.plannedUnits() : 0.0;
  counts_.budgetUnits = budget_.budgetUnits();
  counts_.hiddenContacts = budget_.hiddenContacts();
  counts_.iterationsLeftOut = budget_.iterationsLeftOut();
  if (budget_.isExceeded()) counts_.floorUnits = budget_.floorUnits(planned_);
  settleState();
  lastCounts_ = counts_;
  counts_ = {};
}

void Planner::settleState() {
  const BudgetState before = budgetState_;
  budgetState_ = plans_ ? budget_.state(counts_.floorUnits) : BudgetState();
  budgetState_.steps = budgetState_.verdict == before.verdict ? before.steps + 1 : 1;
  if (budgetState_.verdict == BudgetVerdict::kNone) return;
  budgetState_.creditedPairs = counts_.creditedPairs;
  budgetState_.overduePairs = counts_.overduePairs;
  budgetState_.keptPairs = counts_.reusedPairs;
  budgetState_.hiddenContacts = counts_.hiddenContacts;
  budgetState_.iterationsLeftOut = counts_.iterationsLeftOut;
  budgetState_.withheldPairs = static_cast<int>(std::ranges::count_if(planned_, [](const PlannedPair& pair) {
    return pair.byBudget && pair.view.level < std::min(pair.wish.atMost, pair.view.finest);
  }));
}

void Planner::finishPair(std::size_t pair) {
  PlannedPair& planned = planned_[pair];
  numBelowFinest_ += planned.view.level < planned.view.finest ? 1 : 0;
  // Gaps would stay as long as the bodies sleep.
  const bool isCoarse = planned.view.touching && planned.view.level < planned.view.finest;
  if (isCoarse || planned.wish.importance > 1.0F) {
    for (PlannedBody* body : known_[pair].bodies) body->wakefulStep_ = step_;
  }
  counts_.requests += known_[pair].request.stands ? 1 : 0;
  planned.rests = known_[pair].step != step_ && planned.view.level > 0;
  numOwed_ += restsOwed(pair) ? 1 : 0;
}

bool Planner::restsOwed(std::size_t pair) const {
  const PlannedPair& planned = planned_[pair];
  return planned.rests && planned.view.touching && known_[pair].isOwed &&
         planned.view.level < std::min(planned.wish.atMost, planned.view.finest);
}

void Planner::findOwed(std::vector<PlannedBody*>& bodies) {
  bodies.clear();
  if (numOwed_ == 0 || step_ % kOwedInterval != 0) return;
  resting_.clear();
  for (std::size_t i = 0; i < planned_.size(); ++i) {
    if (!planned_[i].rests) continue;
    resting_.add(*known_[i].bodies[0], *known_[i].bodies[1], budget_.unitsAwake(planned_[i]), restsOwed(i));
  }
  resting_.wake(budget_.roomToWake(), bodies);
  for (std::size_t i = 0; i < planned_.size(); ++i) {
    const bool isWoken = resting_.isWoken(*known_[i].bodies[0]) || resting_.isWoken(*known_[i].bodies[1]);
    if (!isWoken) continue;
    if (restsOwed(i)) known_[i].isOwed = false;
    planned_[i].rests = false;
  }
  lastCounts_.wokenBodies = static_cast<int>(bodies.size());
}

// A recording asks after every step, of a pile that is coarse all over: a body is found again by what it
// remembers.
void Planner::findCoarser(std::vector<CoarserBody>& bodies) const {
  bodies.clear();
  for (std::size_t i = 0; numBelowFinest_ > 0 && i < planned_.size(); ++i) {
    const PairView& view = planned_[i].view;
    if (view.level == 0 || view.level >= view.finest) continue;
    for (PlannedBody* body : known_[i].bodies) {
      if (body->coarser_ == PlannedBody::kNowhere) {
        body->coarser_ = static_cast<int>(bodies.size());
        bodies.push_back({body, view.level});
      }
      int& level = bodies[static_cast<std::size_t>(body->coarser_)].level;
      level = std::min(level, static_cast<int>(view.level));
    }
  }
  for (const CoarserBody& found : bodies) found.body->coarser_ = PlannedBody::kNowhere;
}

void Planner::takeTime() {
  if (budget_.takeTime()) lastCounts_.floorUnits = budget_.floorUnits(planned_);
}

int Planner::findFinerPair(const void* object) const {
  for (std::size_t i = 0; i < known_.size(); ++i) {
    const bool isOne = known_[i].bodies[0]->object() == object || known_[i].bodies[1]->object() == object;
    // Pairs that are asleep, or that do not collide, hold up nobody.
    if (!isOne || known_[i].step != step_) continue;
    const Wish& wish = planned_[i].wish;
    if (planned_[i].view.level > std::max(wish.atMost, wish.atLeast)) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace scatter::pairs
