#include "pairs/planner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "pairs/fake_body.h"

namespace scatter::pairs {
namespace {

using lod::SwitchKind;
using testing::FakeBody;

class Listener : public PairListener {
 public:
  void hear(const PairEvent& event) override { events.push_back(event); }
  [[nodiscard]] std::string kinds() const {
    std::string all;
    for (const PairEvent& event : events) all += "RABSr"[static_cast<int>(event.kind)];
    return all;
  }
  std::vector<PairEvent> events;
};

constexpr int kLevels = 3;

/// Bodies in a row, each pair of neighbours planned; what a narrowphase would do with the plans.
struct PlannedRow {
  explicit PlannedRow(int count) {
    for (int i = 0; i < count; ++i) {
      bodies.push_back(std::make_unique<FakeBody>(static_cast<std::uint32_t>(i)));
      views.push_back({.center = Vec3(static_cast<float>(i), 0.0F, 0.0F), .mass = 1.0F, .present = true});
    }
    places.resize(static_cast<std::size_t>(count) - 1);
    for (std::size_t i = 0; i + 1 < bodies.size(); ++i)
      planner.addPair(*bodies[i], *bodies[i + 1], kLevels, 100.0, &places[i]);
    planner.setListener(&listener);
  }

  void step(SwitchKind kind = SwitchKind::kFree) {
    const int count = static_cast<int>(bodies.size());
    planner.plan({.bodies = views, .load = {.objects = count, .awake = count, .broadphasePairs = count - 1}});
    for (const int place : places) {
      if (place >= 0) take(place, kind);
    }
    planner.finish();
  }

  /// The program asks for a level of one of the bodies.
  void ask(std::size_t body, int level) {
    bodies[body]->asked = level;
    planner.setAsks(true);
  }

  void take(int pair, SwitchKind kind) {
    const PairPlan plan = planner.planPair(pair);
    PairOutcome outcome;
    outcome.tried = plan.tries;
    outcome.choice = {kind, plan.target};
    outcome.touching = touching;
    outcome.work.contacts = contacts;
    outcome.work.counts.gjkIterations = 100;
    planner.take(pair, outcome);
  }

  [[nodiscard]] int level(std::size_t pair) const { return planner.pair(places[pair]).view.level; }

  Planner planner;
  Listener listener;
  std::vector<std::unique_ptr<FakeBody>> bodies;
  std::vector<lod::BodyView> views;
  std::vector<int> places;
  bool touching = false;
  int contacts = 0;
};

TEST(Planner, LeavesEveryPairFinestWithoutAReason) {
  PlannedRow row(5);
  for (int i = 0; i < 3; ++i) row.step();
  EXPECT_EQ(row.planner.counts().pairs, 4);
  EXPECT_EQ(row.planner.counts().finestPairs, 4);
  EXPECT_EQ(row.planner.counts().plannedUnits, 0.0);
  EXPECT_GT(row.planner.counts().units, 0.0);
  EXPECT_TRUE(row.listener.events.empty());
}

TEST(Planner, FollowsARequestToItsSwitch) {
  PlannedRow row(3);
  row.step();
  row.ask(0, 1);
  row.step(SwitchKind::kBlocked);
  EXPECT_EQ(row.listener.kinds(), "RAB");
  EXPECT_EQ(row.planner.counts().requests, 1);
  EXPECT_EQ(row.planner.counts().blockedTries, 1);
  EXPECT_EQ(row.planner.findFinerPair(row.bodies[0].get()), row.places[0]);
  row.step();
  EXPECT_EQ(row.listener.kinds(), "RAB") << "it waits for the retry interval";
  while (row.planner.pair(row.places[0]).blockedSteps > 0) row.step();
  row.step();
  EXPECT_EQ(row.listener.kinds(), "RABS");
  EXPECT_EQ(row.level(0), 1);
  EXPECT_EQ(row.level(1), kLevels) << "nobody asked for it";
  EXPECT_EQ(row.planner.findFinerPair(row.bodies[0].get()), -1);
  const PairEvent& last = row.listener.events.back();
  EXPECT_EQ(last.from, kLevels);
  EXPECT_EQ(last.to, 1);
  EXPECT_STREQ(last.asker.name, "program");
}

TEST(Planner, FindsBodiesOfCoarserPairsOnceEachWithTheirCoarsestLevel) {
  PlannedRow row(5);
  std::vector<CoarserBody> found;
  row.step();
  row.planner.findCoarser(found);
  EXPECT_TRUE(found.empty());
  row.ask(1, 2);
  row.ask(3, 1);
  row.step();
  for (int twice = 0; twice < 2; ++twice) {
    row.planner.findCoarser(found);
    ASSERT_EQ(found.size(), 5U) << "levels of the pairs: 2, 2, 1, 1";
    const int expected[] = {2, 2, 1, 1, 1};
    for (const CoarserBody& one : found) EXPECT_EQ(one.level, expected[one.body->index()]);
  }
}

TEST(Planner, TellsThatARequestIsNotWantedAnyMore) {
  PlannedRow row(2);
  row.step();
  row.ask(0, 1);
  row.step(SwitchKind::kBlocked);
  row.bodies[0]->asked = 0;
  row.step();
  EXPECT_EQ(row.listener.kinds(), "RABr");
  EXPECT_EQ(row.planner.counts().retractions, 1);
}

TEST(Planner, RetractsTheRequestOfAPairThatEnds) {
  PlannedRow row(2);
  row.step();
  row.ask(0, 1);
  row.step(SwitchKind::kBlocked);
  row.planner.removePair(row.places[0]);
  EXPECT_EQ(row.listener.kinds(), "RABr");
  EXPECT_EQ(row.planner.countPairs(), 0);
}

TEST(Planner, TellsOwnersWhereTheirPairsAre) {
  PlannedRow row(4);
  row.planner.removePair(row.places[0]);
  row.places[0] = -1;
  EXPECT_EQ(row.planner.countPairs(), 2);
  for (std::size_t i = 1; i < 3; ++i) {
    EXPECT_EQ(&row.planner.body(row.places[i], 0), row.bodies[i].get()) << i;
    EXPECT_EQ(&row.planner.body(row.places[i], 1), row.bodies[i + 1].get()) << i;
  }
}

TEST(Planner, KeepsPairsOfSensorsAndOfWhatIsHeldFinest) {
  PlannedRow row(4);
  row.bodies[0]->isSensor = true;
  row.planner.setHeld({row.bodies[3].get()});
  ASSERT_TRUE(row.planner.addPolicy("coarsest"));
  row.step();
  EXPECT_EQ(row.level(0), kLevels);
  EXPECT_EQ(row.level(1), 1);
  EXPECT_EQ(row.level(2), kLevels);
}

TEST(Planner, GivesNoCreditWhereContactsAreSprings) {
  PlannedRow row(3);
  row.bodies[0]->hasSprings = true;
  ASSERT_TRUE(row.planner.addPolicy("coarsest"));
  row.step();
  row.planner.removePolicies();
  row.planner.plan({});
  for (const int i : {0, 1}) {
    const PairPlan plan = row.planner.planPair(row.places[static_cast<std::size_t>(i)]);
    ASSERT_TRUE(plan.tries);
    EXPECT_EQ(plan.rules.credit, i == 1);
  }
}

TEST(Planner, SaysWhatIsWrongWithAPolicy) {
  Planner planner;
  const Result<void> result = planner.addPolicy("sped");
  ASSERT_FALSE(result);
  EXPECT_NE(result.error().message.find("speed"), std::string::npos);
  EXPECT_FALSE(planner.needsBodies());
  EXPECT_TRUE(planner.checkPolicy("speed"));
  EXPECT_FALSE(planner.needsBodies());
}

TEST(Planner, NeedsBodiesForABudgetNowAndThen) {
  PlannedRow row(4);
  row.step();
  EXPECT_FALSE(row.planner.needsBodies()) << "without a budget";
  row.planner.setBudget(lod::UnitBudget::ofUnits(1000.0));
  std::vector<int> needed;
  for (int step = 0; step < 20; ++step) {
    if (row.planner.needsBodies()) needed.push_back(step);
    row.step();
  }
  EXPECT_EQ(needed, std::vector<int>({0, 8, 16}));
  row.planner.setBudget({});
  row.step();
  EXPECT_FALSE(row.planner.needsBodies());
  ASSERT_TRUE(row.planner.addPolicy("speed"));
  EXPECT_TRUE(row.planner.needsBodies());
}

TEST(Planner, NeverTakesTheCoarsestLevelOnAGround) {
  FakeBody body(0);
  FakeBody ground(1);
  Planner planner;
  int place = -1;
  planner.addGround(body, ground, kLevels, 20, &place);
  ASSERT_TRUE(planner.addPolicy("coarsest"));
  const std::vector<lod::BodyView> views(2);
  planner.plan({.bodies = views, .load = {.objects = 2, .awake = 1, .broadphasePairs = 1}});
  EXPECT_EQ(planner.planPair(place).target, 2);
}

TEST(Planner, KeepsAStepWithinItsUnits) {
  PlannedRow fine(40);
  fine.touching = true;
  for (int i = 0; i < 50; ++i) fine.step();
  const double full = fine.planner.counts().units;
  fine.planner.setBudget(lod::UnitBudget::ofUnits(full / 2));
  for (int i = 0; i < 50; ++i) fine.step(SwitchKind::kOnCredit);
  EXPECT_LT(fine.planner.counts().finestPairs, 39);
  EXPECT_EQ(fine.planner.counts().budgetUnits.given, full / 2);
  bool isGovernors = false;
  for (const PairEvent& event : fine.listener.events) isGovernors |= event.asker.scope == Scope::kGlobal;
  EXPECT_TRUE(isGovernors);
}

TEST(Planner, KnowsWhichPairsTheStepHasLeftOut) {
  PlannedRow row(4);
  row.planner.setBudget(lod::UnitBudget::ofUnits(1e6));
  row.step();
  row.planner.plan({.bodies = row.views, .load = {.objects = 4, .awake = 2, .broadphasePairs = 3}});
  row.take(row.places[0], SwitchKind::kFree);
  row.planner.takeQuiet(row.places[1]);
  row.planner.finish();
  EXPECT_FALSE(row.planner.pair(row.places[0]).rests);
  EXPECT_FALSE(row.planner.pair(row.places[1]).rests) << "it was looked at, and is far from touching";
  EXPECT_TRUE(row.planner.pair(row.places[2]).rests);
  row.step();
  EXPECT_FALSE(row.planner.pair(row.places[2]).rests);
}

/// What pairs found in a step without a plan.
std::vector<PairOutcome> plainOutcomes(int count) {
  std::vector<PairOutcome> outcomes(static_cast<std::size_t>(count));
  int i = 0;
  for (PairOutcome& outcome : outcomes) {
    ++i;
    outcome.touching = i % 2 == 0;
    outcome.work = {.counts = {.pairs = 1, .childPairs = 3 * i, .gjkIterations = 7 * i},
                    .contacts = i,
                    .manifolds = i % 3};
  }
  return outcomes;
}

void beginUnplanned(PlannedRow& row) {
  row.step();
  row.planner.plan({.bodies = row.views, .load = {.objects = 8, .awake = 8, .broadphasePairs = 7}});
  ASSERT_FALSE(row.planner.plans());
}

TEST(Planner, TakesPairsThatNobodyPlansInAnyOrder) {
  const std::vector<PairOutcome> outcomes = plainOutcomes(6);
  PlannedRow inTurn(8);
  PlannedRow apart(8);
  beginUnplanned(inTurn);
  beginUnplanned(apart);
  for (std::size_t i = 0; i < outcomes.size(); ++i) inTurn.planner.take(inTurn.places[i], outcomes[i]);
  inTurn.planner.takeQuiet(inTurn.places[6]);
  UnplannedPairs threads[2];
  for (const std::size_t i : {5U, 0U, 3U, 1U, 4U, 2U})
    apart.planner.takeUnplanned(apart.places[i], outcomes[i], threads[i % 2]);
  apart.planner.takeQuiet(apart.places[6], threads[0]);
  for (const UnplannedPairs& thread : threads) apart.planner.take(thread);
  inTurn.planner.finish();
  apart.planner.finish();
  const PairStepCounts& counts = inTurn.planner.counts();
  EXPECT_EQ(counts.pairs, 7);
  EXPECT_EQ(counts.finestPairs, 7);
  EXPECT_EQ(counts.touchingPairs, 3);
  EXPECT_EQ(counts.touchingFinest, 3);
  EXPECT_EQ(apart.planner.counts().pairs, 7);
  EXPECT_EQ(apart.planner.counts().touchingFinest, 3);
  EXPECT_EQ(apart.planner.counts().units, counts.units) << "to the last bit";
  double fixed = counts.units;
  for (int i = 0; i < 7; ++i) {
    EXPECT_EQ(apart.planner.units(apart.places[static_cast<std::size_t>(i)]), inTurn.planner.units(i));
    fixed -= static_cast<double>(inTurn.planner.units(i));
  }
  EXPECT_EQ(inTurn.planner.units(6), 0.0F) << "it was left without a look";
  const double alone =
      lod::CostModel(lod::CostWeights()).units({.objects = 8, .awake = 8, .broadphasePairs = 7});
  EXPECT_NEAR(fixed, alone, 1e-4) << "what pairs took is all that there is besides";
}

TEST(Planner, TakesSwitchesInTheirTurnAlone) {
  PairOutcome outcome;
  EXPECT_TRUE(isPlain(outcome));
  const auto isPlainWith = [&](const auto& change) {
    PairOutcome other;
    change(other);
    return isPlain(other);
  };
  EXPECT_FALSE(isPlainWith([](PairOutcome& other) { other.tried = true; }));
  EXPECT_FALSE(isPlainWith([](PairOutcome& other) { other.gapQueries = 1; }));
  EXPECT_FALSE(isPlainWith([](PairOutcome& other) { other.audited = true; }));
  EXPECT_FALSE(isPlainWith([](PairOutcome& other) { other.credited = true; }));
  EXPECT_FALSE(isPlainWith([](PairOutcome& other) { other.late = lod::lateness::kLate; }));
  EXPECT_FALSE(isPlainWith([](PairOutcome& other) { other.work.reuses = true; }));
}

/// Two pairs that touch at a coarser level for want of budget, and then are asleep.
class Owed : public ::testing::Test {
 protected:
  Owed() {
    row.touching = true;
    row.planner.setBudget(lod::UnitBudget::ofUnits(1.0));
    for (int i = 0; i < 60; ++i) row.step(SwitchKind::kOnCredit);
    rest(60);
  }

  /// So many steps without a look at any pair. How many bodies they wake.
  int rest(int steps) {
    int woken = 0;
    for (int i = 0; i < steps; ++i) {
      row.planner.plan({.bodies = row.views, .load = {.objects = 3, .broadphasePairs = 2}});
      row.planner.finish();
      row.planner.findOwed(bodies);
      EXPECT_EQ(row.planner.counts().wokenBodies, static_cast<int>(bodies.size()));
      woken += static_cast<int>(bodies.size());
    }
    return woken;
  }

  PlannedRow row{3};
  std::vector<PlannedBody*> bodies;
};

TEST_F(Owed, BodiesSleepAsLongAsThereIsNoRoom) {
  ASSERT_LT(row.level(0), kLevels);
  EXPECT_EQ(rest(100), 0);
}

TEST_F(Owed, BodiesWakeOnceForDetailThatHasRoom) {
  row.planner.setBudget(lod::UnitBudget::ofUnits(1e6));
  EXPECT_EQ(rest(60), 3);
  EXPECT_EQ(rest(200), 0) << "it has not helped";
  for (int i = 0; i < 10; ++i) row.step();
  EXPECT_EQ(row.level(0), kLevels);
  EXPECT_EQ(row.level(1), kLevels);
  EXPECT_EQ(rest(200), 0) << "nothing is owed";
}

TEST_F(Owed, BodiesWakeWhenTheBudgetIsRemoved) {
  row.planner.setBudget(lod::UnitBudget());
  EXPECT_EQ(rest(60), 3);
}

TEST_F(Owed, NobodyWakesForWhatThePoliciesWant) {
  ASSERT_TRUE(row.planner.addPolicy("coarsest"));
  row.planner.setBudget(lod::UnitBudget::ofUnits(1e6));
  EXPECT_EQ(rest(100), 0);
}

TEST(Planner, LetsBodiesRestEarlyOnlyWhileSomethingIsGivenUp) {
  PlannedRow row(4);
  row.touching = true;
  row.step();
  EXPECT_FALSE(row.planner.restsEarly());
  row.planner.setBudget(lod::UnitBudget::ofUnits(1e6));
  row.step();
  EXPECT_FALSE(row.planner.restsEarly());
  row.planner.setBudget(lod::UnitBudget::ofUnits(1.0));
  for (int i = 0; i < 30 && !row.planner.restsEarly(); ++i) row.step(SwitchKind::kOnCredit);
  EXPECT_TRUE(row.planner.restsEarly());
  row.planner.takeResting(3);
  EXPECT_EQ(row.planner.counts().restingBodies, 3);
  EXPECT_EQ(row.planner.budgetState().restingBodies, 3);
  row.planner.setBudget(lod::UnitBudget());
  row.step();
  EXPECT_FALSE(row.planner.restsEarly());
  EXPECT_EQ(row.planner.counts().restingBodies, 0);
}

// A gap would stay as long as they sleep.
TEST(Planner, LetsNoBodyRestEarlyThatTouchesAnotherCoarsely) {
  PlannedRow row(4);
  row.step();
  row.ask(0, 1);
  row.step();
  ASSERT_EQ(row.level(0), 1);
  ASSERT_EQ(row.level(1), kLevels);
  for (const auto& body : row.bodies) EXPECT_TRUE(row.planner.mayRestEarly(*body)) << "nothing touches";
  row.touching = true;
  row.step();
  EXPECT_FALSE(row.planner.mayRestEarly(*row.bodies[0]));
  EXPECT_FALSE(row.planner.mayRestEarly(*row.bodies[1]));
  EXPECT_TRUE(row.planner.mayRestEarly(*row.bodies[2]));
  EXPECT_TRUE(row.planner.mayRestEarly(*row.bodies[3]));
}

TEST(Planner, LetsNoBodyRestEarlyThatIsImportant) {
  PlannedRow row(3);
  row.touching = true;
  ASSERT_TRUE(row.planner.addPolicy("contact-time"));
  row.step();
  EXPECT_TRUE(row.planner.mayRestEarly(*row.bodies[0]));
  for (int i = 0; i < 60; ++i) row.step();
  EXPECT_FALSE(row.planner.mayRestEarly(*row.bodies[0]));
}

/// Of its only pair, in contact, in a step that is out of units.
int keepsFrom(SwitchKind kind, int level, bool credited) {
  PlannedRow row(2);
  row.planner.setBudget(lod::UnitBudget::ofUnits(1.0));
  row.planner.plan({.bodies = row.views, .load = {.objects = 100, .awake = 100}});
  static_cast<void>(row.planner.planPair(row.places[0]));
  PairOutcome outcome;
  outcome.tried = true;
  outcome.choice = {kind, level};
  outcome.touching = true;
  outcome.credited = credited;
  outcome.work.contacts = 4;
  row.planner.take(row.places[0], outcome);
  row.planner.finish();
  row.planner.plan({.bodies = row.views, .load = {.objects = 100, .awake = 100}});
  return row.planner.planPair(row.places[0]).keepsFrom;
}

TEST(Planner, LetsPairsKeepTheirContactsWhereAStepIsShort) {
  EXPECT_EQ(keepsFrom(SwitchKind::kFree, kLevels, false), 0);
  EXPECT_EQ(keepsFrom(SwitchKind::kFree, kLevels, true), 0) << "its finest shapes overlap a little";
  EXPECT_EQ(keepsFrom(SwitchKind::kOnCredit, 2, true), PairPlan::kNever) << "they are held already";
}

/// Of a pair whose look took so many iterations.
PairOutcome inContact(int gjkIterations) {
  PairOutcome outcome;
  outcome.touching = true;
  outcome.work.contacts = 4;
  outcome.work.counts.gjkIterations = gjkIterations;
  return outcome;
}

// So that all others of a portion can have their turn at once, when its first has it: the rest of a step
// finds out what it has taken.
TEST(Planner, DecidesForPortionsWhetherContactsAreKept) {
  PlannedRow row(33);
  row.touching = true;
  row.contacts = 4;
  for (int i = 0; i < 20; ++i) row.step();
  EXPECT_EQ(row.planner.portionOf(row.places[0]), Planner::kNoPortion) << "there is no budget";
  row.planner.setBudget(lod::UnitBudget::ofUnits(1.5 * row.planner.counts().units));
  for (int i = 0; i < 20; ++i) row.step();
  row.planner.plan({.bodies = row.views, .load = {.objects = 33, .awake = 33, .broadphasePairs = 32}});
  std::vector<int> sizes(static_cast<std::size_t>(row.planner.countPortions()));
  for (const int place : row.places) ++sizes[static_cast<std::size_t>(row.planner.portionOf(place))];
  EXPECT_EQ(sizes, (std::vector<int>{16, 8, 4, 2, 1, 1, 0}));
  EXPECT_EQ(row.planner.planPair(row.places[0]).keepsFrom, PairPlan::kNever);
  row.planner.take(row.places[0], inContact(100'000));
  EXPECT_EQ(row.planner.planPair(row.places[15]).keepsFrom, PairPlan::kNever)
      << "as the first of its portion";
  EXPECT_EQ(row.planner.planPair(row.places[16]).keepsFrom, 0);
  EXPECT_EQ(row.planner.planPair(row.places[23]).keepsFrom, 0);
}

// Wherever they are in the table: a pair of the last portion knows what most of the step has taken.
TEST(Planner, HasPortionsOfPairsWhoseTurnsComeOneAfterTheOther) {
  PlannedRow row(9);
  row.touching = true;
  row.contacts = 4;
  std::ranges::reverse(row.places);
  row.planner.setBudget(lod::UnitBudget::ofUnits(1e6));
  for (int i = 0; i < 3; ++i) row.step();
  row.planner.plan({.bodies = row.views, .load = {.objects = 9, .awake = 9, .broadphasePairs = 8}});
  std::vector<int> portions;
  for (const int place : row.places) portions.push_back(row.planner.portionOf(place));
  EXPECT_EQ(portions, (std::vector<int>{0, 0, 0, 0, 1, 1, 2, 3}));
}

// The clock has less for the rest of a step than was thought when it began.
TEST(Planner, LooksAtTheClockAmongThePairs) {
  for (const bool isSlow : {false, true}) {
    PlannedRow row(33);
    row.touching = true;
    row.contacts = 4;
    const BudgetUnits last{.given = 1e6, .revised = isSlow ? 100.0 : 1e6, .settled = 1e6};
    std::vector<BudgetUnits> steps(100, {1e6, 1e6, 1e6});
    steps.back() = last;
    row.planner.setBudget(lod::UnitBudget::replay(steps));
    for (int i = 0; i < 99; ++i) row.step();
    row.planner.plan({.bodies = row.views, .load = {.objects = 33, .awake = 33, .broadphasePairs = 32}});
    for (std::size_t i = 0; i < 16; ++i) {
      EXPECT_EQ(row.planner.planPair(row.places[i]).keepsFrom, PairPlan::kNever);
      row.planner.take(row.places[i], inContact(100));
    }
    EXPECT_EQ(row.planner.planPair(row.places[16]).keepsFrom, isSlow ? 0 : PairPlan::kNever);
    row.planner.finish();
    EXPECT_EQ(row.planner.counts().budgetUnits, last);
  }
}

TEST(Planner, KnowsWhatCouldNotBeGivenUp) {
  for (const SwitchKind kind : {SwitchKind::kBlocked, SwitchKind::kFree}) {
    PlannedRow row(2);
    row.planner.setBudget(lod::UnitBudget::ofUnits(10.0));
    row.step();
    row.step(kind);
    const bool wasRefused = kind == SwitchKind::kBlocked;
    EXPECT_EQ(row.level(0), wasRefused ? kLevels : 1);
    EXPECT_EQ(row.planner.pair(row.places[0]).bound == row.planner.pair(row.places[0]).taken, wasRefused);
  }
}

// What policies are shown of pairs that come up after the plan is the same table.
TEST(Planner, PlansAPairThatComesUpInTheNarrowphase) {
  PlannedRow row(3);
  ASSERT_TRUE(row.planner.addPolicy("coarsest"));
  row.planner.plan({.bodies = row.views, .load = {.objects = 3, .awake = 3, .broadphasePairs = 2}});
  int place = -1;
  row.planner.addPair(*row.bodies[0], *row.bodies[2], kLevels, 100.0, &place);
  row.take(place, SwitchKind::kFree);
  EXPECT_EQ(row.planner.pair(place).view.level, 1);
  row.planner.finish();
}

}  // namespace
}  // namespace scatter::pairs
