#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "PairTestWorld.h"

// Runs within a budget are repeated exactly.

namespace scatter::test {
namespace {

constexpr int kSteps = 240;

/// Ships that are drawn together, and have met.
class Gathering : public PairTestWorld {
 public:
  Gathering() {
    Random random(6);
    for (int i = 0; i < 24; ++i) {
      const btVector3 cell(static_cast<float>(i % 3), static_cast<float>(i / 3 % 3),
                           static_cast<float>(i / 9));
      addBody(i % 3 == 0 ? block : ship, btTransform(random.rotation(), 2.6F * cell));
    }
    for (int i = 0; i < 80; ++i) pull();
  }

  void pull() {
    for (auto& body : bodies) {
      body->applyCentralForce((btVector3(3, 3, 3) - body->getWorldTransform().getOrigin()) * 4);
    }
    step();
  }
};

struct Recording {
  std::vector<std::vector<std::uint32_t>> bits;
  std::vector<btHybridBudgetUnits> units;  ///< That each step was allowed.
  std::vector<int> switches;
  int onCredit = 0;
};

/// `change`: of the world, before every step.
Recording record(Gathering& w, const std::function<void(int step)>& change = {}) {
  Recording run;
  for (int i = 0; i < kSteps; ++i) {
    if (change) change(i);
    w.pull();
    const btHybridPairStepInfo info = w.pairInfo();
    run.bits.push_back(w.bits());
    run.units.push_back(info.budgetUnits);
    run.switches.push_back(info.switchesCoarser + info.switchesFiner);
    run.onCredit += info.creditSwitches;
  }
  return run;
}

void expectSame(const Recording& one, const Recording& other) {
  for (std::size_t i = 0; i < one.bits.size(); ++i) {
    ASSERT_EQ(one.bits[i], other.bits[i]) << "first diverged at step " << i;
    ASSERT_EQ(one.switches[i], other.switches[i]) << "step " << i;
  }
}

TEST(Budget, InUnitsGivesTheSameRunEveryTime) {
  for (const double units : {60.0, 200.0}) {
    Gathering first;
    Gathering second;
    for (Gathering* w : {&first, &second}) {
      w->world.setBudgetUnits(units);
      ASSERT_EQ(w->world.addPolicy("speed"), nullptr);
    }
    const Recording one = record(first);
    expectSame(one, record(second));
    EXPECT_GT(one.onCredit, 5) << "nothing was at stake";
  }
}

TEST(Budget, InMillisecondsIsReplayedFromItsUnits) {
  Gathering timed;
  // So small that there is always something to do, whatever the machine.
  timed.world.setBudgetMilliseconds(0.05);
  const Recording recorded = record(timed);
  Gathering replayed;
  replayed.world.replayBudget(recorded.units.data(), static_cast<int>(recorded.units.size()));
  const Recording replay = record(replayed);
  expectSame(recorded, replay);
  EXPECT_EQ(recorded.units, replay.units);
  int switches = 0;
  for (const int count : recorded.switches) switches += count;
  EXPECT_GT(switches, 20);
}

// As by a game that gives physics what is left of a frame.
TEST(Budget, ThatIsSetAnewInEveryStepIsTheSameAsOneThatStays) {
  Gathering once;
  Gathering anew;
  once.world.setBudgetUnits(150);
  const Recording stays = record(once);
  EXPECT_GT(stays.onCredit, 5) << "nothing was at stake";
  expectSame(stays, record(anew, [&anew](int) { anew.world.setBudgetUnits(150); }));
}

TEST(Budget, InMillisecondsThatIsSetAnewInEveryStepKnowsTheMachine) {
  const double machine[] = {0.003, 0.002};
  Gathering once;
  Gathering anew;
  once.world.setBudgetMilliseconds(0.4, machine, 2);
  const Recording stays = record(once);
  EXPECT_LT(stays.units.back().given, 300) << "it was learned that a unit takes more than a microsecond";
  expectSame(stays, record(anew, [&](int) { anew.world.setBudgetMilliseconds(0.4, machine, 2); }));
}

TEST(Budget, ThatChangesAndComesAndGoesIsReplayedExactly) {
  Gathering w;
  const Recording recorded = record(w, [&w](int step) {
    if (step % 60 == 10) w.world.setBudgetUnits(100);
    if (step % 60 == 30) w.world.setBudgetUnits(200);
    if (step % 60 == 45) w.world.removeBudget();
  });
  EXPECT_GT(recorded.onCredit, 5) << "nothing was at stake";
  Gathering replayed;
  replayed.world.replayBudget(recorded.units.data(), kSteps);
  expectSame(recorded, record(replayed));
}

TEST(Budget, InMillisecondsOfAMachineThatIsGivenIsKeptAndTheSameEveryTime) {
  // Twice as slow for 60 steps, again and again; the budget is what the scene takes without one, quickly.
  std::vector<double> machine(120, 0.001);
  std::fill(machine.begin() + 60, machine.end(), 0.002);
  Gathering first;
  Gathering second;
  double dearest = 0;
  for (int i = 0; i < 60; ++i) {
    first.pull();
    second.pull();
    dearest = std::max(dearest, first.pairInfo().units);
  }
  for (Gathering* w : {&first, &second}) w->world.setBudgetMilliseconds(0.001 * dearest, machine.data(), 120);
  const Recording one = record(first);
  expectSame(one, record(second));
  Gathering replayed;
  for (int i = 0; i < 60; ++i) replayed.pull();
  replayed.world.replayBudget(one.units.data(), static_cast<int>(one.units.size()));
  expectSame(one, record(replayed));
  for (int i = 30; i < 60; ++i) {
    EXPECT_NEAR(one.units[static_cast<std::size_t>(i)].given, dearest, 1e-9 * dearest) << i;
    EXPECT_NEAR(one.units[static_cast<std::size_t>(i + 60)].given, dearest / 2, 1e-9 * dearest) << i;
  }
}

TEST(Budget, IsSharedByTheStepsOfACall) {
  Gathering w;
  constexpr double kUnits = 3000;
  w.world.setBudgetUnits(kUnits);
  w.pull();
  EXPECT_EQ(w.pairInfo().budgetUnits.given, kUnits);
  EXPECT_EQ(w.world.stepSimulation(3.0F / 60 + 1e-4F, 3, 1.0F / 60), 3);
  // The last of three has what the others have left, which cost less than two thirds.
  EXPECT_GT(w.pairInfo().budgetUnits.given, kUnits / 3);
  EXPECT_LT(w.pairInfo().budgetUnits.given, kUnits);
  w.pull();
  EXPECT_EQ(w.pairInfo().budgetUnits.given, kUnits);
}

TEST(Budget, SaysWhetherItIsKeptAndWhatCannotBeGivenUp) {
  Gathering w;
  EXPECT_EQ(w.world.getBudgetState().verdict, BudgetVerdict::kNone);
  w.world.setBudgetUnits(20000);
  for (int i = 0; i < 3; ++i) w.pull();
  btHybridBudgetState state = w.world.getBudgetState();
  EXPECT_EQ(state.verdict, BudgetVerdict::kKept);
  EXPECT_EQ(state.steps, 3);
  EXPECT_EQ(state.withheldPairs, 0);
  EXPECT_EQ(state.taken, w.pairInfo().units);
  // Bodies alone cost more than this.
  w.world.setBudgetUnits(2);
  for (int i = 0; i < 30; ++i) w.pull();
  state = w.world.getBudgetState();
  EXPECT_EQ(state.verdict, BudgetVerdict::kImpossible);
  EXPECT_GT(state.fixed, 2);
  EXPECT_GE(state.reachable, state.fixed);
  EXPECT_GT(state.withheldPairs, 0);
  EXPECT_THAT(describe(state), testing::HasSubstr("cannot be kept in this scene"));
  w.world.removeBudget();
  w.pull();
  EXPECT_EQ(w.world.getBudgetState().verdict, BudgetVerdict::kNone);
}

TEST(Budget, ContactsAreReusedOnlyWhileItIsExceededAndNeverForAHeldBody) {
  Gathering w;
  for (int i = 0; i < 60; ++i) w.pull();
  w.world.setBudgetUnits(20000);
  for (int i = 0; i < 40; ++i) {
    w.pull();
    ASSERT_EQ(w.pairInfo().reusedPairs, 0);
  }
  const double units = w.pairInfo().units;
  for (auto& body : w.bodies) static_cast<btHybridRigidBody*>(body.get())->setHeld(true);
  ASSERT_EQ(w.world.addPolicy("held"), nullptr);
  w.world.setBudgetUnits(0.5 * units);
  for (int i = 0; i < 20; ++i) w.pull();
  for (int i = 0; i < 20; ++i) {
    w.pull();
    ASSERT_EQ(w.pairInfo().reusedPairs, 0);
  }
  w.world.removePolicies();
  w.world.setBudgetUnits(0.9 * units);
  int reused = 0;
  int touching = 0;
  for (int i = 0; i < 60; ++i) {
    w.pull();
    reused += w.pairInfo().reusedPairs;
    touching += w.pairInfo().touchingFinest;
  }
  EXPECT_GT(reused, 0);
  // Not twice running.
  EXPECT_LE(2 * reused, touching + 60);
}

/// Slabs of 64 bricks that lie on each other.
class Slabs : public PairTestWorld {
 public:
  /// Metres by which each hangs over the one below.
  explicit Slabs(float overhang = 0) {
    auto* fine = shape<btCompoundShape>();
    auto* brick = shape<btBoxShape>(btVector3(0.12F, 0.1F, 0.12F));
    for (int i = 0; i < 64; ++i) {
      const btVector3 at(0.25F * static_cast<float>(i % 8) - 0.875F, 0,
                         0.25F * static_cast<float>(i / 8) - 0.875F);
      fine->addChildShape(btTransform(btQuaternion::getIdentity(), at), brick);
    }
    slab.addLevel(shape<btBoxShape>(btVector3(1.1F, 0.15F, 1.1F)));
    slab.addLevel(fine);
    world.setGravity(btVector3(0, -10, 0));
    addFloor();
    for (int i = 0; i < 4; ++i) {
      addBody(slab,
              btTransform(btQuaternion::getIdentity(), btVector3(overhang * static_cast<float>(i),
                                                                 0.1F + 0.2F * static_cast<float>(i), 0)));
    }
    for (int i = 0; i < 30; ++i) step();
  }

  /// What a step takes once the slabs have settled on fewer contacts.
  void setTightBudget() {
    for (const bool hasSettled : {false, true}) {
      world.setBudgetUnits(1e6);
      step();
      world.setBudgetUnits(pairInfo().units);
      for (int i = 0; !hasSettled && i < 60; ++i) step();
    }
  }

  /// Of contacts in manifolds: those that press, and those that a solver would not see.
  [[nodiscard]] std::pair<int, int> countContacts() const {
    std::pair<int, int> counts;
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
      for (int k = 0; k < manifoldAt(i).getNumContacts(); ++k) {
        counts.first += manifoldAt(i).getContactPoint(k).getAppliedImpulse() > 0 ? 1 : 0;
        counts.second += manifoldAt(i).getContactPoint(k).getDistance() > 1 ? 1 : 0;
      }
    }
    return counts;
  }

  btHybridLevelSet slab;
};

TEST(Budget, LeavesContactsToOthersBeforeItTakesDetail) {
  Slabs w;
  const int pressing = w.countContacts().first;
  w.world.setBudgetUnits(1e6);
  w.step();
  EXPECT_EQ(w.pairInfo().hiddenContacts, 0);
  w.setTightBudget();
  for (int i = 0; i < 120; ++i) {
    w.step();
    ASSERT_GT(w.pairInfo().hiddenContacts, 0);
    ASSERT_EQ(w.countContacts().second, 0) << "they are hidden from the solver alone";
  }
  EXPECT_LT(w.countContacts().first, 3 * pressing / 4);
  const btHybridBudgetState state = w.world.getBudgetState();
  EXPECT_EQ(state.verdict, BudgetVerdict::kKept);
  EXPECT_EQ(state.withheldPairs, 0);
  EXPECT_GT(state.hiddenContacts, 0);
  for (int i = 0; i < 4; ++i) {
    const auto& slab = w.bodies[static_cast<std::size_t>(i) + 1];  // above the floor
    EXPECT_NEAR(slab->getWorldTransform().getOrigin().y(), 0.1 + 0.2 * i, 0.005);
  }
  w.world.removeBudget();
  w.step();
  EXPECT_EQ(w.pairInfo().hiddenContacts, 0);
  EXPECT_GT(w.countContacts().first, pressing / 2);
}

/// Remembers how many iterations it is asked for.
class CountingSolver : public btSequentialImpulseConstraintSolver {
 public:
  std::set<int> iterations;

  btScalar solveGroup(btCollisionObject** objects, int numObjects, btPersistentManifold** manifolds,
                      int numManifolds, btTypedConstraint** joints, int numJoints,
                      const btContactSolverInfo& info, btIDebugDraw* drawer,
                      btDispatcher* dispatcher) override {
    iterations.insert(info.m_numIterations);
    return btSequentialImpulseConstraintSolver::solveGroup(objects, numObjects, manifolds, numManifolds,
                                                           joints, numJoints, info, drawer, dispatcher);
  }
};

class CountedSlabs : public Slabs {
 public:
  CountedSlabs() : before_(world.getConstraintSolver()) { world.setConstraintSolver(&counting_); }
  ~CountedSlabs() { world.setConstraintSolver(before_); }

  /// What the solver is asked for in the next step, in which the slabs slide, unless they lie still.
  std::set<int> iterations(bool isCalm = false) {
    for (auto& body : bodies) body->setLinearVelocity(btVector3(isCalm ? 0 : 0.2F, 0, 0));
    counting_.iterations.clear();
    step();
    return counting_.iterations;
  }

  /// The greatest budget, as a share of what a step takes without one, with which some are left out; 0: none.
  double findShort() {
    return findFirst([this](double units) { world.setBudgetUnits(units); });
  }

  /// The same of what a budget of as much as is wanted has left when contacts are known, in its second step.
  double findShortRest() {
    return findFirst([this](double units) {
      const btHybridBudgetUnits steps[] = {{.given = kEnough}, {.given = kEnough, .settled = units}};
      world.replayBudget(steps, 2);
      static_cast<void>(iterations());
    });
  }

  static constexpr double kEnough = 1e6;

 private:
  template <class Set>
  double findFirst(const Set& set) {
    world.setBudgetUnits(kEnough);
    step();
    const double full = pairInfo().units;
    for (double share = 1.0; share > 0.0; share -= 0.02) {
      set(share * full);
      if (*iterations().begin() < 10) return share * full;
    }
    return 0.0;
  }

  CountingSolver counting_;
  btConstraintSolver* before_;
};

TEST(Budget, LeavesOutIterationsOfTheSolverLast) {
  CountedSlabs w;
  ASSERT_GT(w.findShort(), 0.0);
  const int leftOut = w.pairInfo().iterationsLeftOut;
  EXPECT_GT(leftOut, 0);
  EXPECT_LE(leftOut, 6);
  EXPECT_GT(w.pairInfo().hiddenContacts, 0) << "before them";
  EXPECT_EQ(w.world.getBudgetState().iterationsLeftOut, leftOut);
  EXPECT_EQ(w.world.getSolverInfo().m_numIterations, 10) << "it is the program's";
  w.world.removeBudget();
  EXPECT_EQ(w.iterations(), std::set<int>{10});
}

TEST(Budget, LeavesOutNoIterationsOfWhatLiesStill) {
  CountedSlabs w;
  w.world.setBudgetUnits(w.findShort());
  EXPECT_EQ(w.iterations(true), std::set<int>{10});
}

TEST(Budget, ReplaysWhatTheClockHadLeftOfIt) {
  CountedSlabs w;
  const double enough = CountedSlabs::kEnough;
  std::vector<btHybridBudgetUnits> steps(3, {enough, enough, enough});
  // The slabs slide on meanwhile, and take a little less.
  steps[1].settled = 0.9 * w.findShortRest();
  w.world.replayBudget(steps.data(), 3);
  for (const btHybridBudgetUnits& allowed : steps) {
    EXPECT_EQ(*w.iterations().begin() < 10, allowed.settled < enough);
    EXPECT_EQ(w.pairInfo().budgetUnits, allowed);
  }
}

// What was decided for a step's contacts does not outlive them.
TEST(Budget, LeavesNothingOutOfAStepWithoutBodiesThatSwitch) {
  CountedSlabs w;
  ASSERT_GT(w.findShort(), 0.0);
  btBoxShape cube(btVector3(1, 1, 1));
  btRigidBody plain(1, nullptr, &cube, btVector3(1, 1, 1));
  plain.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(9, 0.99F, 0)));
  while (w.world.getNumHybrids() > 0) w.world.removeRigidBody(w.world.getHybrid(0));
  w.world.addRigidBody(&plain);
  EXPECT_EQ(w.iterations(), std::set<int>{10});
  w.world.removeRigidBody(&plain);
}

// What rests would tremble if it was held by other contacts in every step. How it rests is a matter of
// chance.
TEST(Budget, SeldomChangesHowManyContactsItLeavesToOthers) {
  constexpr int kStepsOfEach = 300;
  int changes = 0;
  for (const float overhang : {0.0F, 0.001F, 0.002F, 0.004F, 0.01F}) {
    Slabs w(overhang);
    w.setTightBudget();
    for (int i = 0; i < 150; ++i) w.step();
    int before = w.pairInfo().hiddenContacts;
    EXPECT_GT(before, 100);
    for (int i = 0; i < kStepsOfEach; ++i) {
      w.step();
      const int hidden = w.pairInfo().hiddenContacts;
      changes += std::abs(hidden - before) > 60 ? 1 : 0;
      before = hidden;
    }
  }
  EXPECT_LT(changes, 5 * kStepsOfEach / 20);
}

TEST(Budget, IsThereAfterItIsSetAndGoneWhenItIsRemoved) {
  Gathering w;
  w.pull();
  EXPECT_EQ(w.pairInfo().budgetUnits.given, 0);
  w.world.setBudgetUnits(100);
  w.pull();
  EXPECT_EQ(w.pairInfo().budgetUnits.given, 100);
  w.world.removeBudget();
  w.pull();
  EXPECT_EQ(w.pairInfo().budgetUnits.given, 0);
}

TEST(Audit, IsMadeAfterTheMotionThatIsAllowedAndNeverAtZero) {
  for (const float distance : {0.0F, 0.01F}) {
    Gathering w;
    w.world.getPairSwitchingInfo().m_auditDistance = distance;
    w.world.setBudgetUnits(20000);
    for (int i = 0; i < 100; ++i) w.pull();
    w.world.removeBudget();
    w.requestAll(2);
    int audits = 0;
    int credited = 0;
    for (int i = 0; i < 100; ++i) {
      w.pull();
      audits += w.pairInfo().audits;
      credited = btMax(credited, w.pairInfo().creditedPairs);
    }
    EXPECT_GT(credited, 10);
    if (distance > 0) {
      EXPECT_GT(audits, 10);
    } else {
      EXPECT_EQ(audits, 0);
    }
  }
}

}  // namespace
}  // namespace scatter::test
