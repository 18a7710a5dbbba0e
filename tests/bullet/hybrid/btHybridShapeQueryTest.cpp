#include "bullet/BulletHybrid/btHybridShapeQuery.h"

#include <btBulletCollisionCommon.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "RandomShapes.h"
#include "bullet/BulletHybrid/btHybridConvexQuery.h"

namespace scatter::test {
namespace {

btTransform at(const btVector3& position, const btQuaternion& rotation = btQuaternion::getIdentity()) {
  return btTransform(rotation, position);
}

/// The deepest overlap, to a millimetre, by halving; -1 if there is none.
float depthOf(btHybridShapeQuery& query, const btHybridPlacedShape& a, const btHybridPlacedShape& b) {
  float low = 0.0F;
  float high = 100.0F;
  if (!query.overlapDeeper(a, b, low)) return -1.0F;
  while (high - low > 1e-3F) {
    const float middle = (low + high) / 2.0F;
    (query.overlapDeeper(a, b, middle) ? low : high) = middle;
  }
  return low;
}

TEST(ShapeQuery, SpheresAreAsDeepAndAsFarAsTheirCentresSay) {
  btHybridShapeQuery query;
  btSphereShape big(2.0F);
  btSphereShape small(0.5F);
  for (const float distance : {0.3F, 1.0F, 2.4F, 2.6F, 9.0F, 300.0F}) {
    const btHybridPlacedShape a = {&big, at({1, 2, 3})};
    const btHybridPlacedShape b = {&small, at(btVector3(1, 2, 3) + distance * btVector3(0.6F, 0.8F, 0))};
    EXPECT_NEAR(query.getDistance(a, b), std::max(0.0F, distance - 2.5F), 1e-3F) << distance;
    EXPECT_NEAR(depthOf(query, a, b), distance < 2.5F ? 2.5F - distance : -1.0F, 2e-3F) << distance;
  }
}

TEST(ShapeQuery, BoxesHaveSharpEdges) {
  btHybridShapeQuery query;
  btBoxShape box(btVector3(1, 1, 1));
  const btHybridPlacedShape a = {&box, at({0, 0, 0})};
  // Edge against edge: turned by 45 degrees, it reaches sqrt(2) along x.
  const btQuaternion turn(btVector3(0, 0, 1), SIMD_PI / 4);
  const float reach = 1.0F + std::sqrt(2.0F);
  EXPECT_NEAR(query.getDistance(a, {&box, at({reach + 0.3F, 0, 0}, turn)}), 0.3F, 1e-3F);
  EXPECT_NEAR(depthOf(query, a, {&box, at({reach - 0.3F, 0, 0}, turn)}), 0.3F, 2e-3F);
  // Corner to corner, along the diagonal.
  EXPECT_NEAR(query.getDistance(a, {&box, at({3, 3, 3})}), std::sqrt(3.0F), 1e-3F);
  EXPECT_EQ(query.getDistance(a, {&box, at({0.5F, 0, 0})}), 0.0F);
}

TEST(ShapeQuery, APlaneIsAHalfSpace) {
  btHybridShapeQuery query;
  btStaticPlaneShape ground(btVector3(0, 1, 0), 1.0F);
  btSphereShape ball(0.5F);
  const btHybridPlacedShape plane = {&ground, at({0, 0, 0})};
  EXPECT_NEAR(query.getDistance(plane, {&ball, at({7, 4, 0})}), 2.5F, 1e-4F);
  EXPECT_NEAR(query.getDistance({&ball, at({7, 4, 0})}, plane), 2.5F, 1e-4F);
  EXPECT_NEAR(depthOf(query, plane, {&ball, at({7, 1.2F, 0})}), 0.3F, 2e-3F);
  EXPECT_NEAR(depthOf(query, plane, {&ball, at({7, -3, 0})}), 4.5F, 2e-3F);
}

TEST(ShapeQuery, AMeshIsItsTriangles) {
  btHybridShapeQuery query;
  btTriangleMesh triangles;
  triangles.addTriangle(btVector3(-10, 0, -10), btVector3(-10, 0, 10), btVector3(10, 0, 10));
  triangles.addTriangle(btVector3(-10, 0, -10), btVector3(10, 0, 10), btVector3(10, 0, -10));
  btBvhTriangleMeshShape mesh(&triangles, true);
  mesh.setMargin(0.0F);
  btSphereShape ball(0.5F);
  btCompoundShape pair;
  pair.addChildShape(at({0, 0, 0}), &ball);
  pair.addChildShape(at({0, 3, 0}), &ball);
  const btHybridPlacedShape floor = {&mesh, at({0, 2, 0})};
  EXPECT_NEAR(query.getDistance(floor, {&pair, at({1, 4, 2})}), 1.5F, 1e-3F);
  EXPECT_NEAR(query.getDistance(floor, {&pair, at({1, 60, 2})}), 57.5F, 1e-2F);
  EXPECT_NEAR(depthOf(query, floor, {&pair, at({1, 2.3F, 2})}), 0.2F, 2e-3F);
  EXPECT_FALSE(query.overlapDeeper(floor, {&pair, at({1, 2.6F, 2})}, 0.0F));
}

TEST(ShapeQuery, AnEmptyShapeIsNowhere) {
  btHybridShapeQuery query;
  btEmptyShape nothing;
  btCompoundShape noParts;
  btSphereShape ball(0.5F);
  for (btCollisionShape* shape :
       {static_cast<btCollisionShape*>(&nothing), static_cast<btCollisionShape*>(&noParts)}) {
    EXPECT_EQ(query.getDistance({shape, at({0, 0, 0})}, {&ball, at({0, 0, 0})}), btScalar(BT_LARGE_FLOAT));
    EXPECT_FALSE(query.overlapDeeper({shape, at({0, 0, 0})}, {&ball, at({0, 0, 0})}, 0.0F));
  }
}

// One has the same parts as the other, in compounds in a compound.
TEST(ShapeQuery, CompoundsInCompoundsAreTheirParts) {
  btConvexHullShape hull;
  for (int i = 0; i < 8; ++i) {
    hull.addPoint(
        btVector3((i & 1) != 0 ? 0.4F : -0.4F, (i & 2) != 0 ? 0.3F : -0.3F, (i & 4) != 0 ? 0.2F : -0.5F));
  }
  btSphereShape ball(0.5F);
  btCylinderShape can(btVector3(0.3F, 0.6F, 0.3F));
  const btTransform group = at({0, 2, 0}, btQuaternion(btVector3(1, 0, 0), 0.4F));
  const btTransform inGroup = at({1, 0, 0.5F}, btQuaternion(btVector3(0, 0, 1), 0.9F));
  btCompoundShape inner;
  inner.addChildShape(at({-1, 0, 0}), &hull);
  inner.addChildShape(inGroup, &can);
  btCompoundShape nested;
  nested.addChildShape(at({0, -1, 0}), &ball);
  nested.addChildShape(group, &inner);
  btCompoundShape flat;
  flat.addChildShape(at({0, -1, 0}), &ball);
  flat.addChildShape(group * at({-1, 0, 0}), &hull);
  flat.addChildShape(group * inGroup, &can);
  btHybridShapeQuery query;
  Random random(3);
  for (int i = 0; i < 40; ++i) {
    const btTransform pose =
        at(random.inCube(3.0F), btQuaternion(btVector3(0, 1, 0), 0.2F * static_cast<float>(i)));
    const btHybridPlacedShape other = {&can, pose};
    const btHybridPlacedShape ofNested = {&nested, at({0, 0, 0})};
    const btHybridPlacedShape ofFlat = {&flat, at({0, 0, 0})};
    EXPECT_NEAR(query.getDistance(ofNested, other), query.getDistance(ofFlat, other), 1e-3F);
    EXPECT_NEAR(depthOf(query, ofNested, other), depthOf(query, ofFlat, other), 2e-3F);
  }
}

struct Answer {
  float distance = BT_LARGE_FLOAT;
  float depth = -BT_LARGE_FLOAT;
};

/// Every child against every child, without bounds or part lists.
Answer bruteForce(const btCompoundShape& a, const btTransform& poseA, const btCompoundShape& b,
                  const btTransform& poseB) {
  Answer answer;
  for (int i = 0; i < a.getNumChildShapes(); ++i) {
    for (int j = 0; j < b.getNumChildShapes(); ++j) {
      const auto* childA = static_cast<const btConvexShape*>(a.getChildShape(i));
      const auto* childB = static_cast<const btConvexShape*>(b.getChildShape(j));
      const btTransform placeA = poseA * a.getChildTransform(i);
      const btTransform placeB = poseB * b.getChildTransform(j);
      answer.distance = std::min(answer.distance, btHybridConvexDistance(childA, placeA, childB, placeB));
      answer.depth = std::max(answer.depth, btHybridConvexDepth(childA, placeA, childB, placeB));
    }
  }
  return answer;
}

TEST(ShapeQuery, AgreesWithBruteForceOverAllParts) {
  RandomShapes shapes(5);
  int overlaps = 0;
  int gaps = 0;
  for (int round = 0; round < 400; ++round) {
    btCompoundShape* a = shapes.plainCompound(1 + shapes.random.index(12), 2.0F);
    btCompoundShape* b = shapes.plainCompound(1 + shapes.random.index(12), 2.0F);
    const btTransform poseA = shapes.random.pose(50.0F);
    const btTransform poseB(shapes.random.rotation(),
                            poseA.getOrigin() + shapes.random.inCube(round % 2 == 0 ? 1.0F : 8.0F));
    const Answer expected = bruteForce(*a, poseA, *b, poseB);
    btHybridShapeQuery query;
    const btHybridPlacedShape placedA = {a, poseA};
    const btHybridPlacedShape placedB = {b, poseB};
    // Bullet rounds the edges of boxes where it measures distances.
    EXPECT_LE(query.getDistance(placedA, placedB), expected.distance + 2e-3F) << round;
    EXPECT_GE(query.getDistance(placedA, placedB), expected.distance - 0.06F) << round;
    EXPECT_NEAR(query.getDistance(placedB, placedA), query.getDistance(placedA, placedB), 1e-3F) << round;
    gaps += expected.distance > 0.1F ? 1 : 0;
    for (const float depth : {0.0F, 0.05F, 0.2F}) {
      if (std::abs(expected.depth - depth) < 5e-3F) continue;
      EXPECT_EQ(query.overlapDeeper(placedA, placedB, depth), expected.depth > depth)
          << round << ' ' << depth;
      EXPECT_EQ(query.overlapDeeper(placedB, placedA, depth), expected.depth > depth)
          << round << ' ' << depth;
      overlaps += expected.depth > depth ? 1 : 0;
    }
  }
  EXPECT_GT(overlaps, 100);
  EXPECT_GT(gaps, 100);
}

// A property of depth itself: shapes of any kind that are moved apart by it, along some direction, are apart.
TEST(ShapeQuery, ADepthIsNeverLessThanWhatIsThere) {
  RandomShapes shapes(6);
  for (int round = 0; round < 300; ++round) {
    const btConvexShape* a = shapes.convex(1.0F);
    const btConvexShape* b = shapes.convex(1.0F);
    const btTransform poseA = shapes.random.pose(20.0F);
    const btTransform poseB(shapes.random.rotation(), poseA.getOrigin() + shapes.random.inCube(0.3F));
    const float depth = btHybridConvexDepth(a, poseA, b, poseB);
    if (depth < 0.02F) continue;
    // Moved by less in any direction, they overlap still.
    for (int i = 0; i < 20; ++i) {
      btTransform moved = poseB;
      moved.getOrigin() += 0.97F * depth * shapes.random.direction();
      EXPECT_GT(btHybridConvexDepth(a, poseA, b, moved), -0.01F) << round;
    }
  }
}

TEST(ShapeQuery, MovingBothChangesNothing) {
  RandomShapes shapes(7);
  for (int round = 0; round < 100; ++round) {
    btCompoundShape* a = shapes.compound(6, 2.0F);
    btCompoundShape* b = shapes.compound(6, 2.0F);
    const btTransform poseA = shapes.random.pose(3.0F);
    const btTransform poseB = shapes.random.pose(3.0F);
    const btTransform motion = shapes.random.pose(10.0F);
    btHybridShapeQuery query;
    const float distance = query.getDistance({a, poseA}, {b, poseB});
    EXPECT_NEAR(query.getDistance({a, motion * poseA}, {b, motion * poseB}), distance, 2e-3F) << round;
  }
}

}  // namespace
}  // namespace scatter::test
