#include "world/conformance/physics_conformance.h"

#include <glm/geometric.hpp>

namespace scatter::test {

void PhysicsConformance::start(PhysicsDef def) {
  def.world = GetParam().world;
  physics_ = GetParam().make(def);
}

void PhysicsConformance::startWithGravity(const Vec3& gravity) {
  PhysicsDef def;
  def.gravity = gravity;
  start(def);
}

BodyId PhysicsConformance::add(const BodyDef& def) {
  const Result<BodyId> body = physics_->createBody(def);
  EXPECT_TRUE(body) << body.error().message;
  return body.value();
}

JointId PhysicsConformance::join(const JointDef& def) {
  const Result<JointId> joint = physics_->createJoint(def);
  EXPECT_TRUE(joint) << joint.error().message;
  return joint.value();
}

BodyId PhysicsConformance::addGround(const Material& material) {
  BodyDef ground;
  ground.name = "ground";
  ground.shape = Plane{};
  ground.motion = Motion::kStatic;
  ground.material = material;
  return add(ground);
}

void PhysicsConformance::step(int count) {
  for (int i = 0; i < count; ++i) physics_->step(kStep);
}

BodyDef bodyAt(const Vec3& position, Shape shape) {
  BodyDef def;
  def.name = "body";
  def.shape = std::move(shape);
  def.mass = 2.0F;
  def.pose.position = position;
  def.mayRest = false;
  return def;
}

std::shared_ptr<const LevelSet> cubeLevels() {
  const Box half{{0.25F, 0.5F, 0.5F}};
  LevelSetDef def;
  def.name = "cube";
  def.levels.push_back({{{Box{Vec3(0.55F)}, {}}}});
  def.levels.push_back(
      {{{half, {{-0.25F, 0.0F, 0.0F}, kNoRotation}}, {half, {{0.25F, 0.0F, 0.0F}, kNoRotation}}}});
  auto levels = LevelSet::create(std::move(def));
  EXPECT_TRUE(levels) << levels.error().message;
  return levels.value();
}

Quat turn(float angle, const Vec3& axis) {
  return glm::angleAxis(angle, glm::normalize(axis));
}

void expectNear(const Vec3& actual, const Vec3& expected, float tolerance) {
  EXPECT_NEAR(actual.x, expected.x, tolerance);
  EXPECT_NEAR(actual.y, expected.y, tolerance);
  EXPECT_NEAR(actual.z, expected.z, tolerance);
}

}  // namespace scatter::test
