#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include "world/conformance/physics_conformance.h"

namespace scatter::test {

namespace {

constexpr float kQuarter = glm::half_pi<float>();

ConvexHull cubeHull(float half) {
  ConvexHull hull;
  for (const float x : {-half, half}) {
    for (const float y : {-half, half}) {
      for (const float z : {-half, half}) hull.vertices.push_back({x, y, z});
    }
  }
  return hull;
}

std::shared_ptr<const TriangleMesh> squareMesh(float half) {
  auto mesh = std::make_shared<TriangleMesh>();
  mesh->vertices = {{-half, 0, -half}, {half, 0, -half}, {half, 0, half}, {-half, 0, half}};
  mesh->triangles = {{0, 2, 1}, {0, 3, 2}};
  return mesh;
}

/// Level, high above the origin of its model.
std::shared_ptr<const HeightField> squareField(float half, float height) {
  const HeightField field{.columns = 3,
                          .rows = 5,
                          .spacingX = half,
                          .spacingZ = 0.5F * half,
                          .heights = std::vector<float>(15, height)};
  return std::make_shared<const HeightField>(field);
}

/// An L in the plane z = 0: its foot lies along x, its model's origin is the corner.
Compound letterL() {
  Compound shape;
  shape.parts.push_back({Box{{1.0F, 0.25F, 0.5F}}, {{1.0F, 0.25F, 0.0F}, kNoRotation}});
  shape.parts.push_back({Box{{0.25F, 1.0F, 0.5F}}, {{0.25F, 1.5F, 0.0F}, kNoRotation}});
  return shape;
}

struct Rest {
  const char* name;
  Shape shape;
  Quat rotation;
  float height;  ///< Of the model's origin, at rest.
};

std::vector<Rest> rests() {
  const Quat lying = turn(kQuarter, {1, 0, 0});
  return {
      {"box", Box{{0.5F, 0.3F, 0.4F}}, kNoRotation, 0.3F},
      {"sphere", Sphere{0.7F}, kNoRotation, 0.7F},
      {"capsule lying", Capsule{0.3F, 0.6F}, lying, 0.3F},
      {"cylinder standing", Cylinder{0.5F, 0.4F}, kNoRotation, 0.4F},
      {"cylinder lying", Cylinder{0.5F, 0.4F}, lying, 0.5F},
      {"hull", cubeHull(0.5F), kNoRotation, 0.5F},
      {"L, whose origin is its corner", letterL(), kNoRotation, 0.0F},
  };
}

}  // namespace

TEST_P(PhysicsConformance, ShapesComeToRestAtTheirHeight) {
  for (const Rest& rest : rests()) {
    SCOPED_TRACE(rest.name);
    startWithGravity(kEarth);
    addGround();
    BodyDef def = bodyAt({0.0F, rest.height + 0.2F, 0.0F}, rest.shape);
    def.pose.rotation = rest.rotation;
    const BodyId body = add(def);
    step(180);
    // An engine may keep a margin of up to 2 cm around hulls.
    EXPECT_NEAR(physics().state(body).pose.position.y, rest.height, 0.03F);
    EXPECT_LT(glm::length(physics().state(body).linearVelocity), 0.05F);
    EXPECT_LT(physics().maxPenetration(), 0.02);
  }
}

TEST_P(PhysicsConformance, HybridRestsWhereItsFinestLevelDoes) {
  startWithGravity(kEarth);
  addGround();
  const BodyId body = add(bodyAt({0.0F, 0.8F, 0.0F}, cubeLevels()));
  step(180);
  EXPECT_NEAR(physics().state(body).pose.position.y, 0.5F, 0.02F);
}

TEST_P(PhysicsConformance, BoxRestsOnStaticShapes) {
  const std::vector<std::pair<const char*, Shape>> floors{{"mesh", squareMesh(5.0F)},
                                                          {"height field", squareField(5.0F, 0.0F)},
                                                          {"box", Box{{5.0F, 1e-3F, 5.0F}}},
                                                          {"plane", Plane{{0.0F, 2.0F, 0.0F}, 0.0F}}};
  for (const auto& [name, shape] : floors) {
    SCOPED_TRACE(name);
    startWithGravity(kEarth);
    BodyDef floor = bodyAt({0.0F, 3.0F, 0.0F}, shape);
    floor.motion = Motion::kStatic;
    add(floor);
    const BodyId box = add(bodyAt({0.3F, 3.7F, 0.2F}, Box{}));
    step(180);
    EXPECT_NEAR(physics().state(box).pose.position.y, 3.5F, 0.02F);
  }
}

TEST_P(PhysicsConformance, HeightFieldLiesAtItsHeights) {
  startWithGravity(kEarth);
  BodyDef floor = bodyAt({0.0F, 3.0F, 0.0F}, squareField(5.0F, 40.0F));
  floor.motion = Motion::kStatic;
  const BodyId ground = add(floor);
  EXPECT_EQ(physics().state(ground).pose.position, Vec3(0.0F, 3.0F, 0.0F));
  const BodyId ball = add(bodyAt({0.3F, 43.7F, 0.2F}, Sphere{0.5F}));
  step(180);
  EXPECT_NEAR(physics().state(ball).pose.position.y, 43.5F, 0.02F);
}

TEST_P(PhysicsConformance, HeightFieldIsTheSurfaceOfItsTriangles) {
  const HeightField field{
      .columns = 4,
      .rows = 3,
      .spacingX = 2.0F,
      .spacingZ = 1.5F,
      .heights = {0.0F, 1.0F, 0.3F, -2.0F, 1.2F, -0.4F, 0.9F, 0.1F, 2.0F, 0.5F, -1.0F, 3.0F}};
  const Transform pose{{5.0F, 2.0F, -1.0F}, turn(0.4F, {0, 1, 0})};
  const auto heightsOf = [&](const Shape& shape) {
    startWithGravity(Vec3(0.0F));
    BodyDef def = bodyAt(Vec3(0.0F), shape);
    def.motion = Motion::kStatic;
    def.pose = pose;
    add(def);
    std::vector<float> heights;
    for (int x = 0; x < 9; ++x) {
      for (int z = 0; z < 7; ++z) {
        const Vec3 at =
            pose(Vec3(-2.9F + 0.71F * static_cast<float>(x), 0.0F, -1.4F + 0.45F * static_cast<float>(z)));
        const auto hit = physics().castRay(at + Vec3(0.0F, 20.0F, 0.0F), at - Vec3(0.0F, 20.0F, 0.0F));
        EXPECT_TRUE(hit);
        heights.push_back(hit ? hit->point.y : -100.0F);
      }
    }
    return heights;
  };
  const auto fromField = heightsOf(std::make_shared<const HeightField>(field));
  const auto fromMesh = heightsOf(std::make_shared<const TriangleMesh>(trianglesOf(field)));
  for (std::size_t i = 0; i < fromField.size(); ++i) {
    EXPECT_NEAR(fromField[i], fromMesh[i], 1e-3F) << i;
  }
}

TEST_P(PhysicsConformance, PlaneLiesAtItsOffset) {
  startWithGravity(kEarth);
  BodyDef floor = bodyAt({0.0F, 0.0F, 0.0F}, Plane{{0.0F, 2.0F, 0.0F}, 3.0F});  // 2 y <= 3
  floor.motion = Motion::kStatic;
  add(floor);
  const BodyId ball = add(bodyAt({0.0F, 3.0F, 0.0F}, Sphere{0.5F}));
  step(180);
  EXPECT_NEAR(physics().state(ball).pose.position.y, 2.0F, 0.02F);
}

TEST_P(PhysicsConformance, BoxHoldsOrSlidesOnSlope) {
  const float slope = glm::radians(20.0F);  // Its tangent is 0.364.
  const Vec3 normal{std::sin(slope), std::cos(slope), 0.0F};
  const Vec3 down{std::cos(slope), -std::sin(slope), 0.0F};
  for (const float friction : {0.6F, 0.2F}) {
    SCOPED_TRACE(friction);
    startWithGravity(kEarth);
    BodyDef ground = bodyAt(Vec3(0.0F), Plane{normal, 0.0F});
    ground.motion = Motion::kStatic;
    ground.material.friction = 1.0F;
    add(ground);
    BodyDef def = bodyAt(0.25F * normal, Box{{0.5F, 0.25F, 0.5F}});
    def.pose.rotation = turn(-slope, {0, 0, 1});
    def.material.friction = friction;
    const BodyId box = add(def);
    step(60);
    // From rest, s = (g sin - mu g cos) t^2 / 2 after 1 s, if it slides at all.
    const float gravity = 10.0F;
    const float pull = gravity * (std::sin(slope) - friction * std::cos(slope));
    const float slid = glm::dot(physics().state(box).pose.position - def.pose.position, down);
    EXPECT_NEAR(slid, pull > 0.0F ? 0.5F * pull : 0.0F, 0.05F);
  }
}

TEST_P(PhysicsConformance, RestitutionGivesTheHeightOfTheBounce) {
  startWithGravity(kEarth);
  Material bouncy;
  bouncy.restitution = 1.0F;
  addGround(bouncy);
  BodyDef def = bodyAt({0.0F, 2.5F, 0.0F}, Sphere{0.5F});
  def.material.restitution = 0.5F;
  const BodyId ball = add(def);
  // It falls 2 m in 0.63 s and rises for half as long, to 0.25 * 2 m.
  step(39);
  float highest = 0.0F;
  for (int i = 0; i < 36; ++i) {
    step();
    highest = std::max(highest, physics().state(ball).pose.position.y - 0.5F);
  }
  EXPECT_NEAR(highest, 0.5F, 0.08F);
}

TEST_P(PhysicsConformance, DampingTakesItsSharePerSecond) {
  startWithGravity(Vec3(0.0F));
  BodyDef def = bodyAt(Vec3(0.0F));
  def.linearVelocity = {8.0F, 0.0F, 0.0F};
  def.material.linearDamping = 0.5F;
  const BodyId body = add(def);
  step(120);
  EXPECT_NEAR(physics().state(body).linearVelocity.x, 2.0F, 0.1F);
}

TEST_P(PhysicsConformance, RestingBodyFallsAsleepAndIsWoken) {
  startWithGravity(kEarth);
  addGround();
  BodyDef def = bodyAt({0.0F, 0.5F, 0.0F});
  def.mayRest = true;
  const BodyId box = add(def);
  step(300);
  ASSERT_TRUE(physics().state(box).asleep);
  const Vec3 before = physics().state(box).pose.position;

  physics().applyCentralForce(box, {500.0F, 0.0F, 0.0F}, /*wake=*/false);
  step();
  EXPECT_TRUE(physics().state(box).asleep);
  EXPECT_EQ(physics().state(box).pose.position, before);

  physics().applyCentralForce(box, {500.0F, 0.0F, 0.0F});
  step();
  EXPECT_FALSE(physics().state(box).asleep);
  EXPECT_GT(physics().state(box).pose.position.x, before.x + 0.01F);
}

TEST_P(PhysicsConformance, BodyWokenByAnotherHasNoForceInStore) {
  startWithGravity(kEarth);
  addGround();
  BodyDef def = bodyAt({0.0F, 0.5F, 0.0F});
  def.mayRest = true;
  const BodyId box = add(def);
  step(300);
  ASSERT_TRUE(physics().state(box).asleep);
  add(bodyAt({0.0F, 2.5F, 0.0F}, Sphere{0.5F}));
  for (int i = 0; i < 120 && physics().state(box).asleep; ++i) {
    physics().applyCentralForce(box, {5000.0F, 0.0F, 0.0F}, /*wake=*/false);
    step();
  }
  ASSERT_FALSE(physics().state(box).asleep);
  EXPECT_NEAR(physics().state(box).linearVelocity.x, 0.0F, 0.1F);
}

TEST_P(PhysicsConformance, GravityCanChange) {
  startWithGravity(kEarth);
  addGround();
  BodyDef def = bodyAt({0.0F, 0.5F, 0.0F});
  def.mayRest = true;
  const BodyId box = add(def);
  step(300);
  ASSERT_TRUE(physics().state(box).asleep);
  physics().setGravity({0.0F, 10.0F, 0.0F});
  step(60);
  EXPECT_NEAR(physics().state(box).pose.position.y, 0.5F + 5.0F, 0.2F);
}

}  // namespace scatter::test
