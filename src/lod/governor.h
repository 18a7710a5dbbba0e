#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lod/convergence.h"
#include "lod/cost_model.h"
#include "lod/planned_pair.h"
#include "lod/price_cut.h"
#include "lod/recent_quantile.h"

namespace scatter::lod {

struct GovernorDef {
  /// The coarsest level that a pair in contact takes on credit.
  int creditLevel = 2;
};

/// The global policy: keeps the cost of a step within a budget. Plans before the narrowphase, from the cost
/// model's predictions and their trend. Clock-free: budgets and costs are in units. Deterministic.
///
/// A step can cost more than was foreseen. What that is like is learned, and as much is kept free; and while
/// a step under way is about to exceed its budget, what can wait for the next one is put off (isShort()).
///
/// Three levers, in the order in which they come into play as the budget gets tight:
/// - Admission. Pairs that are apart, and new ones, may have their wish while there is room; as it gets less,
///   so does the share of them, most important and cheapest first. This is where most is decided: a pair that
///   comes into contact coarsely stays cheap, and keeps the pile around it loose.
/// - Relief. Pairs in contact go coarser on credit, those first that save most for what is lost: the dearest.
/// - When there is room again, detail is given back to pairs in contact, a little in each step.
///
/// A budget below what there is no way around is not kept whatever is given up: where that is next to nothing
/// besides the rest, all have their wish (isVain()).
class Governor {
 public:
  explicit Governor(const GovernorDef& def) : def_(def) {}

  /// As GovernorDef has it, from the next plan on.
  void setCreditLevel(int level) { def_.creditLevel = level; }

  /// Sets `target` and `byBudget` of every pair. `budget`: units for the whole step; infinite for none.
  /// `fixed`: units of the step that no level changes (bodies, broadphase). The target is within the wish,
  /// even while the pair is blocked.
  void plan(std::span<PlannedPair> pairs, const CostModel& costs, double fixed, double budget);

  /// Before plan(): so many pairs are going to come up after it. What they take is kept free until they have:
  /// as much as new pairs did last.
  void awaitNew(int pairs) { awaited_ = pairs; }

  /// Before plan(): which pairs are going to come in the steps after it.
  void expect(const PairsToCome& pairs) { toCome_ = pairs; }

  /// The level for a pair that has come up after plan() (its view.level is 0).
  [[nodiscard]] int planNew(const PlannedPair& pair, const CostModel& costs);

  /// In the narrowphase, after each pair: what it did cost. `full`: what it would have cost if nothing had
  /// been put off.
  void spend(PlannedPair& pair, double units, double full) {
    spent_ += units;
    pair.taken = static_cast<float>(units);
    saved_ += full - units;
    if (full > units) reuseSaves_ += kReuseMemory * ((full - units) / full - reuseSaves_);
    if (full == units) took_.add(units, correction_ * static_cast<double>(pair.expected));
    remaining_ -= pair.expected;
    pair.expected = 0.0F;
    if (pair.cost.level == 0) newUnits_ += kNewMemory * (units - newUnits_);
    if (pair.view.credited && pair.view.touching && full == units) learnCredit(pair, units);
  }
  void spend(double units) { spent_ += units; }

  /// Of what the step under way is expected to cost besides the fixed units, as much as has been spent.
  [[nodiscard]] double shareSpent() const { return spent_ > 0.0 ? spent_ / (comesTo() - fixed_) : 0.0; }

  /// The step under way may cost this instead.
  void revise(double budget) { budget_ = budget; }

  /// A pair went to the finer level that it has now, which did cost so much in this step.
  void learnFiner(const PlannedPair& pair, const CostModel& costs, double units);

  /// Whether the step under way is about to exceed its budget: what can be put off to the next one should be.
  /// `more`: units that are going to be spent.
  [[nodiscard]] bool isShort(double more = 0.0) const { return missing() + more > 0.0; }

  /// Units that putting off is to save then; negative if the step is not short.
  [[nodiscard]] double missing() const { return comesTo() - kShort * budget_; }

  /// About what a pair saves in this step by keeping the contacts of the step before.
  [[nodiscard]] double savedByKeeping(const PlannedPair& pair) const {
    return reuseSaves_ * correction_ * static_cast<double>(pair.expected);
  }

  /// Whether it comes to more than the budget itself, of which a little is kept as long as it may be.
  [[nodiscard]] bool isOver() const { return comesTo() > budget_; }

  /// Whether it would if a pair took the finer level that is its target. `fromNothing`: nothing of what the
  /// pair knows of its parts is kept, as of a body and its ground.
  [[nodiscard]] bool isShortOfFiner(const PlannedPair& pair, const CostModel& costs, bool fromNothing) const;

  /// After each planned step: what it did cost, fixed units included, to correct the next plans.
  void learn(double actualUnits);

  /// Units that the step just made would have cost, as far as is known, had every pair been at the coarsest
  /// level that it may have in its place: what it took where that is its own or was cheaper.
  [[nodiscard]] double floorUnits(std::span<const PlannedPair> pairs, const CostModel& costs) const;

  /// What a pair in contact would cost at its finest level: as it did, else as others of its kind do.
  [[nodiscard]] double finestUnits(const PlannedPair& pair, const CostModel& costs) const;

  /// What a pair that rests would cost if it woke, at its finest level if it is in contact.
  [[nodiscard]] double unitsAwake(const PlannedPair& pair, const CostModel& costs) const;

  /// Units that the step just planned has left for detail; none where giving it up would not help.
  [[nodiscard]] double room() const;

  /// About what the step would cost with every pair at the coarsest level that it may have, as known a few
  /// steps ago; the fixed units alone without a budget.
  [[nodiscard]] double reachableUnits() const { return fixed_ + coarsest_; }

  /// What the plan expects the step to cost; grows with each planNew().
  [[nodiscard]] double planned() const { return fixed_ + correction_ * predicted_; }

  /// Whether giving up detail would not help: the budget is impossible, and would be by almost as much.
  [[nodiscard]] bool isVain() const { return vainSteps_ >= kVainSteps; }

  /// From 0 to 1: the share of ordinary pairs, of those that are apart, that may have their wish.
  [[nodiscard]] double admission() const { return admission_; }

 private:
  /// About what the step under way is going to cost.
  [[nodiscard]] double comesTo() const {
    return fixed_ + spent_ + took_.dearness(correction_ * predicted_) * correction_ * remaining_ +
           awaited_ * newUnits_;
  }

  void planUnlimited(std::span<PlannedPair> pairs, const CostModel& costs);
  void grantAll(std::span<PlannedPair> pairs, const CostModel& costs, double room);
  void weighStakes(std::span<const PlannedPair> pairs, const CostModel& costs);
  void weighDetail(double budget);
  void planPair(PlannedPair& pair, const CostModel& costs);
  [[nodiscard]] double survey(std::span<PlannedPair> pairs, const CostModel& costs);
  void forecast(double budget, double detail);
  void foreseeFloor(std::span<const PlannedPair> pairs, const CostModel& costs);
  void await();
  [[nodiscard]] double giveBackLimit(double foreseen) const;
  void learnKind(const PlannedPair& pair, double units);
  void learnCredit(const PlannedPair& pair, double units);
  void shareOut();
  [[nodiscard]] double creditUnits(const PlannedPair& pair, int level, double now) const;
  [[nodiscard]] double stakeOf(const PlannedPair& pair, const CostModel& costs) const;
  [[nodiscard]] bool isAdmitted(const PlannedPair& pair) const;
  [[nodiscard]] int levelFor(const PlannedPair& pair, bool isAdmitted) const;
  [[nodiscard]] int levelApart(const PlannedPair& pair, const CostModel& costs, int now) const;
  [[nodiscard]] double savedUnits(const PlannedPair& pair, const CostModel& costs, int level) const;
  [[nodiscard]] int switchApart(const PlannedPair& pair, const CostModel& costs, int now);
  void relieve(std::span<PlannedPair> pairs, const CostModel& costs, double excess);
  void acceptRelief(std::span<PlannedPair> pairs, const CostModel& costs, double excess);
  void giveBack(std::span<PlannedPair> pairs, const CostModel& costs, double room);
  [[nodiscard]] double bestCost() const;
  void accept(std::span<PlannedPair> pairs, double room, double sign);

  /// What pairs have taken of the step under way, and what they were expected to.
  struct Taken {
    double units = 0.0;
    double expected = 0.0;

    void add(double moreUnits, double moreExpected) {
      units += moreUnits;
      expected += moreExpected;
    }

    /// How many times what they are expected to those that are left will take, of `all`: a crash makes all
    /// contacts of a step dearer. At least as they are expected to.
    [[nodiscard]] double dearness(double all) const {
      const double known = kKnown * all;
      return units > expected && known > 0.0 ? (known + units) / (known + expected) : 1.0;
    }
  };

  /// Pairs of a kind: what a touching one costs at its finest level; what those on credit cost, and what they
  /// did cost at their finest level; and the share of them that is admitted, of those that are at their
  /// finest level already and of the others.
  struct Kind {
    double units = 0.0;
    double weight = 0.0;
    double onCredit = 0.0;
    double beforeCredit = 0.0;
    double share[2]{1.0, 1.0};
  };

  static constexpr double kShort = 0.97;  ///< Of the budget: from where on a step puts off what it can.
  static constexpr double kReuseMemory = 0.005;

  /// Of what all pairs are expected to take, as much as is taken to be known of a step before its first pair
  /// has had its turn, so that a few dear ones do not decide. `scatter bench budget --seeds 1,2,3 --scale 0.5
  /// --families implosion,rooms,wheel_stack,sleepers,wheels_box,bowl,wheels_mesh`: of 38880 frames 4 are over
  /// 1.05 with 0.1 or 0.25, 6 with 1 or without this (16 portions, of which all keep their contacts or none).
  static constexpr double kKnown = 0.1;
  static constexpr double kNewMemory = 0.125;

  /// So long it must be so before detail is let alone: half a second, in which a budget may have been a slip.
  static constexpr int kVainSteps = 30;

  GovernorDef def_;
  std::array<Kind, PlannedPair::kKinds> kinds_{};
  double fixed_ = 0.0;
  double predicted_ = 0.0;      ///< Units besides the fixed ones, not corrected.
  double budget_ = 0.0;         ///< Units that the step may cost.
  double spent_ = 0.0;          ///< Of the step under way, besides the fixed units.
  Taken took_;                  ///< Of that, by pairs that have put nothing off.
  double remaining_ = 0.0;      ///< What its pairs are still expected to take, not corrected.
  int awaited_ = 0;             ///< Pairs that are still expected to come up in it.
  double newUnits_ = 0.0;       ///< What a new pair takes in its first step.
  double saved_ = 0.0;          ///< By putting off.
  double lastActual_ = 0.0;     ///< 0: nothing was learned yet.
  double capacity_ = 0.0;       ///< Units a step may be planned to cost.
  double contactUnits_ = 0.0;   ///< Of pairs in contact at their finest level.
  double missingUnits_ = 0.0;   ///< What pairs in contact would cost more at their finest level.
  double foreseen_ = 0.0;       ///< What the step was expected to cost when its narrowphase began.
  RecentQuantile<32> misses_;   ///< How much more steps did cost.
  double reuseSaves_ = 0.2;     ///< Of what a pair costs: what it saves when its contacts are reused.
  double firstLook_ = 0.0;      ///< What a pair that goes finer takes in that step, more than usual there.
  double finerRoom_ = 0.0;      ///< Units left for pairs that are apart and get finer.
  double coarserRoom_ = 0.0;    ///< The same for those that get coarser.
  double trend_ = 0.0;          ///< Units a step by which steps get dearer.
  double coarsest_ = 0.0;       ///< What all pairs would cost as coarse as they may be.
  double middle_ = 0.0;         ///< The same with all at the middle level.
  PairsToCome toCome_;          ///< Of the steps after this one.
  double apartUnits_ = 0.0;     ///< What a pair that is apart costs as coarse as it may be, with its bounds.
  double lastFloor_ = 0.0;      ///< What reachableUnits() was when `coarsest_` was last found.
  RecentQuantile<3> growths_;   ///< Units a step by which that has grown: many bodies may come in one step.
  double floorTrend_ = 0.0;     ///< Units a step by which it grows; negative if it shrinks.
  double stake_ = 0.0;          ///< What detail costs that pairs in contact wish for.
  double stakeToCome_ = 0.0;    ///< The same with those that are likely to come into contact.
  double touchingShare_ = 1.0;  ///< Of pairs with detail to lose.
  int stepsToFloor_ = 0;        ///< Until these are found anew.
  int vainSteps_ = 0;           ///< For so many the budget has been impossible with little at stake.
  double admission_ = 1.0;
  int learnedSteps_ = 0;     ///< Ever, up to as many as it takes to be sure of what pairs cost.
  bool isFull_ = false;      ///< There is no room for detail, as far as is known by now.
  bool isMiddle_ = false;    ///< Pairs that are refused their wish get a middle level, not the least.
  double correction_ = 1.0;  ///< For predictions, from how much steps cost against what was predicted.
  RecentQuantile<16> ratios_;
  PriceSearch search_;
  std::vector<Offer> offers_;
};

}  // namespace scatter::lod
