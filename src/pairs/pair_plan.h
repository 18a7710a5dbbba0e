#pragma once

#include <limits>

#include "collision/part_pair.h"
#include "lod/audit_room.h"
#include "lod/cost_model.h"
#include "lod/pair_switch.h"

namespace scatter::pairs {

/// What a pair is to do in one step, and may.
struct PairPlan {
  lod::PairView view{};  ///< Its level, finest level, and whether it touches.
  int target = 1;        ///< The level that it should have.
  bool tries = false;    ///< It is to switch there now, if that is safe.
  lod::SwitchRules rules{};

  float auditsFrom = lod::lateness::kNever;  ///< How late they are that are made.
  float auditDistance = 0.0F;                ///< Metres; see CreditState.

  /// It may keep the contacts of the step before if it has not switched, and made at least so many queries
  /// about levels.
  int keepsFrom = kNever;
  static constexpr int kNever = std::numeric_limits<int>::max();
};

/// How far the parts of a pair, or of a body and its ground, may move against each other without a look for
/// contacts, metres. Small bodies may move less: a multiple of the distance at which their contacts end,
/// which is a fiftieth of their size. Bodies of a metre have the usual audit distance.
[[nodiscard]] inline float furthestUnseen(const PairPlan& plan, float threshold) {
  constexpr float kThresholds = 1.5F;
  return plan.auditDistance < kThresholds * threshold ? plan.auditDistance : kThresholds * threshold;
}

/// What has become of a pair in one step.
struct PairOutcome {
  bool tried = false;
  lod::SwitchChoice choice{};
  bool isUnsafe =
      false;  ///< A switch presses the bodies apart deeper than the contacts of the level before would.

  int choiceQueries = 0;  ///< About levels, before the switch.
  int gapQueries = 0;     ///< About the gap between the finest shapes, after it.
  bool audited = false;

  lod::PairWorkload work{};       ///< Of all.
  lod::PairWorkload auditWork{};  ///< Of these, of the audit.

  bool touching = false;
  bool credited = false;
  float late = 0.0F;      ///< How late an audit is that was not made.
  float lateNext = 0.0F;  ///< How late it is going to be if the pair goes on moving as it does.
};

/// Whether a pair has looked for its contacts at the level that it had, and nothing else.
[[nodiscard]] inline bool isPlain(const PairOutcome& outcome) {
  const bool asks = outcome.tried || outcome.choiceQueries > 0 || outcome.gapQueries > 0 || outcome.audited;
  const bool isOnCredit = outcome.credited || outcome.isUnsafe || outcome.late >= lod::lateness::kLate;
  return !asks && !isOnCredit && !outcome.work.reuses;
}

/// What became of pairs that were plain, or left without a look, in a step without a plan: sums, to which it
/// is of no matter in which order pairs had their turn.
struct UnplannedPairs {
  int all = 0;
  int quiet = 0;  ///< Of those, left without a look.
  int atFinest = 0;
  int touching = 0;
  int touchingFinest = 0;
  lod::PairWorkload work{};  ///< Of all.

  UnplannedPairs& operator+=(const UnplannedPairs& other) {
    all += other.all;
    quiet += other.quiet;
    atFinest += other.atFinest;
    touching += other.touching;
    touchingFinest += other.touchingFinest;
    work.counts += other.work.counts;
    work.contacts += other.work.contacts;
    work.manifolds += other.work.manifolds;
    return *this;
  }
};

}  // namespace scatter::pairs
