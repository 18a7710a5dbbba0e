#pragma once

#include <cstdint>

#include "lod/situation.h"

namespace scatter::lod {

enum class SwitchKind : std::uint8_t {
  kStay,      ///< The level is what it should be.
  kFree,      ///< The shapes of the new level are apart.
  kOnCredit,  ///< They overlap, and the overlap becomes credit.
  kBlocked,   ///< No switch is safe now.
};

struct SwitchChoice {
  SwitchKind kind = SwitchKind::kStay;
  int level = 0;
};

struct SwitchRules {
  bool credit = true;   ///< Off: only levels that are apart.
  int creditLevel = 2;  ///< The coarsest level that a pair in contact takes on credit.
  bool safe = true;     ///< Off only to show what the safety condition prevents.

  /// A finer level whose shapes overlap by no more than this can be taken on credit, metres. What is pressed
  /// apart already comes on top of it.
  float finerOverlap = 0.02F;
};

/// The state machine of a pair (report, section 3.4.3, widened): Free, while the broadphase bounds are apart,
/// then Engaged at a level.
/// - A new pair takes the level it should have if the shapes are apart there, else the coarsest finer one at
/// which
///   they are, else the finest.
/// - Coarser: the coarsest level on the way at which they are apart; if they are at none, the pair goes
/// coarser on
///   credit.
/// - Finer: the finest level on the way at which they are apart. A pair without credit that does not touch is
/// apart at
///   all finer levels, as they lie inside. Nearly apart is taken on credit.
/// `isSeparated(level, gap)` tells whether the two bodies' shapes at a level are proven to be more than `gap`
/// apart; with a negative gap, to overlap by no more.
template <class IsSeparated>
[[nodiscard]] SwitchChoice chooseLevel(const PairView& pair, int target, const SwitchRules& rules,
                                       IsSeparated&& isSeparated) {
  if (target == pair.level) return {SwitchKind::kStay, pair.level};
  if (!rules.safe) return {SwitchKind::kFree, target};
  if (pair.level == 0) {
    int level = target;
    while (level < pair.finest && !isSeparated(level, 0.0F)) ++level;
    return {SwitchKind::kFree, level};
  }
  if (target < pair.level) {
    for (int level = target; level < pair.level; ++level) {
      if (isSeparated(level, 0.0F)) return {SwitchKind::kFree, level};
    }
    const int level = target > rules.creditLevel ? target : rules.creditLevel;
    if (rules.credit && level < pair.level) return {SwitchKind::kOnCredit, level};
    return {SwitchKind::kBlocked, pair.level};
  }
  for (int level = target; level > pair.level; --level) {
    if (isSeparated(level, 0.0F)) return {SwitchKind::kFree, level};
  }
  if (rules.credit && isSeparated(target, -rules.finerOverlap)) return {SwitchKind::kOnCredit, target};
  return {SwitchKind::kBlocked, pair.level};
}

}  // namespace scatter::lod
