#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <scatter/bullet/bullet_physics.h>

#include <algorithm>
#include <vector>

#include "bullet/physics/swarm.h"

// What is changed while a world runs: budgets, policies, switching, what is frozen and held, and where the
// viewer looks.

namespace scatter::test {
namespace {

using testing::HasSubstr;

/// Pairs of which at least one body has levels.
struct LevelCount {
  int coarse = 0;
  int finest = 0;
};

LevelCount countLevels(const Physics& physics) {
  Observation seen;
  physics.diagnostics().observe({.bodies = false, .pairs = true, .contacts = false}, seen);
  LevelCount count;
  for (const ObservedPair& pair : seen.pairs) {
    if (pair.levelCount == 0) continue;
    ++(pair.level < pair.levelCount ? count.coarse : count.finest);
  }
  return count;
}

TEST(BudgetAtRunTime, TakesDetailAwayAndGivesItBack) {
  Swarm swarm(worldOf(WorldKind::kHybrid));
  swarm.step(160);
  EXPECT_EQ(countLevels(swarm.physics()).coarse, 0);
  ASSERT_TRUE(swarm.squeeze());
  swarm.step(60);
  EXPECT_EQ(swarm.physics().switching().budgetUnits().given, 80.0);
  EXPECT_GT(countLevels(swarm.physics()).coarse, 20);
  const int coarse = countLevels(swarm.physics()).coarse;
  ASSERT_TRUE(swarm.physics().switching().setBudget({}));
  swarm.step(240);
  EXPECT_EQ(swarm.physics().switching().budgetUnits().given, 0.0);
  EXPECT_LT(countLevels(swarm.physics()).coarse, coarse);
}

TEST(BudgetAtRunTime, IsTheSameEveryTime) {
  Swarm first(worldOf(WorldKind::kHybrid));
  Swarm second(worldOf(WorldKind::kHybrid));
  for (int i = 0; i < 300; ++i) {
    for (Swarm* swarm : {&first, &second}) {
      Physics& physics = swarm->physics();
      if (i == 130) {
        EXPECT_TRUE(physics.switching().setBudget({.units = 150.0}));
      }
      if (i == 180) {
        EXPECT_TRUE(physics.switching().setPolicies(Policy::kNone, {"speed", "contact-time"}));
      }
      if (i == 220) {
        EXPECT_TRUE(swarm->squeeze());
      }
      if (i == 260) {
        EXPECT_TRUE(physics.switching().setPolicies(Policy::kProximity, {}));
      }
      swarm->step();
    }
    ASSERT_EQ(first.physics().stateHash(), second.physics().stateHash()) << "step " << i;
  }
}

TEST(BudgetAtRunTime, NeedsPairSwitching) {
  EXPECT_FALSE(makeBulletPhysics(worldOf(WorldKind::kStandard))->switching().setBudget({.units = 80.0}));
  EXPECT_FALSE(makeBulletPhysics(worldOf(WorldKind::kHybrid, Switching::kBody))
                   ->switching()
                   .setBudget({.units = 80.0}));
}

TEST(PoliciesAtRunTime, ReplaceThoseBefore) {
  Swarm swarm(worldOf(WorldKind::kHybrid));
  swarm.step(160);
  ASSERT_TRUE(swarm.physics().switching().setPolicies(Policy::kCoarsest, {}));
  swarm.step();
  EXPECT_EQ(countLevels(swarm.physics()).finest, 0) << "on credit where they touch";
  ASSERT_TRUE(swarm.physics().switching().setPolicies(Policy::kNone, {}));
  swarm.step(240);
  EXPECT_GT(countLevels(swarm.physics()).finest, 20);
}

TEST(PoliciesAtRunTime, RefuseWhatIsNotKnownAndStay) {
  Swarm swarm(worldOf(WorldKind::kHybrid, Switching::kPair, Policy::kCoarsest));
  const auto set = swarm.physics().switching().setPolicies(Policy::kNone, {"speed", "sped"});
  ASSERT_FALSE(set);
  EXPECT_THAT(set.error().message, HasSubstr("\"sped\""));
  EXPECT_THAT(set.error().message, HasSubstr("speed"));
  swarm.step(160);
  EXPECT_EQ(countLevels(swarm.physics()).finest, 0) << "still everything at level 1";
}

TEST(PoliciesAtRunTime, OfBodiesAskThemAll) {
  const auto physics = makeBulletPhysics(worldOf(WorldKind::kHybrid, Switching::kBody));
  const BodyId a = create(*physics, bodyAt({}, cubeLevels()));
  const BodyId b = create(*physics, bodyAt({9.0F, 0.0F, 0.0F}, cubeLevels()));
  ASSERT_TRUE(physics->switching().setPolicies(Policy::kCoarsest, {}));
  physics->step(kStep);
  EXPECT_EQ(physics->switching().level(a), 1);
  EXPECT_EQ(physics->switching().level(b), 1);
  EXPECT_EQ(physics->switching().level(create(*physics, bodyAt({20.0F, 0.0F, 0.0F}, cubeLevels()))), 1);
  ASSERT_TRUE(physics->switching().setPolicies(Policy::kFinest, {}));
  physics->step(kStep);
  EXPECT_EQ(physics->switching().level(a), 2);
  const auto named = physics->switching().setPolicies(Policy::kNone, {"speed"});
  ASSERT_FALSE(named);
  EXPECT_THAT(named.error().message, HasSubstr("needs pair switching"));
  EXPECT_FALSE(makeBulletPhysics(PhysicsDef{})->switching().setPolicies(Policy::kNone, {}));
}

TEST(SwitchingAtRunTime, GoesFromPairsToBodiesAndBack) {
  Swarm swarm(worldOf(WorldKind::kHybrid, Switching::kPair, Policy::kProximity));
  const Physics& physics = swarm.physics();
  LevelSwitching& switching = swarm.physics().switching();
  swarm.step(60);
  const double before = physics.kineticEnergy();
  ASSERT_TRUE(switching.setSwitching(Switching::kBody));
  EXPECT_EQ(physics.kineticEnergy(), before);
  for (const BodyId body : swarm.bodies()) EXPECT_EQ(switching.level(body), switching.levelCount(body));
  swarm.step(120);
  EXPECT_TRUE(std::any_of(swarm.bodies().begin(), swarm.bodies().end(), [&](BodyId body) {
    return switching.level(body) < switching.levelCount(body);
  })) << "bodies switch now";
  EXPECT_FALSE(switching.setBudget({.units = 80.0}));
  ASSERT_TRUE(switching.setSwitching(Switching::kPair));
  for (const BodyId body : swarm.bodies()) EXPECT_EQ(switching.level(body), switching.levelCount(body));
  ASSERT_TRUE(swarm.squeeze());
  swarm.step(120);
  EXPECT_GT(countLevels(physics).coarse, 20);
  EXPECT_FALSE(physics.findInvalidState());
}

TEST(SwitchingAtRunTime, IsTheSameEveryTime) {
  Swarm first(worldOf(WorldKind::kHybrid));
  Swarm second(worldOf(WorldKind::kHybrid));
  for (int i = 0; i < 240; ++i) {
    for (Swarm* swarm : {&first, &second}) {
      if (i == 100) {
        EXPECT_TRUE(swarm->physics().switching().setSwitching(Switching::kBody));
      }
      if (i == 160) {
        EXPECT_TRUE(swarm->physics().switching().setSwitching(Switching::kPair));
      }
      swarm->step();
    }
    ASSERT_EQ(first.physics().stateHash(), second.physics().stateHash()) << "step " << i;
  }
}

TEST(SwitchingAtRunTime, IsRefusedWhereItWouldPush) {
  const auto physics = makeBulletPhysics(worldOf(WorldKind::kHybrid));
  const BodyId a = create(*physics, bodyAt({}, cubeLevels()));
  const BodyId b = create(*physics, bodyAt({0.8F, 0.0F, 0.0F}, cubeLevels()));
  physics->step(kStep);
  ASSERT_TRUE(physics->switching().requestLevel(a, 1, Scope::kLocal));
  physics->step(kStep);
  ASSERT_EQ(physics->switching().pairLevel(a, b), 1)
      << "on credit, with the finest shapes deep in each other";
  const auto set = physics->switching().setSwitching(Switching::kBody);
  ASSERT_FALSE(set);
  EXPECT_THAT(set.error().message, HasSubstr("1 pair(s)"));
  EXPECT_EQ(physics->switching().pairLevel(a, b), 1) << "nothing has happened";
  EXPECT_FALSE(makeBulletPhysics(PhysicsDef{})->switching().setSwitching(Switching::kPair));
}

/// Whether all pairs of a body are at their finest level, and there are some.
bool isFinelyMet(const Physics& physics, BodyId body) {
  Observation seen;
  physics.diagnostics().observe({.bodies = false, .pairs = true, .contacts = false}, seen);
  int fine = 0;
  for (const ObservedPair& pair : seen.pairs) {
    if (pair.levelCount == 0 || (pair.a != body && pair.b != body)) continue;
    if (pair.level < pair.levelCount) return false;
    ++fine;
  }
  return fine > 0;
}

TEST(Holding, KeepsAllPairsOfABodyFine) {
  // A hybrid, and a sphere that has no levels itself.
  for (const std::size_t index : {12UL, 14UL}) {
    Swarm swarm(worldOf(WorldKind::kHybrid, Switching::kPair, Policy::kCoarsest));
    Physics& physics = swarm.physics();
    const BodyId body = swarm.bodies()[index];
    swarm.step(20);
    ASSERT_TRUE(physics.switching().setHeld(body, true));
    ASSERT_TRUE(swarm.squeeze());
    swarm.step(120);
    EXPECT_TRUE(isFinelyMet(physics, body)) << index;
    EXPECT_GT(countLevels(physics).coarse, 20);
    Observation seen;
    physics.diagnostics().observe({}, seen);
    EXPECT_TRUE(seen.bodies[index].held);
    ASSERT_TRUE(physics.switching().setHeld(body, false));
    swarm.step(60);
    EXPECT_FALSE(isFinelyMet(physics, body)) << index;
  }
}

TEST(Holding, AsksABodyToBeFinest) {
  for (const Policy policy : {Policy::kNone, Policy::kCoarsest, Policy::kProximity}) {
    const auto physics = makeBulletPhysics(worldOf(WorldKind::kHybrid, Switching::kBody, policy));
    const BodyId body = create(*physics, bodyAt({}, cubeLevels()));
    create(*physics, bodyAt({1.12F, 0.0F, 0.0F}, cubeLevels()));
    physics->switching().requestLevel(body, 1, Scope::kLocal);
    stepBy(*physics, 30);
    ASSERT_EQ(physics->switching().level(body), 1);
    ASSERT_TRUE(physics->switching().setHeld(body, true));
    stepBy(*physics, 15);
    EXPECT_EQ(physics->switching().level(body), 2);
    physics->switching().requestLevel(body, 1, Scope::kLocal);
    stepBy(*physics, 15);
    EXPECT_EQ(physics->switching().level(body), 2) << "whatever is asked for";
    ASSERT_TRUE(physics->switching().setHeld(body, false));
    stepBy(*physics, 60);
    EXPECT_EQ(physics->switching().level(body), policy == Policy::kNone ? 2 : 1);
  }
}

TEST(Holding, EndsWithTheBodyAndNeedsAHybridWorld) {
  Swarm swarm(worldOf(WorldKind::kHybrid));
  ASSERT_TRUE(swarm.physics().switching().setHeld(swarm.bodies()[0], true));
  swarm.physics().destroyBody(swarm.bodies()[0]);
  swarm.physics().step(kStep);
  const auto standard = makeBulletPhysics(PhysicsDef{});
  EXPECT_FALSE(standard->switching().setHeld(create(*standard, bodyAt({})), true));
}

/// The levels of all pairs, for a viewer who looks at one side of the swarm.
std::vector<int> levelsSeenFrom(const char* policy, const std::optional<ViewFocus>& focus) {
  PhysicsDef def = worldOf(WorldKind::kHybrid);
  def.switching.policies = {policy};
  Swarm swarm(def);
  swarm.physics().switching().setFocus(focus);
  swarm.step(130);
  EXPECT_TRUE(swarm.physics().switching().setBudget({.units = 150.0}));
  swarm.step(120);
  Observation seen;
  swarm.physics().diagnostics().observe({.bodies = false, .pairs = true, .contacts = false}, seen);
  std::vector<int> levels;
  for (const ObservedPair& pair : seen.pairs) levels.push_back(pair.level);
  return levels;
}

TEST(ViewersFocus, IsForThePolicyThatAsks) {
  const ViewFocus side{{-4.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}, 1.0F};
  EXPECT_NE(levelsSeenFrom("focus", side), levelsSeenFrom("focus", std::nullopt));
  EXPECT_EQ(levelsSeenFrom("focus", side), levelsSeenFrom("focus", side));
  EXPECT_EQ(levelsSeenFrom("speed", side), levelsSeenFrom("speed", std::nullopt));
}

}  // namespace
}  // namespace scatter::test
