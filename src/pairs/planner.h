#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "lod/planned_pair.h"
#include "lod/policy_list.h"
#include "lod/situation.h"
#include "lod/step_budget.h"
#include "pairs/pair_plan.h"
#include "pairs/pair_request.h"
#include "pairs/planned_body.h"
#include "pairs/resting_islands.h"
#include "scatter/lod/budget_state.h"
#include "scatter/lod/pair_step_counts.h"
#include "scatter/result.h"

namespace scatter::pairs {

/// When and how pairs switch.
struct SwitchSettings {
  bool credit = true;           ///< Pairs in contact may go coarser on credit.
  int creditLevel = 2;          ///< The coarsest level that they take so; from 1.
  int retryInterval = 10;       ///< Steps between tries of a switch that was not safe; 1 to 255.
  float auditDistance = 0.03F;  ///< Metres; see PairPlan. 0: never.
  bool safe = true;             ///< Off only to show what the safety conditions prevent.
};

/// What a plan is made with.
struct PlanInput {
  std::span<const lod::BodyView> bodies{};  ///< Stays valid until the next plan. Only if needsBodies().
  lod::StepLoad load{};
  float timeStep = 1.0F / 60.0F;  ///< Seconds.
  lod::StepClock clock{};         ///< Until takeTime().
};

/// A body that meets others at a coarser level than it could, and the coarsest level in its pairs.
struct CoarserBody {
  PlannedBody* body;
  int level;
};

/// Says what level every pair should have: keeps the table of all pairs that switch, shows it to policies and
/// governor between broadphase and narrowphase, and follows what becomes of requests. For one thread.
class Planner {
 public:
  /// As they act. Before every plan, as the program may change them at any time.
  void setSettings(const SwitchSettings& settings) { settings_ = settings; }

  /// Adds what a specification names ("speed", …); the error says what is wrong with it.
  [[nodiscard]] Result<void> addPolicy(std::string_view specification);
  [[nodiscard]] Result<void> checkPolicy(std::string_view specification) const;
  void removePolicies();
  void setFocus(const lod::Focus& focus) { situation_.focus = focus; }
  void removeFocus() { situation_.focus.reset(); }
  void setBudget(lod::UnitBudget budget) { budget_.set(std::move(budget)); }
  [[nodiscard]] bool needsTime() const { return budget_.needsTime(); }

  /// Not owned; none: nullptr.
  void setListener(PairListener* listener) { listener_ = listener; }

  /// Whether a body is asked to be coarser than its finest level.
  void setAsks(bool asks) { asks_ = asks; }

  /// Objects whose pairs are to be finest, whatever else is asked for.
  void setHeld(std::vector<const void*> objects);

  /// A new pair, of bodies that outlive it. `place`: where its owner keeps its index, as long as it is there.
  void addPair(PlannedBody& a, PlannedBody& b, int levels, double numChildPairs, int* place);

  /// The same of a body and what it may lie on.
  void addGround(PlannedBody& body, PlannedBody& ground, int levels, int parts, int* place);
  void removePair(int pair);

  [[nodiscard]] int countPairs() const { return static_cast<int>(planned_.size()); }
  [[nodiscard]] const lod::PlannedPair& pair(int pair) const {
    return planned_[static_cast<std::size_t>(pair)];
  }
  [[nodiscard]] PlannedBody& body(int pair, int side) const {
    return *known_[static_cast<std::size_t>(pair)].bodies[side];
  }
  [[nodiscard]] bool isGround(int pair) const { return known_[static_cast<std::size_t>(pair)].isGround; }
  [[nodiscard]] const PairRequest& request(int pair) const {
    return known_[static_cast<std::size_t>(pair)].request;
  }

  /// What a pair took of the last step; 0 if it was left without a look.
  [[nodiscard]] float units(int pair) const {
    const auto i = static_cast<std::size_t>(pair);
    return known_[i].step == step_ ? planned_[i].taken : 0.0F;
  }
  [[nodiscard]] Asker askerOf(int pair) const;
  [[nodiscard]] int step() const { return step_; }
  [[nodiscard]] static std::size_t bytesOfPair() {
    return sizeof(Known) + sizeof(lod::PlannedPair) + sizeof(lod::PairView);
  }

  /// Whether plan() is to be given bodies.
  [[nodiscard]] bool needsBodies() const { return !policies_.empty() || budget_.needsBodies(); }

  /// The next so many steps share one budget.
  void shareBudget(int steps) { budget_.share(steps); }

  /// Whether a body may come to rest sooner than usual after this step, for the budget.
  [[nodiscard]] bool mayRestEarly(const PlannedBody& body) const { return body.wakefulStep_ != step_; }

  /// Whether any may: detail or contacts are given up, or the budget is exceeded.
  [[nodiscard]] bool restsEarly() const {
    return budgetState_.verdict > BudgetVerdict::kKept || budgetState_.hiddenContacts > 0 ||
           budgetState_.withheldPairs > 0;
  }

  /// So many bodies have been brought nearer to rest, after the step.
  void takeResting(int bodies) { lastCounts_.restingBodies = budgetState_.restingBodies = bodies; }

  /// What has become of the budget in the last step.
  [[nodiscard]] const BudgetState& budgetState() const { return budgetState_; }

  /// Between broadphase and narrowphase.
  void plan(const PlanInput& input);

  /// In the narrowphase: what a pair is to do in this step, and what has become of it. The plan on any thread
  /// if the pair isForeseeable() and its portion has begun.
  [[nodiscard]] PairPlan planPair(int pair);
  void take(int pair, const PairOutcome& outcome);

  /// A pair that is settled was left without a look.
  void takeQuiet(int pair);

  /// The same in a step without a plan, and of an outcome that isPlain(): on any thread, as what is of all
  /// pairs is left to be taken later.
  void takeUnplanned(int pair, const PairOutcome& outcome, UnplannedPairs& pairs);
  void takeQuiet(int pair, UnplannedPairs& pairs) const;
  void take(const UnplannedPairs& pairs) { unplanned_ += pairs; }

  /// All bodies of pairs that are coarser than they could be, after a step.
  void findCoarser(std::vector<CoarserBody>& bodies) const;

  [[nodiscard]] bool isAtFinest(int index) const { return pair(index).view.level == pair(index).view.finest; }

  /// Whether a pair has the level that it should have, and no contacts.
  [[nodiscard]] bool isSettled(int index) const {
    const lod::PlannedPair& planned = pair(index);
    return planned.target == planned.view.level && !planned.view.touching;
  }

  /// Whether a pair's next step is one of looking for contacts at `level`, which it has; if it is of no
  /// portion whatever others take, but for audits.
  [[nodiscard]] bool isForeseeable(int index, int level) const {
    const lod::PlannedPair& planned = pair(index);
    return planned.view.level == level && planned.target == level;
  }

  /// Of the pairs of the step under way that keep their contacts if it is about to exceed its budget. Which
  /// ones do is decided for all of a portion when the first of them has its turn: so that others may have
  /// theirs at the same time. kNoPortion: the pair is none of them.
  [[nodiscard]] int portionOf(int index) const {
    return plans_ ? known_[static_cast<std::size_t>(index)].portion : kNoPortion;
  }
  [[nodiscard]] int countPortions() const { return plans_ ? static_cast<int>(portions_.size()) : 0; }
  static constexpr int kNoPortion = -1;

  /// A pair of the portion has its turn.
  void beginPortion(int portion);

  /// Whether anything asks for other levels than the finest.
  [[nodiscard]] bool plans() const { return plans_; }

  /// After the narrowphase: manifolds and contact points that pairs of the plan have had in this step.
  [[nodiscard]] lod::LooseContacts ownContacts() const { return own_; }

  /// Then: those that belong to no pair of the plan.
  void takeLoose(const lod::LooseContacts& contacts) { budget_.takeLoose(contacts); }

  /// Then: which contacts the solver is to be shown, and how many iterations it is to leave out.
  void settle(const lod::SolverWork& solver, const lod::ContactThinning::Find& find) {
    budget_.settle(solver, find);
  }
  [[nodiscard]] int hiddenContacts() const { return budget_.hiddenContacts(); }
  [[nodiscard]] int iterationsLeftOut() const { return budget_.iterationsLeftOut(); }

  /// Ends the step.
  void finish();

  /// After the step: bodies that have fallen asleep, touching, without detail that a budget took, and with
  /// the bodies that would wake with them, if there is room for all that by now. A pair is a reason for it
  /// once, until it switches.
  void findOwed(std::vector<PlannedBody*>& bodies);

  /// After the step, if needsTime().
  void takeTime();

  /// Of the last step.
  [[nodiscard]] const PairStepCounts& counts() const { return lastCounts_; }

  /// A pair of an object that is finer than the object is asked to be; -1 if there is none: all its pairs
  /// have the level that it is asked to have.
  [[nodiscard]] int findFinerPair(const void* object) const;

 private:
  struct Known {
    PlannedBody* bodies[2]{};
    int* place = nullptr;   ///< Where its owner keeps its index.
    int coarsest = 1;       ///< The level that it can have.
    bool isGround = false;  ///< The second body has no levels, and is no list of parts.
    PairRequest request{};
    std::uint8_t targetBefore = 0;
    bool isOwed = false;  ///< The budget took the detail that it lacks, and it was not woken for it since.
    int portion = kNoPortion;
    bool keeps = false;         ///< Its contacts, once its portion has begun.
    bool hasKept = false;       ///< It did when it was last processed.
    int step = 0;               ///< The last one in which it was processed.
    std::size_t turn = 0;       ///< In that step, of the pairs that were not left without a look.
    float averageUnits = 0.0F;  ///< What it costs a step on credit below its finest level: audits are bursts.
  };

  static constexpr std::uint8_t kByProgram = 255;  ///< As lod::Wish::askedBy.

  static constexpr std::size_t kNobody = std::numeric_limits<std::size_t>::max();

  /// Where its pairs are in inTurn_.
  struct Portion {
    std::size_t first = 0;
    std::size_t end = 0;
    bool hasBegun = false;
  };

  void findTurns(std::size_t turns);
  void partOut(std::size_t turns);
  void showPairs();
  void lookUpBodies(std::size_t pair);
  void advise(std::size_t pair);
  void applyAsked(std::size_t pair);
  [[nodiscard]] bool isHeld(const PlannedBody& body) const;
  [[nodiscard]] int targetOf(std::size_t pair);
  [[nodiscard]] lod::SwitchRules rulesOf(std::size_t pair) const;
  [[nodiscard]] bool easesContacts(std::size_t pair) const;
  [[nodiscard]] int keepsFrom(std::size_t pair);
  [[nodiscard]] float auditsFrom() const;
  void followRequest(std::size_t pair);
  void acknowledge(std::size_t pair);
  void tell(LevelEventKind kind, std::size_t pair, int from, int to, bool onCredit) const;
  void takeChoice(std::size_t pair, const lod::SwitchChoice& choice);
  void takeBlocked(std::size_t pair);
  void takeQueries(int queries);
  void takeWork(std::size_t pair, const PairOutcome& outcome, int before);
  static void takeContacts(lod::PlannedPair& planned, const PairOutcome& outcome);
  void settleUnplanned();
  void count(const lod::PlannedPair& planned);
  void finishPair(std::size_t pair);
  [[nodiscard]] bool restsOwed(std::size_t pair) const;
  void settleState();

  std::vector<lod::PlannedPair> planned_;
  std::vector<Known> known_;  ///< In the same order.
  std::vector<lod::PairView> views_;
  std::vector<Portion> portions_;    ///< Of the step under way.
  std::vector<std::size_t> inTurn_;  ///< Pairs of portions.
  std::size_t turns_ = 0;            ///< Pairs that have had their turn, and were looked at.
  lod::PolicyList policies_;
  lod::Situation situation_;
  lod::StepBudget budget_;
  SwitchSettings settings_;
  std::vector<const void*> held_;
  PairListener* listener_ = nullptr;
  PairStepCounts counts_;  ///< Of the step under way, and of what happened since the last one.
  PairStepCounts lastCounts_;
  lod::LooseContacts own_;    ///< Of the step under way.
  UnplannedPairs unplanned_;  ///< The same, if it was not planned.
  BudgetState budgetState_;
  int step_ = 0;
  std::uint32_t numCreated_ = 0;  ///< Pairs, ever.
  int numBelowFinest_ = 0;        ///< Pairs that are coarser than their finest level,
  int numOwed_ = 0;               ///< and of these, those that restsOwed().
  RestingIslands resting_;        ///< Inside findOwed().
  bool asks_ = false;
  bool plans_ = false;       ///< This step was planned.
  bool advisesAll_ = false;  ///< In the next plan every pair is advised, whosever turn it is.
};

}  // namespace scatter::pairs
