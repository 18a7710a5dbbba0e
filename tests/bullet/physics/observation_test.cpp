#include <gtest/gtest.h>
#include <scatter/bullet/bullet_physics.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "bullet/physics/swarm.h"

// What observe() tells of small worlds whose truth is known.

namespace scatter::test {
namespace {

Observation observe(const Physics& physics, const ObservationParts& parts = {}) {
  Observation seen;
  physics.diagnostics().observe(parts, seen);
  return seen;
}

ObservedBody bodyIn(const Physics& physics, BodyId body) {
  const Observation seen = observe(physics, {.bodies = true, .pairs = false, .contacts = false});
  const auto found = std::find_if(seen.bodies.begin(), seen.bodies.end(),
                                  [body](const ObservedBody& one) { return one.body == body; });
  EXPECT_NE(found, seen.bodies.end());
  return found == seen.bodies.end() ? ObservedBody{} : *found;
}

/// The pair of two bodies; of no level and no bodies if their bounds do not overlap.
ObservedPair pairIn(const Physics& physics, BodyId a, BodyId b) {
  const Observation seen = observe(physics, {.bodies = false, .pairs = true, .contacts = false});
  for (const ObservedPair& pair : seen.pairs) {
    if ((pair.a == a && pair.b == b) || (pair.a == b && pair.b == a)) return pair;
  }
  return {};
}

/// Without gravity: a cube at the origin and another one, `apart` metres beside it along x.
struct TwoCubes {
  explicit TwoCubes(const PhysicsDef& def, float apart) : physics(makeBulletPhysics(def)) {
    a = create(*physics, bodyAt({}, cubeLevels()));
    b = create(*physics, bodyAt({1.0F + apart, 0.0F, 0.0F}, cubeLevels()));
  }
  void step(int count = 1) const { stepBy(*physics, count); }

  std::unique_ptr<Physics> physics;
  BodyId a{};
  BodyId b{};
};

TEST(Observation, TellsSleepIslandsAndBounds) {
  PhysicsDef def;
  def.gravity = kEarth;
  const auto physics = makeBulletPhysics(def);
  const BodyId ground = createGround(*physics);
  BodyDef box = bodyAt({0.0F, 0.5F, 0.0F});
  box.mayRest = true;
  const BodyId lower = create(*physics, box);
  box.pose.position.y = 1.5F;
  const BodyId upper = create(*physics, box);
  const BodyId alone = create(*physics, bodyAt({9.0F, 5.0F, 0.0F}));
  physics->step(kStep);
  EXPECT_FALSE(bodyIn(*physics, lower).asleep);
  stepBy(*physics, 400);

  EXPECT_TRUE(bodyIn(*physics, lower).asleep);
  EXPECT_TRUE(bodyIn(*physics, upper).asleep);
  EXPECT_FALSE(bodyIn(*physics, alone).asleep);
  EXPECT_FALSE(bodyIn(*physics, ground).asleep);
  EXPECT_EQ(bodyIn(*physics, lower).island, static_cast<std::int64_t>(lower));
  EXPECT_EQ(bodyIn(*physics, upper).island, static_cast<std::int64_t>(lower)) << "named after its first body";
  EXPECT_EQ(bodyIn(*physics, alone).island, static_cast<std::int64_t>(alone));
  EXPECT_EQ(bodyIn(*physics, ground).island, -1);

  const ObservedBody seen = bodyIn(*physics, upper);
  expectNear(seen.boundsMin, {-0.5F, 1.0F, -0.5F}, 0.05F);
  expectNear(seen.boundsMax, {0.5F, 2.0F, 0.5F}, 0.05F);
  EXPECT_LE(seen.boundsMax.x, 0.55F);
  EXPECT_GE(seen.boundsMax.x, 0.5F);
}

TEST(Observation, JoinedBodiesAreOneIsland) {
  const auto physics = makeBulletPhysics(PhysicsDef{});
  JointDef joint;
  joint.bodyA = create(*physics, bodyAt({}));
  joint.bodyB = create(*physics, bodyAt({5.0F, 0.0F, 0.0F}));
  ASSERT_TRUE(physics->createJoint(joint));
  physics->step(kStep);
  EXPECT_EQ(bodyIn(*physics, joint.bodyB).island, static_cast<std::int64_t>(joint.bodyA));
}

TEST(Observation, BoundsOfAHybridAreThoseOfLevelOne) {
  TwoCubes w(worldOf(WorldKind::kHybrid), 4.0F);
  w.step();
  EXPECT_GE(bodyIn(*w.physics, w.a).boundsMax.y, 0.55F);
  EXPECT_LT(bodyIn(*w.physics, w.a).boundsMax.y, 0.6F);
}

TEST(Observation, ContactsCarryWhatTheyCarry) {
  PhysicsDef def;
  def.gravity = kEarth;
  const auto physics = makeBulletPhysics(def);
  const BodyId ground = createGround(*physics);
  const BodyId box = create(*physics, bodyAt({0.0F, 0.5F, 0.0F}));
  stepBy(*physics, 120);
  const Observation seen = observe(*physics);
  ASSERT_EQ(seen.contacts.size(), 4U);
  float impulse = 0.0F;
  for (const ObservedContact& contact : seen.contacts) {
    EXPECT_TRUE((contact.a == ground && contact.b == box) || (contact.a == box && contact.b == ground));
    // The normal points to A.
    expectNear(contact.normal, {0.0F, contact.a == box ? 1.0F : -1.0F, 0.0F}, 1e-3F);
    EXPECT_NEAR(contact.distance, 0.0F, 0.01F);
    EXPECT_EQ(contact.credit, 0.0F);
    EXPECT_FALSE(contact.kept);
    EXPECT_NEAR(std::abs(contact.pointA.x), 0.5F, 0.01F);
    EXPECT_NEAR(contact.pointB.y, 0.0F, 0.01F);
    impulse += contact.impulse;
  }
  // 2 kg under 10 m/s² for a sixtieth of a second.
  EXPECT_NEAR(impulse, 20.0F / 60.0F, 0.02F);
}

TEST(Observation, TellsApartNearAndTouching) {
  for (const WorldKind kind : {WorldKind::kStandard, WorldKind::kHybrid}) {
    const auto nearness = [kind](float apart) {
      const auto physics = makeBulletPhysics(worldOf(kind));
      const BodyId cube = create(*physics, bodyAt({}));
      const BodyId ball = create(*physics, bodyAt({2.5F + apart, 0.0F, 0.0F}, Sphere{2.0F}));
      physics->step(kStep);
      return pairIn(*physics, cube, ball).nearness;
    };
    EXPECT_EQ(nearness(0.005F), Nearness::kTouching);
    EXPECT_EQ(nearness(0.012F), Nearness::kNear);
  }
  // Only the bounds of level 1 overlap.
  TwoCubes w(worldOf(WorldKind::kHybrid), 0.09F);
  w.step();
  const ObservedPair pair = pairIn(*w.physics, w.a, w.b);
  EXPECT_EQ(pair.level, 2);
  EXPECT_EQ(pair.nearness, Nearness::kApart);
}

TEST(Observation, PairsOfAStandardWorldHaveNoLevels) {
  TwoCubes w(worldOf(WorldKind::kStandard), 0.0F);
  w.step();
  const ObservedPair pair = pairIn(*w.physics, w.a, w.b);
  EXPECT_NE(pair.a, pair.b);
  EXPECT_EQ(pair.level, 0);
  EXPECT_EQ(pair.levelCount, 0);
  EXPECT_FALSE(pair.request);
  EXPECT_EQ(bodyIn(*w.physics, w.a).coarsestLevel, 2);
  EXPECT_FALSE(bodyIn(*w.physics, w.a).request);
}

// Of the work that a hybrid world counts, what belongs to pairs; in a standard one, what contacts take.
TEST(Observation, TellsWhatPairsTook) {
  for (const WorldKind kind : {WorldKind::kStandard, WorldKind::kHybrid}) {
    TwoCubes w(worldOf(kind), 0.0F);
    EXPECT_EQ(pairIn(*w.physics, w.a, w.b).units, 0.0F);
    w.step();
    EXPECT_GT(pairIn(*w.physics, w.a, w.b).units, 0.0F);
  }
  TwoCubes apart(worldOf(WorldKind::kHybrid), 0.09F);
  TwoCubes touching(worldOf(WorldKind::kHybrid), 0.0F);
  apart.step();
  touching.step();
  EXPECT_LT(pairIn(*apart.physics, apart.a, apart.b).units,
            pairIn(*touching.physics, touching.a, touching.b).units);
}

TEST(Observation, PairsTakeNoMoreThanTheStep) {
  PhysicsDef def = worldOf(WorldKind::kHybrid);
  def.switching.budget.units = 2000.0;
  Swarm swarm(def);
  double most = 0.0;
  for (int i = 0; i < 40; ++i) {
    swarm.step(5);
    double units = 0.0;
    for (const ObservedPair& pair : observe(swarm.physics()).pairs) units += static_cast<double>(pair.units);
    ASSERT_LE(units, swarm.physics().counters().costUnits);
    most = std::max(most, units);
  }
  EXPECT_GT(most, 10.0);
}

TEST(Observation, LevelsInUseAreThoseOfTheBodysPairs) {
  TwoCubes w(worldOf(WorldKind::kHybrid), 0.09F);
  const BodyId c = create(*w.physics, bodyAt({0.0F, 1.12F, 0.0F}, cubeLevels()));
  ASSERT_TRUE(w.physics->switching().requestLevel(c, 1, Scope::kLocal));
  w.step();
  EXPECT_EQ(pairIn(*w.physics, w.a, w.b).level, 2);
  EXPECT_EQ(pairIn(*w.physics, w.a, c).level, 1);
  EXPECT_EQ(bodyIn(*w.physics, w.a).coarsestLevel, 1);
  EXPECT_EQ(bodyIn(*w.physics, w.a).finestLevel, 2);
  EXPECT_EQ(bodyIn(*w.physics, c).finestLevel, 1);
}

TEST(Observation, BodyRequestIsBlockedByTheBodyInItsWay) {
  TwoCubes w(worldOf(WorldKind::kHybrid, Switching::kBody), 0.02F);
  w.step();
  ASSERT_TRUE(w.physics->switching().requestLevel(w.a, 1, Scope::kGroup));
  ObservedRequest request = bodyIn(*w.physics, w.a).request.value();
  EXPECT_EQ(request.target, 1);
  EXPECT_EQ(request.scope, Scope::kGroup);
  EXPECT_EQ(request.policy, "program");
  EXPECT_EQ(request.state, RequestState::kUntried);
  EXPECT_EQ(request.waitingSteps, 0U);

  w.step(3);
  request = bodyIn(*w.physics, w.a).request.value();
  EXPECT_EQ(request.state, RequestState::kBlocked);
  EXPECT_EQ(request.blockedBy, w.b);
  EXPECT_EQ(request.waitingSteps, 3U);
  EXPECT_EQ(request.retrySteps, 8U) << "tried in the first of the three steps, repeated after ten";

  w.physics->destroyBody(w.b);
  request = bodyIn(*w.physics, w.a).request.value();
  EXPECT_EQ(request.blockedBy, BodyId{}) << "it is gone";
  w.step(7);
  EXPECT_TRUE(bodyIn(*w.physics, w.a).request);
  w.step();
  EXPECT_FALSE(bodyIn(*w.physics, w.a).request);
  EXPECT_EQ(bodyIn(*w.physics, w.a).coarsestLevel, 1);
}

TEST(Observation, RequestOfASleepingBodyWaitsForItToWake) {
  PhysicsDef def = worldOf(WorldKind::kHybrid, Switching::kBody);
  def.gravity = kEarth;
  const auto physics = makeBulletPhysics(def);
  createGround(*physics);
  BodyDef box = bodyAt({0.0F, 0.5F, 0.0F}, cubeLevels());
  box.mayRest = true;
  const BodyId body = create(*physics, box);
  stepBy(*physics, 300);
  ASSERT_TRUE(bodyIn(*physics, body).asleep);
  ASSERT_TRUE(physics->switching().requestLevel(body, 1, Scope::kLocal));
  stepBy(*physics, 5);
  EXPECT_EQ(bodyIn(*physics, body).request.value().state, RequestState::kAsleep);
  EXPECT_EQ(bodyIn(*physics, body).request.value().waitingSteps, 5U);
}

TEST(Observation, PairRequestIsBlockedWithoutCredit) {
  PhysicsDef def = worldOf(WorldKind::kHybrid);
  def.switching.credit = false;
  TwoCubes w(def, 0.0F);
  w.step();
  ASSERT_TRUE(w.physics->switching().requestLevel(w.a, 1, Scope::kLocal));
  EXPECT_EQ(bodyIn(*w.physics, w.a).request.value().state, RequestState::kUntried);
  w.step();
  const ObservedRequest ofPair = pairIn(*w.physics, w.a, w.b).request.value();
  EXPECT_EQ(ofPair.target, 1);
  EXPECT_EQ(ofPair.policy, "program");
  EXPECT_EQ(ofPair.state, RequestState::kBlocked);
  EXPECT_GE(ofPair.retrySteps, 10U);
  EXPECT_EQ(ofPair.waitingSteps, 0U) << "the wish came up in this step";
  const ObservedRequest ofBody = bodyIn(*w.physics, w.a).request.value();
  EXPECT_EQ(ofBody.state, RequestState::kBlocked);
  EXPECT_EQ(ofBody.blockedBy, w.b);
  EXPECT_EQ(ofBody.retrySteps, ofPair.retrySteps);
  EXPECT_FALSE(bodyIn(*w.physics, w.b).request);

  w.step();
  EXPECT_EQ(pairIn(*w.physics, w.a, w.b).request.value().retrySteps, ofPair.retrySteps - 1);
  EXPECT_EQ(pairIn(*w.physics, w.a, w.b).request.value().waitingSteps, 1U);
}

TEST(Observation, PairOnCreditShowsWhatItKeeps) {
  PhysicsDef def = worldOf(WorldKind::kHybrid);
  TwoCubes w(def, 0.0F);
  w.step();
  EXPECT_FALSE(pairIn(*w.physics, w.a, w.b).credited);
  ASSERT_TRUE(w.physics->switching().requestLevel(w.a, 1, Scope::kLocal));
  w.step();
  const ObservedPair pair = pairIn(*w.physics, w.a, w.b);
  EXPECT_TRUE(pair.credited);
  EXPECT_EQ(pair.level, 1);
  EXPECT_EQ(pair.levelCount, 2);
  EXPECT_EQ(pair.nearness, Nearness::kTouching);
  const Observation seen = observe(*w.physics);
  ASSERT_FALSE(seen.contacts.empty());
  for (const ObservedContact& contact : seen.contacts) {
    EXPECT_TRUE(contact.kept);
    EXPECT_NEAR(contact.distance, 0.0F, 0.01F) << "of the finest shapes, not of boxes that overlap by 10 cm";
  }
}

TEST(Observation, IsEmptyWhereNothingIsAskedFor) {
  TwoCubes w(worldOf(WorldKind::kHybrid), 0.0F);
  w.step();
  Observation seen = observe(*w.physics);
  EXPECT_EQ(seen.bodies.size(), 2U);
  EXPECT_EQ(seen.pairs.size(), 1U);
  EXPECT_FALSE(seen.contacts.empty());
  w.physics->diagnostics().observe({.bodies = false, .pairs = false, .contacts = true}, seen);
  EXPECT_TRUE(seen.bodies.empty());
  EXPECT_TRUE(seen.pairs.empty());
  EXPECT_FALSE(seen.contacts.empty());
  w.physics->diagnostics().observe({.bodies = false, .pairs = false, .contacts = false}, seen);
  EXPECT_TRUE(seen.contacts.empty());
}

TEST(Observation, LeavesOutWhatIsDestroyed) {
  TwoCubes w(worldOf(WorldKind::kHybrid), 0.0F);
  w.step();
  w.physics->destroyBody(w.a);
  const Observation seen = observe(*w.physics);
  ASSERT_EQ(seen.bodies.size(), 1U);
  EXPECT_EQ(seen.bodies[0].body, w.b);
  EXPECT_TRUE(seen.pairs.empty());
  EXPECT_TRUE(seen.contacts.empty());
}

/// Standard, by pair without and with a policy, by body, and with the engine's own narrowphase.
std::vector<PhysicsDef> swarmWorlds() {
  PhysicsDef bullets = worldOf(WorldKind::kHybrid);
  bullets.collision.narrowphase = Narrowphase::kEngine;
  return {worldOf(WorldKind::kStandard), worldOf(WorldKind::kHybrid),
          worldOf(WorldKind::kHybrid, Switching::kPair, Policy::kProximity),
          worldOf(WorldKind::kHybrid, Switching::kBody, Policy::kProximity), bullets};
}

TEST(Observation, ChangesNoWorld) {
  for (const PhysicsDef& def : swarmWorlds()) {
    Swarm observed(def);
    Swarm left(def);
    Observation seen;
    std::size_t contacts = 0;
    for (int i = 0; i < 240; ++i) {
      // Pairs in contact go coarser, on credit.
      if (i == 160) {
        EXPECT_EQ(observed.squeeze(), left.squeeze());
      }
      observed.step();
      left.step();
      observed.physics().diagnostics().observe({}, seen);
      contacts += seen.contacts.size();
      ASSERT_EQ(observed.physics().stateHash(), left.physics().stateHash()) << "step " << i;
    }
    EXPECT_GT(contacts, 1000U) << "nothing was at stake";
  }
}

/// What the counters of a step say, counted in an observation of it.
void expectCounted(const Observation& seen, const StepCounters& counters) {
  EXPECT_EQ(seen.bodies.size(), counters.objects);
  EXPECT_EQ(seen.pairs.size(), counters.overlappingPairs);
  EXPECT_EQ(seen.contacts.size(), counters.contacts);
  const auto credited = std::count_if(seen.pairs.begin(), seen.pairs.end(),
                                      [](const ObservedPair& pair) { return pair.credited; });
  EXPECT_EQ(credited, counters.creditedPairs);
  std::uint32_t requests = 0;
  for (const ObservedPair& pair : seen.pairs) requests += pair.request ? 1U : 0U;
  for (const ObservedBody& body : seen.bodies) requests += body.request ? 1U : 0U;
  EXPECT_EQ(requests, counters.requests);
}

TEST(Observation, AgreesWithTheCounters) {
  for (const PhysicsDef& def : swarmWorlds()) {
    Swarm swarm(def);
    for (int i = 0; i < 48; ++i) {
      swarm.step(5);
      if (i == 32) static_cast<void>(swarm.squeeze());
      const Observation seen = observe(swarm.physics());
      expectCounted(seen, swarm.physics().counters());
      for (const ObservedPair& pair : seen.pairs) {
        ASSERT_EQ(pair.level, swarm.physics().switching().pairLevel(pair.a, pair.b));
      }
    }
  }
}

TEST(Observation, CreditIsCountedInTheDistance) {
  Swarm swarm(worldOf(WorldKind::kHybrid));
  swarm.step(160);
  ASSERT_TRUE(swarm.squeeze());
  int credited = 0;
  int wrong = 0;
  int kept = 0;
  for (int i = 0; i < 120; ++i) {
    swarm.step();
    const Observation seen = observe(swarm.physics());
    for (const ObservedContact& contact : seen.contacts) {
      const float between = glm::dot(contact.pointA - contact.pointB, contact.normal);
      credited += contact.credit > 0.001F ? 1 : 0;
      wrong += std::abs(contact.distance - contact.credit - between) > 1e-4F ? 1 : 0;
      kept += contact.kept ? 1 : 0;
    }
  }
  EXPECT_GT(credited, 50);
  EXPECT_GT(kept, 100);
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace scatter::test
