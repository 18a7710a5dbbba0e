#include <glm/geometric.hpp>

#include "world/conformance/physics_conformance.h"

namespace scatter::test {

TEST_P(PhysicsConformance, RayFindsTheClosestBody) {
  startWithGravity(Vec3(0.0F));
  const BodyId near = add(bodyAt({5.0F, 0.0F, 0.0F}, Sphere{1.0F}));
  add(bodyAt({9.0F, 0.0F, 0.0F}));
  const auto hit = physics().castRay(Vec3(0.0F), {10.0F, 0.0F, 0.0F});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->body, near);
  EXPECT_NEAR(hit->fraction, 0.4F, 1e-3F);
  expectNear(hit->point, {4.0F, 0.0F, 0.0F}, 1e-2F);
  expectNear(hit->normal, {-1.0F, 0.0F, 0.0F}, 1e-2F);
  EXPECT_FALSE(physics().castRay(Vec3(0.0F), {0.0F, 10.0F, 0.0F}));
  EXPECT_FALSE(physics().castRay(Vec3(0.0F), Vec3(0.0F)));
}

TEST_P(PhysicsConformance, ShapesHaveTheirSizes) {
  struct Size {
    Shape shape;
    Vec3 half;
  };
  const ConvexHull octahedron{{{1, 0, 0}, {-1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {0, -2, 0}, {0, 0, -3}}};
  for (const Size& size :
       {Size{Box{{0.2F, 0.3F, 0.4F}}, {0.2F, 0.3F, 0.4F}}, Size{Sphere{0.7F}, Vec3(0.7F)},
        Size{Capsule{0.3F, 0.6F}, {0.3F, 0.9F, 0.3F}}, Size{Cylinder{0.3F, 0.6F}, {0.3F, 0.6F, 0.3F}},
        Size{octahedron, {1, 2, 3}}, Size{Compound{{{Box{Vec3(0.5F)}, {}}}}, Vec3(0.5F)}}) {
    SCOPED_TRACE(size.shape.index());
    startWithGravity(Vec3(0.0F));
    const Vec3 at{1.0F, 2.0F, 3.0F};
    add(bodyAt(at, size.shape));
    for (int axis = 0; axis < 3; ++axis) {
      for (const float side : {-1.0F, 1.0F}) {
        Vec3 from = at;
        from[axis] += side * 10.0F;
        const auto hit = physics().castRay(from, at);
        ASSERT_TRUE(hit);
        EXPECT_NEAR(std::abs(hit->point[axis] - at[axis]), size.half[axis], 0.03F);
      }
    }
  }
}

TEST_P(PhysicsConformance, RayFindsAMovedBodyWhereItIs) {
  startWithGravity(Vec3(0.0F));
  const BodyId body = add(bodyAt({5.0F, 0.0F, 0.0F}));
  physics().setPose(body, {{0.0F, 5.0F, 0.0F}, kNoRotation});
  EXPECT_FALSE(physics().castRay(Vec3(0.0F), {10.0F, 0.0F, 0.0F}));
  EXPECT_TRUE(physics().castRay(Vec3(0.0F), {0.0F, 10.0F, 0.0F}));
}

TEST_P(PhysicsConformance, RayIgnoresSensorsAndBodiesItStartsIn) {
  startWithGravity(Vec3(0.0F));
  BodyDef sensor = bodyAt({2.0F, 0.0F, 0.0F});
  sensor.sensor = true;
  add(sensor);
  add(bodyAt(Vec3(0.0F)));
  BodyDef lonely = bodyAt({5.0F, 0.0F, 0.0F});
  lonely.group = 4;
  lonely.collidesWith = 0;
  const BodyId behind = add(lonely);
  const auto hit = physics().castRay(Vec3(0.0F), {10.0F, 0.0F, 0.0F});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->body, behind);
}

TEST_P(PhysicsConformance, SensorReportsContactsAndDoesNotPush) {
  startWithGravity(Vec3(0.0F));
  BodyDef sensor = bodyAt(Vec3(0.0F));
  sensor.motion = Motion::kStatic;
  sensor.sensor = true;
  add(sensor);
  BodyDef ball = bodyAt({-2.0F, 0.0F, 0.0F}, Sphere{0.25F});
  ball.linearVelocity = {4.0F, 0.0F, 0.0F};
  const BodyId body = add(ball);
  std::uint32_t contacts = 0;
  for (int i = 0; i < 60; ++i) {
    step();
    contacts += physics().counters().contacts;
    EXPECT_EQ(physics().maxPenetration(), 0.0);
  }
  EXPECT_GT(contacts, 0U);
  expectNear(physics().state(body).pose.position, {2.0F, 0.0F, 0.0F}, 1e-3F);
  expectNear(physics().state(body).linearVelocity, {4.0F, 0.0F, 0.0F}, 1e-4F);
}

TEST_P(PhysicsConformance, BodiesCollideOnlyIfBothAgree) {
  struct Case {
    std::uint32_t groupA, maskA, groupB, maskB;
    bool collide;
  };
  for (const Case& c : {Case{1, ~0U, 1, ~0U, true}, Case{1, 2, 2, 1, true}, Case{1, 2, 2, 2, false},
                        Case{1, 4, 2, 1, false}, Case{0x80000000U, ~0U, 1, 0x80000000U, true}}) {
    SCOPED_TRACE(testing::Message() << c.groupA << " " << c.maskA << " " << c.groupB << " " << c.maskB);
    startWithGravity(Vec3(0.0F));
    BodyDef a = bodyAt(Vec3(0.0F), Sphere{0.5F});
    a.group = c.groupA;
    a.collidesWith = c.maskA;
    BodyDef b = bodyAt({0.9F, 0.0F, 0.0F}, Sphere{0.5F});
    b.group = c.groupB;
    b.collidesWith = c.maskB;
    const BodyId first = add(a);
    add(b);
    step(10);
    EXPECT_EQ(physics().state(first).pose.position.x < -1e-4F, c.collide);
  }
}

TEST_P(PhysicsConformance, CountsPairsAndContacts) {
  startWithGravity(kEarth);
  addGround();
  step();
  EXPECT_EQ(physics().counters().objects, 1U);
  EXPECT_EQ(physics().counters().narrowphasePairs, 0U);

  add(bodyAt({0.0F, 0.5F, 0.0F}, Sphere{0.5F}));
  step();
  EXPECT_EQ(physics().counters().objects, 2U);
  EXPECT_EQ(physics().counters().hybrids, 0U);
  EXPECT_EQ(physics().counters().narrowphasePairs, 1U);
  EXPECT_EQ(physics().counters().pairsWithoutHybrid, 1U);
  EXPECT_EQ(physics().counters().finestPairs, 1U);
  EXPECT_EQ(physics().counters().manifolds, 1U);
  EXPECT_EQ(physics().counters().contacts, 1U);
  EXPECT_EQ(physics().counters().newContacts, 1U);

  const BodyId far = add(bodyAt({10.0F, 0.5F, 0.0F}, cubeLevels()));
  step();
  EXPECT_EQ(physics().counters().objects, 3U);
  EXPECT_EQ(physics().counters().hybrids, 1U);
  EXPECT_EQ(physics().counters().narrowphasePairs, 2U);
  EXPECT_EQ(physics().counters().pairsWithHybrid, 1U);
  EXPECT_EQ(physics().counters().pairsWithoutHybrid, 1U);
  EXPECT_EQ(physics().counters().finestPairs, 2U);
  step(30);
  EXPECT_GE(physics().counters().contacts, 5U);
  EXPECT_EQ(physics().counters().newContacts, 0U);

  physics().destroyBody(far);
  step();
  EXPECT_EQ(physics().counters().objects, 2U);
  EXPECT_EQ(physics().counters().hybrids, 0U);
  EXPECT_EQ(physics().counters().narrowphasePairs, 1U);
}

TEST_P(PhysicsConformance, ContactOnTheEdgeOfTwoTrianglesIsNewOnce) {
  startWithGravity(Vec3(0.0F));
  auto mesh = std::make_shared<TriangleMesh>();
  mesh->vertices = {{-5, 0, -5}, {5, 0, -5}, {5, 0, 5}, {-5, 0, 5}};
  mesh->triangles = {{0, 2, 1}, {0, 3, 2}};
  BodyDef ground = bodyAt(Vec3(0.0F), std::shared_ptr<const TriangleMesh>(mesh));
  ground.motion = Motion::kStatic;
  add(ground);
  add(bodyAt({1.0F, 0.495F, 1.0F}, Sphere{0.5F}));
  step();
  EXPECT_EQ(physics().counters().contacts, 1U);
  EXPECT_EQ(physics().counters().newContacts, 1U);
}

TEST_P(PhysicsConformance, StaticBodiesMakeNoPairs) {
  startWithGravity(kEarth);
  addGround();
  BodyDef wall = bodyAt(Vec3(0.0F));
  wall.motion = Motion::kStatic;
  add(wall);
  wall.motion = Motion::kKinematic;
  add(wall);
  step(2);
  EXPECT_EQ(physics().counters().overlappingPairs, 0U);
  EXPECT_EQ(physics().counters().narrowphasePairs, 0U);
}

TEST_P(PhysicsConformance, DepthOfTheDeepestContact) {
  startWithGravity(Vec3(0.0F));
  add(bodyAt(Vec3(0.0F), Sphere{0.5F}));
  add(bodyAt({0.9F, 0.0F, 0.0F}, Sphere{0.5F}));
  step();
  EXPECT_NEAR(physics().maxPenetration(), 0.1, 1e-3);
}

TEST_P(PhysicsConformance, StageTimesAreThereWhileProfilingIsOn) {
  startWithGravity(kEarth);
  addGround();
  for (int i = 0; i < 20; ++i) add(bodyAt({0.0F, 0.5F + static_cast<float>(i), 0.0F}));
  step(10);
  double total = 0.0;
  for (const double stage : physics().stageTimes()) {
    EXPECT_GE(stage, 0.0);
    total += stage;
  }
  EXPECT_GT(total, 0.0);
  EXPECT_GT(physics().stageTimes()[static_cast<std::size_t>(Stage::kCollisionDetection)], 0.0);

  physics().setProfiling(false);
  EXPECT_EQ(physics().stageTimes(), StageTimes{});
  step();
  EXPECT_EQ(physics().stageTimes(), StageTimes{});
}

}  // namespace scatter::test
