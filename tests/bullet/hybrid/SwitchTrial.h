#pragma once

#include <BulletHybrid/btHybridDynamicsWorld.h>

#include <cstdint>
#include <string>

namespace scatter::test {

/// How the bodies of a trial are when they are given reasons to switch.
enum class Situation : std::uint8_t {
  kApart,     ///< At rest, near each other: no finest shapes touch, coarser ones overlap.
  kTouching,  ///< At rest, pressed against each other and let go.
  kDeep,      ///< Started inside each other, and driven apart by the contacts.
  kStacked,   ///< A pile on a floor, under gravity.
  kMoving     ///< Thrown at each other.
};
inline constexpr Situation kSituations[] = {Situation::kApart, Situation::kTouching, Situation::kDeep,
                                            Situation::kStacked, Situation::kMoving};

[[nodiscard]] const char* nameOf(Situation situation);

/// What switches did. What is compared is a step in which a world is given reasons to switch with the same
/// step of an exact copy that is given none.
struct SwitchTally {
  long moments = 0;   ///< Steps in which a world was given reasons.
  long switches = 0;  ///< In those steps.
  long coarser = 0;
  long onCredit = 0;

  /// Switches that the world itself counts as unsafe, in these and in all other steps.
  long unsafe = 0;

  /// Switches after which the contacts of the pair press the bodies apart deeper, by more than 2 mm, than the
  /// contacts that it has in the copy, which is at the same poses. Contacts without error reduction press
  /// nothing.
  long deeper = 0;

  /// Bodies whose pose, or whose velocities, had other bits after the collision detection than before.
  long moved = 0;
  long changedVelocity = 0;

  /// Bodies at rest that are further from where they are in the copy than the copy's own have moved, and a
  /// millimetre; in a pile, and what falls freely in a step, as finer shapes may leave room below.
  long pushed = 0;

  /// Moments whose energy was compared: where the copy gains nothing, and at rest bodies are (slower than a
  /// twentieth of their size a second), else no contact presses bodies apart, neither before nor in the copy,
  /// as error reduction makes energy of its own.
  long weighed = 0;

  /// Moments that were not, because the copy, which does not switch, gained energy: bodies that are wedged
  /// into each other tremble, and error reduction lifts piles.
  long restless = 0;

  /// Moments that were not, because what they gained is of overlap that pairs which did not switch had
  /// before: nothing is gained once that presses nothing, with all else as it was. A body that goes finer
  /// lets go of what was wedged below it.
  long released = 0;

  /// Of those weighed, moments after whose step, and at rest in the 10 steps that follow, there was more
  /// energy than before and than in the copy. More is a ten-thousandth, what makes all bodies move at a
  /// centimetre a second, and what lifts a pile by a tenth of a millimetre. The most that was gained, as a
  /// multiple of that.
  long gained = 0;
  double mostGained = 0;

  /// The first of what went wrong: where and by how much.
  std::string complaint;

  SwitchTally& operator+=(const SwitchTally& other);
  [[nodiscard]] bool isClean() const {
    return unsafe == 0 && deeper == 0 && moved == 0 && changedVelocity == 0 && pushed == 0 && gained == 0;
  }
};

struct SwitchTrialDef {
  Situation situation = Situation::kApart;
  btHybridSwitchingMode mode = BT_HYBRID_PAIR_SWITCHING;
  std::uint64_t seed = 1;
  int moments = 24;
  bool safetyConditions = true;  ///< Off: to show that a trial sees bad switches.
};

/// Builds a random world (bodies of 0.1 to 10 m, of all kinds of parts, two to four levels), brings it into
/// the situation, and gives it reasons to switch: requests, budgets, policies. The copy is a copy of the
/// process (POSIX only), so that it is exact.
[[nodiscard]] SwitchTally runSwitchTrial(const SwitchTrialDef& def);

}  // namespace scatter::test
