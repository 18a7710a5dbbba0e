#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <LinearMath/btQuickprof.h>
#include <gtest/gtest.h>
#include <scatter/bullet/bullet_physics.h>
#include <scatter/world/world.h>

#include <chrono>
#include <numeric>

#include "bullet/physics/shapes.h"
#include "world/conformance/physics_conformance.h"

namespace scatter::test {

namespace {

std::unique_ptr<Physics> makeWorld(WorldKind kind, bool profiling = true) {
  PhysicsDef def;
  def.world = kind;
  def.gravity = kEarth;
  def.profiling = profiling;
  return makeBulletPhysics(def);
}

BodyId createIn(Physics& physics, const BodyDef& def) {
  const Result<BodyId> body = physics.createBody(def);
  EXPECT_TRUE(body) << body.error().message;
  return *body;
}

/// Chains, stacks and rollers, all in contact with the ground and each other. No hybrids.
void fillWithJointsAndContacts(Physics& physics) {
  BodyDef ground = bodyAt({}, Plane{});
  ground.motion = Motion::kStatic;
  createIn(physics, ground);
  for (int chain = 0; chain < 4; ++chain) {
    BodyId previous{};
    for (int link = 0; link < 6; ++link) {
      const Vec3 at{static_cast<float>(chain), 0.5F + 0.5F * static_cast<float>(link),
                    0.1F * static_cast<float>(link)};
      BodyDef def = bodyAt(at, link % 2 == 0 ? Shape{Box{Vec3(0.2F)}} : Shape{Sphere{0.2F}});
      def.mayRest = true;
      def.material.rollingFriction = 0.1F;
      const BodyId body = createIn(physics, def);
      if (link > 0) {
        JointDef joint;
        joint.bodyA = previous;
        joint.bodyB = body;
        joint.frame.position = at - Vec3(0.0F, 0.25F, 0.05F);
        if (chain == 1) joint.kind = HingeJoint{-0.5F, 0.5F};
        if (chain == 2) joint.kind = SixDofJoint{};
        if (chain == 3) joint.kind = SliderJoint{-0.1F, 0.1F};
        EXPECT_TRUE(physics.createJoint(joint));
      }
      previous = body;
    }
  }
  for (int i = 0; i < 10; ++i) createIn(physics, bodyAt({1.5F, 0.5F + 1.01F * static_cast<float>(i), 2.0F}));
}

double stage(const Physics& physics, Stage which) {
  return physics.stageTimes()[static_cast<std::size_t>(which)];
}

}  // namespace

TEST(BulletWorld, NamesItsEngine) {
  EXPECT_EQ(makeWorld(WorldKind::kStandard)->engine(), "bullet 3.24");
}

TEST(BulletWorld, ProfilingChangesNothing) {
  auto with = makeWorld(WorldKind::kStandard, true);
  auto without = makeWorld(WorldKind::kStandard, false);
  fillWithJointsAndContacts(*with);
  fillWithJointsAndContacts(*without);
  double joints = 0.0;
  for (int i = 0; i < 600; ++i) {
    with->step(kStep);
    without->step(kStep);
    ASSERT_EQ(with->stateHash(), without->stateHash()) << "step " << i;
    joints += stage(*with, Stage::kNoncontactConstraints);
    EXPECT_EQ(without->stageTimes(), StageTimes{});
  }
  EXPECT_GT(joints, 0.0);
}

TEST(BulletWorld, HybridWorldWithoutHybridsIsTheStandardWorld) {
  auto standard = makeWorld(WorldKind::kStandard);
  auto hybrid = makeWorld(WorldKind::kHybrid);
  fillWithJointsAndContacts(*standard);
  fillWithJointsAndContacts(*hybrid);
  for (int i = 0; i < 600; ++i) {
    standard->step(kStep);
    hybrid->step(kStep);
    ASSERT_EQ(standard->stateHash(), hybrid->stateHash()) << "step " << i;
  }
}

TEST(BulletWorld, FinestPolicyWithTheEnginesCollisionIsTheStandardWorld) {
  PhysicsDef def;
  def.collision.narrowphase = Narrowphase::kEngine;
  def.gravity = kEarth;
  auto standard = makeBulletPhysics(def);
  def.world = WorldKind::kHybrid;
  def.switching.policy = Policy::kFinest;
  auto hybrid = makeBulletPhysics(def);
  for (Physics* physics : {standard.get(), hybrid.get()}) {
    BodyDef ground = bodyAt({}, Plane{});
    ground.motion = Motion::kStatic;
    createIn(*physics, ground);
    createIn(*physics, bodyAt({0.0F, 3.0F, 0.0F}, cubeLevels()));
  }
  for (int i = 0; i < 200; ++i) {
    standard->step(kStep);
    hybrid->step(kStep);
    ASSERT_EQ(standard->stateHash(), hybrid->stateHash()) << "step " << i;
  }
}

TEST(BulletWorld, StagesDoNotTakeMoreThanTheStep) {
  using Clock = std::chrono::steady_clock;
  auto physics = makeWorld(WorldKind::kHybrid);
  fillWithJointsAndContacts(*physics);
  createIn(*physics, bodyAt({9.0F, 3.0F, 0.0F}, cubeLevels()));
  for (int i = 0; i < 100; ++i) {
    const auto start = Clock::now();
    physics->step(kStep);
    const std::chrono::duration<double, std::milli> wall = Clock::now() - start;
    const StageTimes& times = physics->stageTimes();
    EXPECT_LE(std::accumulate(times.begin(), times.end(), 0.0), wall.count());
    for (const Stage seen : {Stage::kUpdateAabbs, Stage::kPredictMotion, Stage::kCollisionDetection,
                             Stage::kIslands, Stage::kNoncontactConstraints, Stage::kContactConstraints,
                             Stage::kIntegrate, Stage::kActivation, Stage::kPlan}) {
      EXPECT_GT(stage(*physics, seen), 0.0) << stageColumn(seen);
    }
  }
}

TEST(BulletWorld, NoJointsNoJointTime) {
  auto physics = makeWorld(WorldKind::kStandard);
  BodyDef ground = bodyAt({}, Plane{});
  ground.motion = Motion::kStatic;
  createIn(*physics, ground);
  createIn(*physics, bodyAt({0.0F, 0.5F, 0.0F}));
  physics->step(kStep);
  EXPECT_EQ(stage(*physics, Stage::kNoncontactConstraints), 0.0);
  EXPECT_EQ(stage(*physics, Stage::kPlan), 0.0);
  EXPECT_GT(stage(*physics, Stage::kContactConstraints), 0.0);
}

namespace {

bool foreignContactAdded(btManifoldPoint&, const btCollisionObjectWrapper*, int, int,
                         const btCollisionObjectWrapper*, int, int) {
  return false;
}
void foreignEnter(const char*) {}
void foreignLeave() {}

}  // namespace

TEST(BulletWorld, PutsGlobalCallbacksBack) {
  const auto contactAdded = gContactAddedCallback;
  auto* const enter = btGetCurrentEnterProfileZoneFunc();
  auto* const leave = btGetCurrentLeaveProfileZoneFunc();
  gContactAddedCallback = foreignContactAdded;
  btSetCustomEnterProfileZoneFunc(foreignEnter);
  btSetCustomLeaveProfileZoneFunc(foreignLeave);
  auto physics = makeWorld(WorldKind::kStandard);
  fillWithJointsAndContacts(*physics);
  physics->step(kStep);
  EXPECT_EQ(gContactAddedCallback, foreignContactAdded);
  EXPECT_EQ(btGetCurrentEnterProfileZoneFunc(), foreignEnter);
  EXPECT_EQ(btGetCurrentLeaveProfileZoneFunc(), foreignLeave);
  gContactAddedCallback = contactAdded;
  btSetCustomEnterProfileZoneFunc(enter);
  btSetCustomLeaveProfileZoneFunc(leave);
}

TEST(BulletWorld, NewContactsAddUpToThoseThereIfNoneIsLost) {
  auto physics = makeWorld(WorldKind::kStandard);
  BodyDef ground = bodyAt({}, Plane{});
  ground.motion = Motion::kStatic;
  createIn(*physics, ground);
  for (int i = 0; i < 5; ++i) createIn(*physics, bodyAt({3.0F * static_cast<float>(i), 0.6F, 0.0F}));
  std::uint32_t added = 0;
  for (int i = 0; i < 120; ++i) {
    physics->step(kStep);
    added += physics->counters().newContacts;
  }
  EXPECT_EQ(physics->counters().contacts, 20U);  // Four corners each.
  EXPECT_EQ(added, 20U);
}

TEST(BulletWorld, HashTellsLevelsApart) {
  const auto hashWith = [](Policy policy) {
    PhysicsDef def;
    def.world = WorldKind::kHybrid;
    def.switching.switching = Switching::kBody;
    def.switching.policy = policy;
    auto physics = makeBulletPhysics(def);
    createIn(*physics, bodyAt({}, cubeLevels()));
    return physics->stateHash();
  };
  EXPECT_NE(hashWith(Policy::kCoarsest), hashWith(Policy::kFinest));
}

TEST(BulletWorld, PolicyDecidesWhereBodiesBegin) {
  PhysicsDef def;
  def.world = WorldKind::kHybrid;
  def.switching.switching = Switching::kBody;
  def.switching.policy = Policy::kCoarsest;
  auto coarsest = makeBulletPhysics(def);
  const BodyId body = createIn(*coarsest, bodyAt({}, cubeLevels()));
  EXPECT_EQ(coarsest->switching().level(body), 1);
  for (int i = 0; i < 100; ++i) coarsest->step(kStep);
  EXPECT_EQ(coarsest->switching().level(body), 1);
  EXPECT_EQ(coarsest->counters().switchesFiner, 0U);

  def.world = WorldKind::kStandard;
  auto standard = makeBulletPhysics(def);
  EXPECT_EQ(standard->switching().level(createIn(*standard, bodyAt({}, cubeLevels()))), 2);
}

namespace {

/// Two hybrids that fly toward each other; how often they asked for a coarser level before they met.
std::uint32_t requestsOnApproach(std::uint32_t loadFinePairs) {
  PhysicsDef def;
  def.world = WorldKind::kHybrid;
  def.switching.switching = Switching::kBody;
  def.switching.policy = Policy::kProximity;
  def.switching.loadFinePairs = loadFinePairs;
  auto physics = makeBulletPhysics(def);
  for (const float side : {-1.0F, 1.0F}) {
    BodyDef ship = bodyAt({3.0F * side, 0.0F, 0.0F}, cubeLevels());
    ship.linearVelocity = {-2.0F * side, 0.0F, 0.0F};
    createIn(*physics, ship);
  }
  std::uint32_t requests = 0;
  for (int i = 0; i < 70; ++i) {
    physics->step(kStep);
    for (const LevelEvent& event : physics->switching().levelEvents()) {
      requests += event.kind == LevelEventKind::kRequested && event.to == 1 ? 1U : 0U;
    }
  }
  return requests;
}

}  // namespace

TEST(BulletWorld, ProximityAsksUnlessTheLoadIsFine) {
  EXPECT_EQ(requestsOnApproach(0), 2U);
  EXPECT_EQ(requestsOnApproach(100), 0U);
}

TEST(BulletWorld, EventsOfCallsBetweenStepsBelongToTheNextStep) {
  PhysicsDef def;
  def.world = WorldKind::kHybrid;
  def.switching.policy = Policy::kNone;
  auto physics = makeBulletPhysics(def);
  const BodyId body = createIn(*physics, bodyAt({}, cubeLevels()));
  physics->step(kStep);
  EXPECT_TRUE(physics->switching().requestLevel(body, 1, Scope::kGlobal));
  physics->switching().retractRequest(body);
  EXPECT_TRUE(physics->switching().levelEvents().empty());
  physics->step(kStep);
  ASSERT_EQ(physics->switching().levelEvents().size(), 2U);
  EXPECT_EQ(physics->switching().levelEvents()[0].kind, LevelEventKind::kRequested);
  EXPECT_EQ(physics->switching().levelEvents()[0].scope, Scope::kGlobal);
  EXPECT_EQ(physics->switching().levelEvents()[1].kind, LevelEventKind::kRetracted);
  EXPECT_EQ(physics->counters().retractions, 1U);
  EXPECT_EQ(physics->counters().requests, 0U);
  EXPECT_EQ(physics->switching().level(body), 2);
  physics->step(kStep);
  EXPECT_TRUE(physics->switching().levelEvents().empty());
}

TEST(BulletWorld, RequestOfADestroyedBodyIsRetracted) {
  auto physics = makeWorld(WorldKind::kHybrid);
  const BodyId body = createIn(*physics, bodyAt({}, cubeLevels()));
  EXPECT_TRUE(physics->switching().requestLevel(body, 1, Scope::kLocal));
  physics->destroyBody(body);
  physics->step(kStep);
  ASSERT_EQ(physics->switching().levelEvents().size(), 2U);
  EXPECT_EQ(physics->switching().levelEvents()[1].kind, LevelEventKind::kRetracted);
  EXPECT_EQ(physics->switching().levelEvents()[1].body, body);
}

TEST(BulletShapes, BodiesOfALevelSetShareOneShape) {
  BulletShapeBuilder builder;
  const auto levels = cubeLevels();
  const auto first = builder.build(levels);
  const auto second = builder.build(levels);
  const auto other = builder.build(cubeLevels());
  ASSERT_TRUE(first && second && other);
  EXPECT_EQ(*first, *second);
  EXPECT_NE(*first, *other);
  EXPECT_EQ((*first)->levelCount(), 2);
}

TEST(BulletShapes, SinglePartInPlaceIsNotWrapped) {
  BulletShapeBuilder builder;
  const auto levels = builder.build(cubeLevels());
  ASSERT_TRUE(levels);
  EXPECT_TRUE((*levels)->levels().getLevelShape(1)->isConvex());
  EXPECT_TRUE((*levels)->levels().getLevelShape(2)->isCompound());
  const ConvexHull hull{{{1, 1, 1}, {3, 1, 1}, {1, 3, 1}, {1, 1, 3}}};
  const auto moved = builder.build(hull);
  ASSERT_TRUE(moved);
  EXPECT_TRUE((*moved)->finest()->isConvex());
  expectNear((*moved)->center().position, Vec3(1.5F), 1e-5F);
  const auto wrapped = builder.build(Compound{{{Box{}, {Vec3(0.0F), turn(0.5F, {1, 1, 1})}}}});
  ASSERT_TRUE(wrapped);
}

}  // namespace scatter::test
