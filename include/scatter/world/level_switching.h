#pragma once

#include <scatter/lod/budget_state.h>
#include <scatter/lod/budget_units.h>
#include <scatter/math.h>
#include <scatter/result.h>
#include <scatter/world/body.h>
#include <scatter/world/level_event.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace scatter {

/// What makes requests in a hybrid world.
enum class Policy : std::uint8_t {
  kProximity,  ///< Coarser when level-1 bounds come near others, finer when free (report, section 4.5).
  kFinest,     ///< Everything at level n, always.
  kCoarsest,   ///< Everything at level 1, always.
  kNone,       ///< Only what the program asks for.
};

/// What has a level.
enum class Switching : std::uint8_t {
  kPair,  ///< Every pair of bodies: one neighbour can be met finely and another one coarsely.
  kBody,  ///< Every body, the same for all its neighbours (report, sections 3.4.3 and 4.5).
};

/// What a step may cost, for pair switching; at most one of the three.
struct BudgetDef {
  double milliseconds = 0.0;  ///< Of processor time; 0: no budget. Depends on the clock, but for `machine`.
  double units = 0.0;         ///< Of predicted cost; 0: no budget. The same run after run.

  /// Step by step, as LevelSwitching::budgetUnits() gave them in an earlier run, which is repeated exactly;
  /// after the last one it stays. Empty: none. What is revised or settled to 0 stays as it was given.
  std::vector<BudgetUnits> recorded{};

  /// Of a budget of milliseconds: those that a unit takes, each above 0, step by step, and after the last
  /// from the first again. Then the clock is not asked: the same run after run. Empty: as the clock has it.
  std::vector<double> machine{};
};

struct SwitchingDef {
  Switching switching = Switching::kPair;

  Policy policy = Policy::kNone;

  /// Pair switching: more policies, as makePolicy() of src/lod knows them, such as "speed" or "speed:from=5".
  std::vector<std::string> policies{};

  BudgetDef budget{};

  /// Pair switching: the coarsest level that a pair in contact takes, on penetration credit.
  int creditLevel = 2;
  bool credit =
      true;  ///< Off: pairs in contact go coarser only when apart; with unsafe switching, regardless.

  /// The proximity margin is the distance that the fastest body travels in this many steps, so that a
  /// request comes at least that many steps before the level-1 boxes can touch (report, section 6.3.1). 0:
  /// once they overlap, as in the report's own tests.
  float proximitySteps = 3.0F;

  int retryInterval = 10;   ///< Steps between tries of a request whose safety condition failed.
  int quietSteps = 30;      ///< Steps without a neighbour before a finer level is asked for.
  float safetyGap = 0.01F;  ///< Metres that must separate the shapes for a switch to be safe.

  /// "The load is fine" while fewer narrowphase pairs than this are at work: standing requests are then
  /// retracted and none are made. 0: never.
  std::uint32_t loadFinePairs = 0;

  /// Off only to reproduce what the safety conditions prevent (report, Figures 3.5 and 3.6).
  bool safetyConditions = true;
};

/// Where the viewer looks, for policies that ask.
struct ViewFocus {
  Vec3 eye{0.0F};
  Vec3 target{0.0F};
  float fieldOfView = 1.0F;  ///< Vertical, radians.
};

/// The levels of a world's bodies: which are in use, who asks for others, and what a step may cost. What is
/// not overridden does what an engine without levels does: every body has one level, and whatever is asked
/// for is refused. Ids that are unknown are programming errors and are asserted.
class LevelSwitching {
 public:
  LevelSwitching() = default;
  LevelSwitching(const LevelSwitching&) = delete;
  LevelSwitching& operator=(const LevelSwitching&) = delete;
  virtual ~LevelSwitching() = default;

  /// The level in use, 1 the coarsest; bodies that are not hybrids have one level.
  [[nodiscard]] virtual int level(BodyId /*body*/) const { return 1; }
  [[nodiscard]] virtual int levelCount(BodyId /*body*/) const { return 1; }

  /// Asks for a level; the request stands until the body has switched or it is retracted. False, and
  /// nothing happens, in a standard world or if there is no such level.
  virtual bool requestLevel(BodyId /*body*/, int /*level*/, Scope /*scope*/) { return false; }
  virtual void retractRequest(BodyId /*body*/) {}
  virtual void retractAllRequests() {}

  /// The level in use between two bodies whose broadphase bounds overlap, 1 the coarsest; 0 if they do not,
  /// or if neither has levels.
  [[nodiscard]] virtual int pairLevel(BodyId /*a*/, BodyId /*b*/) const { return 0; }

  /// With pair switching, of each body the coarsest level over its pairs, the finest if it is in none, at the
  /// index of its id; 0 where there is no body. Emptied where each body has one level for all its pairs: then
  /// level() is what is in use.
  virtual void coarsestLevels(std::vector<std::uint8_t>& levels) const { levels.clear(); }

  /// What the last step was allowed to cost. Repeats the run exactly when given as BudgetDef::recorded.
  [[nodiscard]] virtual BudgetUnits budgetUnits() const { return {}; }

  /// What has become of the budget in the last step; without one, and in engines that take none, so it says.
  [[nodiscard]] virtual BudgetState budgetState() const { return {}; }

  /// What a step may cost from the next one on; a default BudgetDef ends the budget. Clock-free budgets leave
  /// the run the same every time. Values that are negative or not finite are asserted, and refused with a
  /// line to stderr without asserts. False, and nothing happens, where they are, and where there are no
  /// budgets: they need pair switching.
  virtual bool setBudget(const BudgetDef& /*budget*/) { return false; }

  /// Replaces the policies of SwitchingDef from the next step on; requests that the program has made stand.
  /// Fails, and nothing happens, on a list that SwitchingDef would not take, in a standard world, and on
  /// named policies with body switching, which has none.
  [[nodiscard]] virtual Result<void> setPolicies(Policy /*policy*/,
                                                 const std::vector<std::string>& /*policies*/) {
    return fail("this world has no policies; start it as a hybrid world");
  }

  /// Changes what has a level. Every body is brought to its finest level, woken, and stays where it is;
  /// requests are retracted, policies and budget start anew. Fails, and nothing happens, in a standard world,
  /// and while it would push bodies apart: where pairs on penetration credit overlap finely by more than 2
  /// cm. Starting the scene again with the other switching always works.
  [[nodiscard]] virtual Result<void> setSwitching(Switching /*switching*/) {
    return fail("this world has no levels that switch; start it as a hybrid world");
  }

  /// What the user holds is to be at its finest level, budget or not, as soon as that is safe: all its pairs,
  /// or with body switching the body. False, and nothing happens, in a standard world.
  virtual bool setHeld(BodyId /*body*/, bool /*held*/) { return false; }

  /// Where the viewer looks, for the policy "focus"; empty: nobody does. What is never told changes nothing.
  virtual void setFocus(const std::optional<ViewFocus>& /*focus*/) {}

  /// What happened to requests in the last step and in the calls between it and the step before, oldest
  /// first. Valid until the next step.
  [[nodiscard]] virtual std::span<const LevelEvent> levelEvents() const { return {}; }
};

}  // namespace scatter
