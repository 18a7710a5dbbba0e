#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/matrix.hpp>
#include <memory>

#include "world/conformance/physics_conformance.h"

namespace scatter::test {

TEST_P(PhysicsConformance, ImpulseAtCenterChangesVelocityByItsShare) {
  startWithGravity(Vec3(0.0F));
  const BodyId body = add(bodyAt({1.0F, 2.0F, 3.0F}));
  physics().applyImpulse(body, {6.0F, -4.0F, 2.0F}, {1.0F, 2.0F, 3.0F});
  expectNear(physics().state(body).linearVelocity, {3.0F, -2.0F, 1.0F}, 1e-5F);  // J / 2 kg
  expectNear(physics().state(body).angularVelocity, Vec3(0.0F), 1e-5F);
}

TEST_P(PhysicsConformance, ImpulseOffCenterTurns) {
  startWithGravity(Vec3(0.0F));
  const BodyId body = add(bodyAt(Vec3(0.0F), Box{{0.5F, 1.0F, 1.5F}}));
  physics().applyImpulse(body, {0.0F, 2.0F, 0.0F}, {0.5F, 0.0F, 0.0F});
  // I_z = 2/12 (1 + 4) = 5/6; r x J = (0, 0, 1).
  expectNear(physics().state(body).angularVelocity, {0.0F, 0.0F, 1.2F}, 1e-4F);
}

TEST_P(PhysicsConformance, ForceLastsOneStep) {
  startWithGravity(Vec3(0.0F));
  const BodyId body = add(bodyAt(Vec3(0.0F)));
  physics().applyCentralForce(body, {120.0F, 0.0F, 0.0F});
  step();
  expectNear(physics().state(body).linearVelocity, {1.0F, 0.0F, 0.0F}, 1e-4F);  // F dt / m
  step();
  expectNear(physics().state(body).linearVelocity, {1.0F, 0.0F, 0.0F}, 1e-4F);
}

TEST_P(PhysicsConformance, ForceAtPointTurns) {
  startWithGravity(Vec3(0.0F));
  const BodyId body = add(bodyAt({5.0F, 0.0F, 0.0F}, Sphere{0.5F}));
  physics().applyForce(body, {0.0F, 12.0F, 0.0F}, {5.5F, 0.0F, 0.0F});
  step();
  expectNear(physics().state(body).linearVelocity, {0.0F, 0.1F, 0.0F}, 1e-4F);
  // I = 2/5 m r^2 = 0.2; torque 6 N m for 1/60 s.
  expectNear(physics().state(body).angularVelocity, {0.0F, 0.0F, 0.5F}, 1e-3F);
}

TEST_P(PhysicsConformance, TorqueTurnsByTheInertia) {
  startWithGravity(Vec3(0.0F));
  const BodyId body = add(bodyAt(Vec3(0.0F), Cylinder{0.5F, 1.0F}));
  physics().applyTorque(body, {0.0F, 15.0F, 0.0F});
  step();
  // I_y = m r^2 / 2 = 0.25.
  expectNear(physics().state(body).angularVelocity, {0.0F, 1.0F, 0.0F}, 1e-3F);
  expectNear(physics().state(body).linearVelocity, Vec3(0.0F), 1e-5F);
}

TEST_P(PhysicsConformance, GravityAcceleratesAllMassesAlike) {
  startWithGravity(kEarth);
  BodyDef heavy = bodyAt({5.0F, 0.0F, 0.0F});
  heavy.mass = 500.0F;
  const BodyId bodies[]{add(bodyAt(Vec3(0.0F))), add(heavy)};
  step(60);
  for (const BodyId body : bodies) {
    expectNear(physics().state(body).linearVelocity, {0.0F, -10.0F, 0.0F}, 1e-3F);
    EXPECT_NEAR(physics().state(body).pose.position.y, -5.0F, 0.1F);
  }
}

TEST_P(PhysicsConformance, PoseAndVelocityAreThoseOfTheDefinition) {
  startWithGravity(Vec3(0.0F));
  Compound lopsided;
  lopsided.parts.push_back({Box{{0.5F, 0.5F, 0.5F}}, {{2.0F, 0.0F, 0.0F}, turn(0.3F, {1, 2, 3})}});
  lopsided.parts.push_back({Sphere{0.5F}, {{2.0F, 3.0F, 1.0F}, kNoRotation}});
  BodyDef def = bodyAt({4.0F, 5.0F, 6.0F}, lopsided);
  def.pose.rotation = turn(0.7F, {1, -1, 0.5F});
  def.linearVelocity = {1.0F, 2.0F, 3.0F};
  def.angularVelocity = {-1.0F, 0.5F, 0.25F};
  const BodyId body = add(def);
  const auto expectDefined = [&](const Transform& pose) {
    const BodyState state = physics().state(body);
    expectNear(state.pose.position, pose.position, 1e-5F);
    EXPECT_NEAR(std::abs(glm::dot(state.pose.rotation, pose.rotation)), 1.0F, 1e-5F);
    expectNear(state.linearVelocity, def.linearVelocity, 1e-6F);
    expectNear(state.angularVelocity, def.angularVelocity, 1e-6F);
  };
  expectDefined(def.pose);
  const Transform elsewhere{{-3.0F, 0.0F, 2.0F}, turn(2.0F, {0, 1, 1})};
  physics().setPose(body, elsewhere);
  expectDefined(elsewhere);
}

namespace {

/// Two boxes of equal volume that touch: one along x from the origin, one along y from there.
Compound thinLetterL() {
  Compound shape;
  shape.parts.push_back({Box{{1.0F, 0.1F, 0.1F}}, {{1.0F, -0.05F, 0.0F}, kNoRotation}});
  shape.parts.push_back({Box{{0.1F, 1.0F, 0.1F}}, {{0.0F, 1.05F, 0.0F}, kNoRotation}});
  return shape;
}

/// Per kilogram, about its centre of mass (0.5, 0.5, 0), by the parallel axis theorem.
Mat3 letterLInertia() {
  const float along = (0.2F * 0.2F + 0.2F * 0.2F) / 12.0F;
  const float across = (2.0F * 2.0F + 0.2F * 0.2F) / 12.0F;
  // Half a kilogram each, at (0.5, -0.55, 0) and (-0.5, 0.55, 0) from the centre.
  const float moment = 0.5F * (along + across);
  Mat3 inertia(0.0F);
  inertia[0][0] = moment + 0.55F * 0.55F;
  inertia[1][1] = moment + 0.5F * 0.5F;
  inertia[2][2] = across + 0.55F * 0.55F + 0.5F * 0.5F;
  inertia[0][1] = inertia[1][0] = 0.5F * 0.55F;  // -sum of m x y
  return inertia;
}

}  // namespace

TEST_P(PhysicsConformance, CenterOfMassMovesOnAStraightLine) {
  startWithGravity(Vec3(0.0F));
  BodyDef def = bodyAt({1.0F, 2.0F, 3.0F}, thinLetterL());
  def.linearVelocity = {1.0F, 0.5F, 0.0F};
  def.angularVelocity = {1.0F, 2.0F, 3.0F};
  const BodyId body = add(def);
  const Vec3 start{1.5F, 2.5F, 3.0F};
  expectNear(physics().state(body).centerOfMass, start, 1e-5F);
  float furthest = 0.0F;
  for (int i = 1; i <= 120; ++i) {
    step();
    const BodyState state = physics().state(body);
    const Vec3 expected = start + def.linearVelocity * (static_cast<float>(i) * kStep);
    expectNear(state.centerOfMass, expected, 1e-3F);
    expectNear(state.pose(Vec3(0.5F, 0.5F, 0.0F)), state.centerOfMass, 1e-4F);
    const Vec3 origin = def.pose.position + def.linearVelocity * (static_cast<float>(i) * kStep);
    furthest = std::max(furthest, glm::length(state.pose.position - origin));
  }
  // The model's origin does not: it circles the centre.
  EXPECT_GT(furthest, 1.0F);
}

TEST_P(PhysicsConformance, ProductsOfInertiaCount) {
  startWithGravity(Vec3(0.0F));
  BodyDef def = bodyAt(Vec3(0.0F), thinLetterL());
  def.mass = 2.0F;
  const BodyId body = add(def);
  const Vec3 torque{3.0F, 0.0F, 0.0F};
  physics().applyTorque(body, torque);
  step();
  const Vec3 expected = glm::inverse(2.0F * letterLInertia()) * torque * kStep;
  EXPECT_GT(std::abs(expected.y), 0.01F);
  expectNear(physics().state(body).angularVelocity, expected, 2e-3F);
}

TEST_P(PhysicsConformance, KineticEnergyOfMovingAndTurningBodies) {
  startWithGravity(Vec3(0.0F));
  EXPECT_EQ(physics().kineticEnergy(), 0.0);
  BodyDef ball = bodyAt(Vec3(0.0F), Sphere{0.5F});
  ball.linearVelocity = {3.0F, 4.0F, 0.0F};
  ball.angularVelocity = {0.0F, 2.0F, 0.0F};
  add(ball);
  EXPECT_NEAR(physics().kineticEnergy(), 25.0 + 0.4, 1e-4);  // m v^2 / 2 + (2/5 m r^2) w^2 / 2

  BodyDef letter = bodyAt({5.0F, 0.0F, 0.0F}, thinLetterL());
  letter.pose.rotation = turn(1.0F, {1, 2, 3});
  letter.angularVelocity = letter.pose.rotation * Vec3(1.0F, 2.0F, 3.0F);
  add(letter);
  const Vec3 spin(1.0F, 2.0F, 3.0F);
  const float turning = 0.5F * 2.0F * glm::dot(spin, letterLInertia() * spin);
  EXPECT_NEAR(physics().kineticEnergy(), 25.4 + static_cast<double>(turning), 1e-3);
}

TEST_P(PhysicsConformance, KinematicBodyPushesAndIsNotPushed) {
  startWithGravity(Vec3(0.0F));
  BodyDef pusher = bodyAt(Vec3(0.0F));
  pusher.motion = Motion::kKinematic;
  const BodyId hand = add(pusher);
  const BodyId ball = add(bodyAt({1.1F, 0.0F, 0.0F}, Sphere{0.5F}));
  for (int i = 1; i <= 60; ++i) {
    // Only where it is when the step begins counts.
    physics().setPose(hand, {{-30.0F, 0.0F, 0.0F}, kNoRotation});
    physics().setPose(hand, {{static_cast<float>(i) * kStep, 0.0F, 0.0F}, kNoRotation});
    step();
  }
  EXPECT_NEAR(physics().state(hand).pose.position.x, 1.0F, 1e-5F);
  EXPECT_GE(physics().state(ball).pose.position.x, 1.97F);
  EXPECT_NEAR(physics().state(ball).linearVelocity.x, 1.0F, 0.1F);
}

TEST_P(PhysicsConformance, StaticBodyNeverMoves) {
  startWithGravity(kEarth);
  BodyDef def = bodyAt(Vec3(0.0F));
  def.motion = Motion::kStatic;
  def.linearVelocity = {1.0F, 0.0F, 0.0F};
  const BodyId wall = add(def);
  physics().applyImpulse(wall, {100.0F, 0.0F, 0.0F}, Vec3(0.0F));
  physics().applyTorque(wall, {100.0F, 0.0F, 0.0F});
  physics().setVelocity(wall, {1.0F, 0.0F, 0.0F}, Vec3(0.0F));
  step(30);
  EXPECT_EQ(physics().state(wall).pose.position, Vec3(0.0F));
  EXPECT_EQ(physics().state(wall).linearVelocity, Vec3(0.0F));
}

TEST_P(PhysicsConformance, NamesTheBodyWhoseStateIsNotFinite) {
  startWithGravity(Vec3(0.0F));
  add(bodyAt(Vec3(0.0F)));
  const BodyId victim = add(bodyAt({10.0F, 0.0F, 0.0F}));
  step();
  EXPECT_EQ(physics().findInvalidState(), std::nullopt);
  physics().applyImpulse(victim, {3e38F, 0.0F, 0.0F}, {10.0F, 0.0F, 0.0F});
  physics().applyImpulse(victim, {3e38F, 0.0F, 0.0F}, {10.0F, 0.0F, 0.0F});
  physics().applyImpulse(victim, {3e38F, 0.0F, 0.0F}, {10.0F, 0.0F, 0.0F});
  EXPECT_EQ(physics().findInvalidState(), victim);
}

}  // namespace scatter::test
