#include <gtest/gtest.h>
#include <scatter/bullet/bullet_physics.h>

#include <glm/geometric.hpp>

#include "bullet/physics/swarm.h"

namespace scatter::test {
namespace {

PhysicsDef gravityWorld(WorldKind kind) {
  PhysicsDef def = worldOf(kind);
  def.gravity = kEarth;
  return def;
}

TEST(Freezing, KeepsABodyInPlaceAndOthersCollideWithIt) {
  for (const WorldKind kind : {WorldKind::kStandard, WorldKind::kHybrid}) {
    const auto physics = makeBulletPhysics(gravityWorld(kind));
    BodyDef def = bodyAt({0.0F, 3.0F, 0.0F}, cubeLevels());
    def.linearVelocity = {4.0F, 0.0F, 0.0F};
    def.angularVelocity = {0.0F, 2.0F, 0.0F};
    const BodyId frozen = create(*physics, def);
    const BodyId falling = create(*physics, bodyAt({0.05F, 4.5F, 0.05F}));
    stepBy(*physics, 3);
    ASSERT_TRUE(physics->setFrozen(frozen, true));
    const Vec3 place = physics->state(frozen).pose.position;
    physics->setPose(falling, {place + Vec3(0.0F, 1.5F, 0.0F), kNoRotation});
    stepBy(*physics, 60);
    physics->applyImpulse(frozen, {50.0F, 0.0F, 0.0F}, place);
    physics->setVelocity(frozen, {0.0F, 9.0F, 0.0F}, {});
    physics->applyForce(frozen, {500.0F, 0.0F, 0.0F}, place);
    physics->applyTorque(frozen, {0.0F, 500.0F, 0.0F});
    physics->activate(frozen);
    stepBy(*physics, 60);
    EXPECT_EQ(physics->state(frozen).pose.position, place);
    EXPECT_EQ(physics->state(frozen).linearVelocity, Vec3(0.0F));
    EXPECT_FALSE(physics->state(frozen).asleep);
    EXPECT_NEAR(physics->state(falling).pose.position.y, place.y + 1.0F, 0.02F)
        << "it lies on the frozen one";
    EXPECT_LT(glm::length(physics->state(falling).linearVelocity), 0.05F);
    Observation seen;
    physics->diagnostics().observe({}, seen);
    EXPECT_TRUE(seen.bodies[0].frozen);
    EXPECT_EQ(seen.bodies[0].island, -1);
    EXPECT_FALSE(seen.bodies[1].frozen);
  }
}

TEST(Freezing, EndsAtRestWithMassAndGravity) {
  const auto physics = makeBulletPhysics(gravityWorld(WorldKind::kHybrid));
  BodyDef def = bodyAt({0.0F, 30.0F, 0.0F}, cubeLevels());
  def.linearVelocity = {4.0F, 0.0F, 0.0F};
  def.angularVelocity = {0.0F, 2.0F, 0.0F};
  const BodyId body = create(*physics, def);
  ASSERT_TRUE(physics->setFrozen(body, true));
  EXPECT_EQ(physics->kineticEnergy(), 0.0);
  stepBy(*physics, 10);
  physics->setGravity({0.0F, -5.0F, 0.0F});
  ASSERT_TRUE(physics->setFrozen(body, false));
  EXPECT_EQ(physics->state(body).angularVelocity, Vec3(0.0F));
  stepBy(*physics, 60);
  expectNear(physics->state(body).linearVelocity, {0.0F, -5.0F, 0.0F}, 0.01F);
  // 2 kg: 4 newton seconds are 2 m/s.
  physics->applyImpulse(body, {4.0F, 0.0F, 0.0F}, physics->state(body).centerOfMass);
  EXPECT_NEAR(physics->state(body).linearVelocity.x, 2.0F, 1e-3F);
  // A cube of 1 m: a moment of 2/6 kg m².
  physics->setVelocity(body, {}, {0.0F, 3.0F, 0.0F});
  EXPECT_NEAR(physics->kineticEnergy(), 0.5 * 2.0 / 6.0 * 9.0, 1e-3);
}

TEST(Freezing, LeavesARunThatThawsAtOnceAsItWouldBeFromRest) {
  const auto frozen = makeBulletPhysics(gravityWorld(WorldKind::kStandard));
  const auto stopped = makeBulletPhysics(gravityWorld(WorldKind::kStandard));
  BodyDef def = bodyAt({0.0F, 3.0F, 0.0F});
  def.linearVelocity = {1.0F, 0.0F, 0.0F};
  for (Physics* physics : {frozen.get(), stopped.get()}) {
    createGround(*physics);
    const BodyId body = create(*physics, def);
    stepBy(*physics, 5);
    if (physics == frozen.get()) {
      EXPECT_TRUE(physics->setFrozen(body, true));
      EXPECT_TRUE(physics->setFrozen(body, false));
    } else {
      physics->setVelocity(body, {}, {});
    }
  }
  for (int i = 0; i < 120; ++i) {
    frozen->step(kStep);
    stopped->step(kStep);
    ASSERT_EQ(frozen->stateHash(), stopped->stateHash()) << "step " << i;
  }
}

TEST(Freezing, ThawedBodyRestsOnWhatItWasPutOn) {
  for (const WorldKind kind : {WorldKind::kStandard, WorldKind::kHybrid}) {
    const auto physics = makeBulletPhysics(gravityWorld(kind));
    BodyDef floor = bodyAt({20.0F, 0.0F, 0.0F}, Box{{3.0F, 0.5F, 3.0F}});
    floor.motion = Motion::kStatic;
    create(*physics, floor);
    const BodyId body = create(*physics, bodyAt({0.0F, 9.0F, 0.0F}, cubeLevels()));
    physics->step(kStep);
    ASSERT_TRUE(physics->setFrozen(body, true));
    physics->setPose(body, {{20.0F, 1.0F, 0.0F}, kNoRotation});
    stepBy(*physics, 3);
    EXPECT_EQ(physics->counters().contacts, 0U) << "nothing that is still touches anything that is";
    ASSERT_TRUE(physics->setFrozen(body, false));
    stepBy(*physics, 60);
    EXPECT_NEAR(physics->state(body).pose.position.y, 1.0F, 0.02F);
  }
}

TEST(Freezing, ThawingWakesWhatLiesOnIt) {
  const auto physics = makeBulletPhysics(gravityWorld(WorldKind::kStandard));
  BodyDef def = bodyAt({0.0F, 5.0F, 0.0F});
  def.mayRest = true;
  const BodyId lower = create(*physics, def);
  ASSERT_TRUE(physics->setFrozen(lower, true));
  def.pose.position.y = 6.0F;
  const BodyId upper = create(*physics, def);
  stepBy(*physics, 300);
  ASSERT_TRUE(physics->state(upper).asleep);
  ASSERT_TRUE(physics->setFrozen(lower, false));
  EXPECT_FALSE(physics->state(upper).asleep);
  stepBy(*physics, 30);
  EXPECT_LT(physics->state(upper).pose.position.y, 5.5F);
}

TEST(Freezing, IsForDynamicBodies) {
  const auto physics = makeBulletPhysics(gravityWorld(WorldKind::kStandard));
  EXPECT_FALSE(physics->setFrozen(createGround(*physics), true));
  BodyDef lift = bodyAt({0.0F, 3.0F, 0.0F});
  lift.motion = Motion::kKinematic;
  EXPECT_FALSE(physics->setFrozen(create(*physics, lift), true));
}

TEST(Freezing, OfAChassisParksItsVehicle) {
  const auto physics = makeBulletPhysics(gravityWorld(WorldKind::kStandard));
  createGround(*physics);
  const BodyId chassis = create(*physics, bodyAt({0.0F, 1.0F, 0.0F}, Box{{0.5F, 0.2F, 1.0F}}));
  VehicleDef def;
  def.chassis = chassis;
  for (const float x : {-0.5F, 0.5F}) {
    for (const float z : {-0.8F, 0.8F}) {
      WheelDef wheel;
      wheel.connection = {x, -0.1F, z};
      def.wheels.push_back(wheel);
    }
  }
  const auto vehicle = physics->createVehicle(def);
  ASSERT_TRUE(vehicle) << vehicle.error().message;
  stepBy(*physics, 60);
  ASSERT_TRUE(physics->setFrozen(chassis, true));
  const Vec3 place = physics->state(chassis).pose.position;
  physics->control(*vehicle, {.engineForce = 20.0F});
  stepBy(*physics, 30);
  EXPECT_EQ(physics->state(chassis).pose.position, place);
  ASSERT_TRUE(physics->setFrozen(chassis, false));
  stepBy(*physics, 60);
  EXPECT_FALSE(physics->findInvalidState());
}

TEST(Freezing, LeavesHybridsInTheirPileAlone) {
  for (const PhysicsDef& def :
       {worldOf(WorldKind::kHybrid), worldOf(WorldKind::kHybrid, Switching::kBody, Policy::kProximity)}) {
    Swarm swarm(def);
    swarm.step(160);
    const BodyId body = swarm.bodies()[12];
    const Vec3 place = swarm.physics().state(body).pose.position;
    ASSERT_TRUE(swarm.physics().setFrozen(body, true));
    static_cast<void>(swarm.squeeze());
    swarm.step(60);
    EXPECT_EQ(swarm.physics().state(body).pose.position, place);
    ASSERT_TRUE(swarm.physics().setFrozen(body, false));
    swarm.step(60);
    EXPECT_FALSE(swarm.physics().findInvalidState());
    EXPECT_NE(swarm.physics().state(body).pose.position, place);
  }
}

}  // namespace
}  // namespace scatter::test
