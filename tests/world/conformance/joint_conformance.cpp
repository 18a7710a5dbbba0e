#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "world/conformance/physics_conformance.h"

namespace scatter::test {

namespace {

BodyDef anchor() {
  BodyDef def = bodyAt(Vec3(0.0F), Box{Vec3(0.1F)});
  def.name = "anchor";
  def.motion = Motion::kStatic;
  return def;
}

JointDef joint(JointKind kind, BodyId a, BodyId b, const Transform& frame) {
  JointDef def;
  def.kind = kind;
  def.bodyA = a;
  def.bodyB = b;
  def.frame = frame;
  return def;
}

/// Of the rotation from `from` to `to`, about `axis`, radians.
float angleAbout(const Quat& from, const Quat& to, const Vec3& axis) {
  const Quat turned = to * glm::conjugate(from);
  const float along = glm::dot(Vec3(turned.x, turned.y, turned.z), axis);
  return 2.0F * std::atan2(along, turned.w);
}

}  // namespace

TEST_P(PhysicsConformance, PointJointKeepsThePoint) {
  startWithGravity(kEarth);
  const BodyId a = add(anchor());
  const BodyId b = add(bodyAt({1.0F, 0.0F, 0.0F}, Box{Vec3(0.2F)}));
  join(joint(PointJoint{}, a, b, {}));
  float lowest = 0.0F;
  for (int i = 0; i < 120; ++i) {
    step();
    const Transform pose = physics().state(b).pose;
    EXPECT_LT(glm::length(pose(Vec3(-1.0F, 0.0F, 0.0F))), 0.04F);
    lowest = std::min(lowest, pose.position.y);
  }
  EXPECT_NEAR(lowest, -1.0F, 0.05F);  // It swings through.
}

TEST_P(PhysicsConformance, HingeTurnsAboutItsAxisOnly) {
  startWithGravity({3.0F, -10.0F, 5.0F});
  const BodyId a = add(anchor());
  const BodyId b = add(bodyAt({1.0F, 0.0F, 0.0F}, Box{{0.5F, 0.1F, 0.3F}}));
  join(joint(HingeJoint{}, a, b, {Vec3(0.0F), kNoRotation}));
  float furthest = 0.0F;
  for (int i = 0; i < 120; ++i) {
    step();
    const Transform pose = physics().state(b).pose;
    expectNear(pose.rotation * Vec3(0.0F, 0.0F, 1.0F), {0.0F, 0.0F, 1.0F}, 0.02F);
    EXPECT_NEAR(glm::length(pose.position), 1.0F, 0.02F);
    furthest = std::max(furthest, std::abs(angleAbout(kNoRotation, pose.rotation, {0.0F, 0.0F, 1.0F})));
  }
  EXPECT_GT(furthest, 1.0F);
}

TEST_P(PhysicsConformance, HingeStopsAtItsLimits) {
  for (const float torque : {4.0F, -4.0F}) {
    SCOPED_TRACE(torque);
    startWithGravity(Vec3(0.0F));
    const BodyId a = add(anchor());
    const BodyId b = add(bodyAt({1.0F, 0.0F, 0.0F}, Box{{0.5F, 0.1F, 0.3F}}));
    // The joint's z axis is the world's y.
    const Quat frame = turn(-glm::half_pi<float>(), {1.0F, 0.0F, 0.0F});
    join(joint(HingeJoint{-0.3F, 0.6F}, a, b, {Vec3(0.0F), frame}));
    for (int i = 0; i < 120; ++i) {
      physics().applyTorque(b, {0.0F, torque, 0.0F});
      step();
    }
    const float angle = angleAbout(kNoRotation, physics().state(b).pose.rotation, {0.0F, 1.0F, 0.0F});
    EXPECT_NEAR(angle, torque > 0.0F ? 0.6F : -0.3F, 0.03F);
  }
}

TEST_P(PhysicsConformance, SliderMovesAlongItsAxisWithinItsLimits) {
  for (const float force : {20.0F, -20.0F}) {
    SCOPED_TRACE(force);
    startWithGravity(kEarth);
    const BodyId a = add(anchor());
    const BodyId b = add(bodyAt({0.0F, 0.0F, 2.0F}, Box{Vec3(0.2F)}));
    // The joint's x axis is the world's z.
    const Quat frame = turn(-glm::half_pi<float>(), {0.0F, 1.0F, 0.0F});
    join(joint(SliderJoint{-0.5F, 1.0F}, a, b, {{0.0F, 0.0F, 2.0F}, frame}));
    for (int i = 0; i < 120; ++i) {
      physics().applyCentralForce(b, {0.0F, 0.0F, force});
      step();
      const Transform pose = physics().state(b).pose;
      EXPECT_NEAR(pose.position.x, 0.0F, 0.02F);
      EXPECT_NEAR(pose.position.y, 0.0F, 0.02F);
      EXPECT_GT(std::abs(pose.rotation.w), 0.999F);
    }
    EXPECT_NEAR(physics().state(b).pose.position.z, force > 0.0F ? 3.0F : 1.5F, 0.03F);
  }
}

TEST_P(PhysicsConformance, FixedJointKeepsTheRelativePose) {
  startWithGravity(kEarth);
  BodyDef first = bodyAt({0.0F, 5.0F, 0.0F}, Box{{0.2F, 0.3F, 0.4F}});
  first.angularVelocity = {1.0F, -2.0F, 0.5F};
  BodyDef second = bodyAt({1.0F, 5.0F, 0.0F}, Sphere{0.2F});
  second.pose.rotation = turn(0.5F, {1, 1, 0});
  const BodyId a = add(first);
  const BodyId b = add(second);
  join(joint(FixedJoint{}, a, b, {{0.5F, 5.0F, 0.0F}, kNoRotation}));
  const Transform before = first.pose.inverse() * second.pose;
  for (int i = 0; i < 60; ++i) {
    step();
    const Transform now = physics().state(a).pose.inverse() * physics().state(b).pose;
    expectNear(now.position, before.position, 0.03F);
    EXPECT_GT(std::abs(glm::dot(now.rotation, before.rotation)), 0.999F);
  }
}

TEST_P(PhysicsConformance, SixDofJointLocksLimitsAndFrees) {
  for (const float sign : {1.0F, -1.0F}) {
    SCOPED_TRACE(sign);
    startWithGravity(Vec3(0.0F));
    const BodyId a = add(anchor());
    const BodyId b = add(bodyAt({1.0F, 0.0F, 0.0F}, Box{Vec3(0.2F)}));
    SixDofJoint kind;
    kind.linearLower = {0.0F, -0.5F, 1.0F};  // x locked, y limited, z free
    kind.linearUpper = {0.0F, 1.0F, -1.0F};
    join(joint(kind, a, b, {{1.0F, 0.0F, 0.0F}, kNoRotation}));
    for (int i = 0; i < 60; ++i) {
      physics().applyCentralForce(b, sign * Vec3(10.0F, 10.0F, 4.0F));
      step();
    }
    const BodyState state = physics().state(b);
    EXPECT_NEAR(state.pose.position.x, 1.0F, 0.03F);
    EXPECT_NEAR(state.pose.position.y, sign > 0.0F ? 1.0F : -0.5F, 0.03F);
    EXPECT_NEAR(state.pose.position.z, sign * 1.0F, 0.05F);  // a t^2 / 2 after 1 s
    EXPECT_GT(std::abs(state.pose.rotation.w), 0.999F);
  }
}

TEST_P(PhysicsConformance, SixDofJointLimitsEachAngle) {
  const Vec3 axes[]{{1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, {0.0F, 0.0F, 1.0F}};
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {1.0F, -1.0F}) {
      SCOPED_TRACE(testing::Message() << axis << " " << sign);
      startWithGravity(Vec3(0.0F));
      const BodyId a = add(anchor());
      const BodyId b = add(bodyAt({1.0F, 0.0F, 0.0F}, Box{Vec3(0.3F)}));
      SixDofJoint kind;
      kind.angularLower[axis] = -0.25F;
      kind.angularUpper[axis] = 0.5F;
      join(joint(kind, a, b, {{1.0F, 0.0F, 0.0F}, kNoRotation}));
      for (int i = 0; i < 120; ++i) {
        physics().applyTorque(b, sign * 0.5F * axes[axis]);
        step();
      }
      const float angle = angleAbout(kNoRotation, physics().state(b).pose.rotation, axes[axis]);
      EXPECT_NEAR(angle, sign > 0.0F ? 0.5F : -0.25F, 0.03F);
    }
  }
}

TEST_P(PhysicsConformance, JoinedBodiesCollideOnlyIfAskedTo) {
  for (const bool collide : {false, true}) {
    SCOPED_TRACE(collide);
    startWithGravity(Vec3(0.0F));
    const BodyId a = add(bodyAt(Vec3(0.0F), Sphere{0.5F}));
    const BodyId b = add(bodyAt({0.9F, 0.0F, 0.0F}, Sphere{0.5F}));
    step();  // They touch before they are joined.
    SixDofJoint free;
    free.linearLower = free.angularLower = Vec3(1.0F);
    free.linearUpper = free.angularUpper = Vec3(-1.0F);
    JointDef def = joint(free, a, b, {});
    def.bodiesCollide = collide;
    join(def);
    physics().setPose(b, {{0.9F, 0.0F, 0.0F}, kNoRotation});
    physics().setVelocity(a, Vec3(0.0F), Vec3(0.0F));
    physics().setVelocity(b, Vec3(0.0F), Vec3(0.0F));
    step(20);
    EXPECT_EQ(physics().counters().contacts > 0U || physics().state(b).pose.position.x > 0.95F, collide);
  }
}

TEST_P(PhysicsConformance, DestroyedJointLetsGo) {
  startWithGravity(kEarth);
  const BodyId a = add(anchor());
  BodyDef hanging = bodyAt({0.0F, -1.0F, 0.0F}, Box{Vec3(0.2F)});
  hanging.mayRest = true;
  const BodyId b = add(hanging);
  const JointId rope = join(joint(PointJoint{}, a, b, {}));
  step(300);
  ASSERT_TRUE(physics().state(b).asleep);
  physics().destroyJoint(rope);
  step(60);
  EXPECT_LT(physics().state(b).pose.position.y, -5.0F);
}

TEST_P(PhysicsConformance, DestroyingABodyTakesItsJointsAndVehiclesAndWakesItsNeighbours) {
  startWithGravity(kEarth);
  addGround();
  BodyDef lower = bodyAt({0.0F, 0.5F, 0.0F});
  BodyDef upper = bodyAt({0.0F, 1.5F, 0.0F});
  lower.mayRest = upper.mayRest = true;
  const BodyId bottom = add(lower);
  const BodyId top = add(upper);
  const BodyId ball = add(bodyAt({0.0F, 0.5F, 3.0F}, Sphere{0.5F}));
  join(joint(PointJoint{}, bottom, ball, {{0.0F, 0.5F, 2.0F}, kNoRotation}));
  VehicleDef vehicle;
  vehicle.chassis = bottom;
  vehicle.wheels.push_back({});
  ASSERT_TRUE(physics().createVehicle(vehicle));
  step(30);
  physics().destroyBody(bottom);
  step(120);
  EXPECT_NEAR(physics().state(top).pose.position.y, 0.5F, 0.02F);
  EXPECT_EQ(physics().counters().objects, 3U);

  // What falls asleep on a body does not hang in the air without it.
  startWithGravity(kEarth);
  addGround();
  const BodyId first = add(lower);
  const BodyId second = add(upper);
  step(400);
  ASSERT_TRUE(physics().state(second).asleep);
  physics().destroyBody(first);
  step(120);
  EXPECT_NEAR(physics().state(second).pose.position.y, 0.5F, 0.02F);
}

namespace {

VehicleDef carOn(BodyId chassis) {
  VehicleDef car;
  car.chassis = chassis;
  for (const float z : {-1.2F, 1.2F}) {
    for (const float x : {-0.8F, 0.8F}) {
      WheelDef wheel;
      wheel.connection = {x, -0.2F, z};
      wheel.steered = z > 0.0F;
      wheel.driven = z < 0.0F;
      car.wheels.push_back(wheel);
    }
  }
  return car;
}

}  // namespace

TEST_P(PhysicsConformance, VehicleDrivesForwardSteersAndBrakes) {
  startWithGravity(kEarth);
  addGround();
  // A chassis whose centre of mass is not its model's origin, with a plate between its wheels' rays and the
  // ground.
  Compound shape;
  shape.parts.push_back({Box{{0.9F, 0.25F, 1.8F}}, {}});
  shape.parts.push_back({Box{{0.7F, 0.4F, 0.6F}}, {{0.0F, 0.6F, -0.5F}, kNoRotation}});
  shape.parts.push_back({Box{{0.9F, 0.02F, 1.8F}}, {{0.0F, -0.45F, 0.0F}, kNoRotation}});
  BodyDef def = bodyAt({0.0F, 1.0F, 0.0F}, shape);
  def.mass = 800.0F;
  const BodyId chassis = add(def);
  const auto car = physics().createVehicle(carOn(chassis));
  ASSERT_TRUE(car);
  step(120);
  const Vec3 parked = physics().state(chassis).pose.position;
  EXPECT_NEAR(parked.x, 0.0F, 0.05F);
  // Springs carry the weight when 4 * stiffness * x = g: x = 0.125. The hard points are then 0.3 + 0.4 - x
  // above the ground, and 0.2 below the origin.
  EXPECT_NEAR(parked.y, 0.775F, 0.02F);

  physics().control(*car, {1000.0F, 0.0F, 0.0F});
  step(120);
  const Vec3 driven = physics().state(chassis).pose.position;
  EXPECT_GT(driven.z - parked.z, 3.0F);
  EXPECT_LT(std::abs(driven.x), 0.5F);

  physics().control(*car, {0.0F, 0.0F, 0.4F});
  step(60);
  EXPECT_GT(physics().state(chassis).pose.position.x, driven.x + 0.1F);

  physics().control(*car, {0.0F, 100.0F, 0.0F});
  step(180);
  EXPECT_LT(glm::length(physics().state(chassis).linearVelocity), 0.2F);
  physics().destroyVehicle(*car);
  step(60);
  EXPECT_LT(physics().state(chassis).pose.position.y, 0.6F);
}

}  // namespace scatter::test
