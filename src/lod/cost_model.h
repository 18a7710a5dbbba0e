#pragma once

#include <scatter/collision/pair_algorithm.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lod/recent_quantile.h"

namespace scatter::lod {

/// Work of one pair in one step. Exact counts.
struct PairWorkload {
  PairWork counts{};
  int contacts = 0;  ///< Contact points handed to the solver.
  int manifolds = 0;
  bool reuses = false;  ///< Kept the contacts of the step before: no example of what a step costs.
};

/// What a step has to do whatever levels pairs have. Exact counts.
struct StepLoad {
  int objects = 0;
  int awake = 0;  ///< Of these, those that move and are not asleep.
  int broadphasePairs = 0;
  int joints = 0;
};

/// What of a step's contacts belongs to no pair that switches, and is solved: of bodies that are awake.
struct LooseContacts {
  int manifolds = 0;
  int points = 0;
};

/// What a pair did cost in a step.
struct PairUnits {
  double all = 0.0;
  double common = 0.0;    ///< Of these, what it would have cost at any level.
  double contacts = 0.0;  ///< Of these, what its contacts take in the next steps, too.

  /// At a coarser level, with contacts of the finest one that it held, and of coarser shapes as far as looks
  /// at the finest ones are late.
  bool onCredit = false;
};

/// What a unit of work costs, relative to each other: about microseconds on the machine they were fitted on,
/// by bench/costs/fit.
struct CostWeights {
  double step = 7.0;     ///< Whatever is in it.
  double object = 0.01;  ///< Of those that sleep, which the fit does not see.
  double awakeBody = 0.27;
  double broadphasePair = 0.35;
  double joint = 0.55;
  double looseManifold = 0.08;  ///< With what found its contacts.
  double pair = 0.05;
  double rebuild = 0.9;
  double childPair = 0.165;
  double gjkIteration = 0.06;
  double detectorRun = 0.6;
  double halfSpaceRun = 0.05;
  double contact = 0.2;
  double hiddenContact = 0.185;  ///< Of it: what is saved by a contact that the solver is not shown.
  double manifold = 0.06;
  double contactIteration = 0.013;  ///< Of a contact that the solver is shown: what an iteration less saves.
  double jointIteration = 0.03;     ///< The same of a joint.
  double piece = 0.2;               ///< Of a ground, looked up. The fit takes it as known.
  double separationQuery = 1.5;
  double audit = 0.5;     ///< The distance between the finest shapes, from scratch.
  double switched = 0.5;  ///< Besides the queries: contacts dropped, lists made anew.
};

/// What is remembered of one pair's cost, units a step.
struct PairCost {
  static constexpr int kRemembered = 4;

  /// By how many levels coarser than the finest; coarser ones share the last. What it costs, at `level`; what
  /// it cost there last, scaled by what has changed since, at others. 0: unknown.
  std::array<float, kRemembered> units{};
  std::array<bool, kRemembered> touching{};  ///< When that was learned.
  std::uint8_t level = 0;                    ///< The last one that was learned; 0: nothing was.
  bool isNew = false;                        ///< There: that was its first step at the level.

  [[nodiscard]] static std::size_t slotOf(int level, int finest) {
    return static_cast<std::size_t>(finest - level < kRemembered ? finest - level : kRemembered - 1);
  }
};

/// Predicts what a pair costs a step at each of its levels: from what it cost itself, else from what pairs of
/// its kind cost. Learns from every step. Deterministic.
class CostModel {
 public:
  explicit CostModel(const CostWeights& weights) : weights_(weights) {}

  [[nodiscard]] const CostWeights& weights() const { return weights_; }
  /// `pairs`: whose work it is, if it is of several.
  [[nodiscard]] double units(const PairWorkload& work, int pairs = 1) const;

  /// Of these, what contacts take that stay: with looking at their parts again.
  [[nodiscard]] double contactUnits(const PairWorkload& work) const;

  /// Of these, what a pair costs at any level.
  [[nodiscard]] double commonUnits(const PairWorkload& work) const;

  /// Of these, what it did cost in this step at any level: with what it looked up of its ground.
  [[nodiscard]] double boundUnits(const PairWorkload& work) const;
  [[nodiscard]] double units(const StepLoad& load) const;
  [[nodiscard]] double units(const LooseContacts& contacts) const;

  /// After a pair was processed at `level` of `finest`, 1 <= level <= finest: takes in what it cost. A pair
  /// that was left without a look because it is far apart cost 0. (0 does not count in what is known of other
  /// pairs.) What was learned of one that falls asleep stays, for when it wakes.
  void learn(PairCost& cost, int level, int finest, bool touching, const PairUnits& units);

  /// Units a step at `level` for a pair that is at `now` (0: new), without what the switch costs.
  [[nodiscard]] double predict(const PairCost& cost, int level, int now, int finest, bool touching) const {
    const std::size_t slot = PairCost::slotOf(level, finest);
    if (cost.units[slot] > 0.0F && (cost.touching[slot] == touching || level == now)) return cost.units[slot];
    return estimate(level, finest, touching) * likeness(cost, now, finest, touching);
  }

 private:
  struct Mean {
    double units = 0.0;
    double weight = 0.0;

    void add(double value);
    [[nodiscard]] double with(double prior) const;  ///< As if some pairs had been seen that cost `prior`.
  };

  /// What pairs of one kind cost at a level: those that touch, or those that do not.
  struct Costs {
    Mean all{};     ///< Of the pairs at the level. At the finest: of all pairs that ever were, by what is
                    ///< remembered.
    Mean common{};  ///< Of the pairs at the level: what they would cost at any other.

    /// Of the pairs at the level whose cost at the finest level is remembered: both costs. Who is at a
    /// coarser level is not chosen by chance, so means of different pairs do not compare.
    Mean here{};
    Mean finest{};

    double estimate = 0.0;     ///< With kinds that are like it where little is known.
    double perEstimate = 0.0;  ///< 1 / estimate.
  };

  /// A level of so many levels.
  struct Kind {
    std::array<Costs, 2> byTouch{};  ///< Not touching, touching.
  };

  [[nodiscard]] static std::size_t indexOf(int level, int finest) {
    return static_cast<std::size_t>(finest * (finest - 1) / 2 + level - 1);
  }
  [[nodiscard]] static double unknown(int level, int finest, bool touching);
  [[nodiscard]] double estimate(int level, int finest, bool touching) const {
    const std::size_t index = indexOf(level, finest);
    return index < kinds_.size() ? kinds_[index].byTouch[touching ? 1 : 0].estimate
                                 : unknown(level, finest, touching);
  }

  /// Half of what a pair costs more or less than its kind at one level is taken to hold at another one.
  [[nodiscard]] double likeness(const PairCost& cost, int now, int finest, bool touching) const {
    if (now == 0 || now != cost.level) return 1.0;
    const double perEstimate = kinds_[indexOf(now, finest)].byTouch[touching ? 1 : 0].perEstimate;
    const double ratio = cost.units[PairCost::slotOf(now, finest)] * perEstimate;
    return 0.5 + 0.5 * (ratio < kMostAlike ? ratio : kMostAlike);
  }

  void grow(int finest);
  void addToMeans(const PairCost& cost, int level, int finest, bool touching, double units);
  [[nodiscard]] double likely(int level, int known, int finest, std::size_t touch) const;
  void updateEstimates(int finest);
  void updateEstimates(int finest, std::size_t touch);

  static constexpr double kMostAlike = 4.0;

  CostWeights weights_;
  std::vector<Kind> kinds_;
  std::uint32_t learned_ = 0;
};

/// What a unit takes on this machine, learned from measured steps: a robust quantile over the last ones, and
/// more for the step after a slow one, as what slows steps down stays for a few. The only place where the
/// clock comes in.
class UnitTime {
 public:
  /// `milliseconds` is what a step of `units` took. Steps with almost no units tell nothing and are ignored.
  void learn(double units, double milliseconds);

  /// Units that fit into so many milliseconds. 0 as long as nothing was learned.
  [[nodiscard]] double unitsIn(double milliseconds) const;

  [[nodiscard]] double millisecondsPerUnit() const;

 private:
  RecentQuantile<31> perUnit_;
  RecentQuantile<9> lately_;
};

}  // namespace scatter::lod
