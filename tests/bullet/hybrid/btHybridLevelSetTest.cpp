#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <BulletHybrid/btHybridLevelSet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "LevelReach.h"
#include "NotFinite.h"
#include "RandomShapes.h"

namespace scatter::test {
namespace {

using testing::HasSubstr;

btTransform at(float x, float y, float z) {
  return btTransform(btQuaternion::getIdentity(), btVector3(x, y, z));
}

/// Shapes, and what a level set says about them.
class LevelSetTest : public testing::Test {
 protected:
  /// What is said about one level; empty if it is taken, which getNumLevels() must agree with.
  std::string about(btCollisionShape* only) {
    btHybridLevelSet levels;
    const char* mistake = levels.addLevel(only);
    EXPECT_EQ(levels.getNumLevels(), mistake == nullptr ? 1 : 0);
    return mistake == nullptr ? std::string() : mistake;
  }

  /// What is said about the finer of two levels.
  std::string about(btCollisionShape* coarse, btCollisionShape* fine) {
    btHybridLevelSet levels;
    const char* first = levels.addLevel(coarse);
    EXPECT_EQ(first, nullptr) << first;
    const char* mistake = levels.addLevel(fine);
    EXPECT_EQ(levels.getNumLevels(), mistake == nullptr ? 2 : 1);
    return mistake == nullptr ? std::string() : mistake;
  }

  btBoxShape* box(float x, float y, float z) { return make<btBoxShape>(btVector3(x, y, z)); }

  btConvexHullShape* boxHull(float half, float margin) {
    auto* hull = make<btConvexHullShape>();
    for (int i = 0; i < 8; ++i) {
      hull->addPoint(btVector3(i & 1 ? half : -half, i & 2 ? half : -half, i & 4 ? half : -half));
    }
    hull->setMargin(margin);
    return hull;
  }

  btCompoundShape* compound(const std::vector<std::pair<btTransform, btCollisionShape*>>& parts) {
    auto* shape = make<btCompoundShape>();
    for (const auto& [place, part] : parts) shape->addChildShape(place, part);
    return shape;
  }

  template <class Shape, class... Args>
  Shape* make(Args&&... args) {
    return shapes_.make<Shape>(std::forward<Args>(args)...);
  }

  RandomShapes shapes_{7};
};

TEST_F(LevelSetTest, RefusesWhatIsNoListOfConvexParts) {
  EXPECT_THAT(about(nullptr), HasSubstr("needs a shape"));
  EXPECT_THAT(about(make<btStaticPlaneShape>(btVector3(0, 1, 0), 0.0F)), HasSubstr("not convex"));
  EXPECT_THAT(about(make<btEmptyShape>()), HasSubstr("not convex"));
  const std::vector<float> heights(16, 0.0F);
  EXPECT_THAT(
      about(make<btHeightfieldTerrainShape>(4, 4, heights.data(), 1.0F, -1.0F, 1.0F, 1, PHY_FLOAT, false)),
      HasSubstr("not convex"));
  btTriangleMesh triangles;
  triangles.addTriangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  auto* mesh = make<btBvhTriangleMeshShape>(&triangles, true);
  EXPECT_THAT(about(mesh), HasSubstr("not convex"));
  EXPECT_THAT(about(make<btCompoundShape>()), HasSubstr("without children"));
  auto* part = box(1, 1, 1);
  EXPECT_THAT(about(compound({{at(0, 0, 0), part}, {at(1, 0, 0), mesh}})),
              HasSubstr("child 1, is not convex"));
  auto* inner = compound({{at(0, 0, 0), part}});
  EXPECT_THAT(about(compound({{at(0, 0, 0), inner}})), HasSubstr("compound within a compound"));
  EXPECT_THAT(about(make<btConvexHullShape>()), HasSubstr("without points"));
  EXPECT_EQ(about(inner), "");
  EXPECT_EQ(about(part), "");
}

TEST_F(LevelSetTest, RefusesMoreThanPairsCanCount) {
  auto* part = box(1, 1, 1);
  auto* many = make<btCompoundShape>(false);
  for (int i = 0; i < 65536; ++i) many->addChildShape(btTransform::getIdentity(), part);
  EXPECT_THAT(about(many), HasSubstr("65535 children"));
  many->removeChildShapeByIndex(0);
  EXPECT_EQ(about(many), "");
  btHybridLevelSet levels;
  for (int i = 0; i < 250; ++i) ASSERT_EQ(levels.addLevel(part), nullptr);
  EXPECT_THAT(levels.addLevel(part), HasSubstr("at most 250 levels"));
  EXPECT_EQ(levels.getNumLevels(), 250);
}

TEST_F(LevelSetTest, RefusesWhatIsNotFinite) {
  for (const float bad : {kNaN, kInfinity, -kInfinity}) {
    EXPECT_THAT(about(box(1, bad, 1)), HasSubstr("finite"));
    EXPECT_THAT(about(make<btSphereShape>(bad)), HasSubstr("finite"));
    auto* hull = boxHull(1, 0.04F);
    hull->addPoint(btVector3(0, bad, 0));
    EXPECT_THAT(about(hull), HasSubstr("not finite"));
    EXPECT_THAT(about(boxHull(1, bad)), HasSubstr("margin"));
    EXPECT_THAT(about(compound({{at(0, bad, 0), box(1, 1, 1)}})), HasSubstr("place that is not finite"));
  }
  EXPECT_THAT(about(boxHull(1, -0.1F)), HasSubstr("margin"));
}

TEST_F(LevelSetTest, TellsByHowMuchALevelSticksOut) {
  EXPECT_THAT(about(box(1, 1, 1), box(1, 1.25F, 1)),
              HasSubstr("level 2, child 0, sticks out of level 1 by 0.25 m"));
  auto* half = box(0.5F, 1, 1);
  auto* two = compound({{at(-0.4F, 0, 0), half}, {at(0.6F, 0, 0), half}});
  EXPECT_THAT(about(box(1, 1, 1), two), HasSubstr("child 1, sticks out of level 1 by 0.1 m"));
  EXPECT_THAT(about(make<btSphereShape>(1.0F), make<btSphereShape>(1.5F)), HasSubstr("by 0.5 m"));
}

// What a margin adds to a hull counts; what it takes from a box or cylinder does not.
TEST_F(LevelSetTest, MarginsCount) {
  EXPECT_THAT(about(box(1, 1, 1), boxHull(1, 0.04F)), HasSubstr("0.04 m"));
  EXPECT_EQ(about(box(1, 1, 1), boxHull(0.96F, 0.04F)), "");
  EXPECT_EQ(about(boxHull(1, 0.04F), boxHull(1, 0.04F)), "");
  EXPECT_EQ(about(boxHull(1, 0.04F), boxHull(1.015F, 0.01F)), "") << "all corners are within the rounding";
  EXPECT_NE(about(boxHull(1, 0.04F), boxHull(1.02F, 0.01F)), "") << "corners stick out of the rounding";
  EXPECT_EQ(about(boxHull(1, 0.1F), box(1.05F, 1.05F, 1.05F)), "");
  EXPECT_NE(about(boxHull(1, 0.1F), box(1.09F, 1.09F, 1.09F)), "");
  auto* fat = box(1, 1, 1);
  fat->setMargin(0.3F);
  EXPECT_EQ(about(box(1, 1, 1), fat), "");
  EXPECT_EQ(about(fat, box(1, 1, 1)), "");
}

TEST_F(LevelSetTest, EveryConvexShapeHoldsItself) {
  for (int i = 0; i < 300; ++i) {
    btConvexShape* shape = shapes_.convex(2);
    EXPECT_EQ(about(shape, shape), "");
    const btTransform place = shapes_.random.pose(3);
    EXPECT_EQ(about(compound({{place, shape}}), compound({{place, shape}})), "");
  }
  for (int i = 0; i < 50; ++i) {
    btConvexShape* flat = shapes_.degenerateHull(2);
    EXPECT_EQ(about(flat, flat), "");
  }
}

// Another shape of the same sizes, elsewhere: nothing is recognised by its address.
TEST_F(LevelSetTest, RoundShapesHoldTheirEquals) {
  const btTransform place = shapes_.random.pose(2);
  const auto holdsItsEqual = [&](btCollisionShape* coarse, btCollisionShape* fine) {
    return about(compound({{place, coarse}}), compound({{place, fine}}));
  };
  EXPECT_EQ(holdsItsEqual(make<btSphereShape>(1.0F), make<btSphereShape>(1.0F)), "");
  EXPECT_EQ(holdsItsEqual(make<btCapsuleShape>(0.5F, 2.0F), make<btCapsuleShape>(0.5F, 2.0F)), "");
  EXPECT_EQ(holdsItsEqual(make<btCapsuleShapeX>(0.5F, 2.0F), make<btCapsuleShapeX>(0.5F, 2.0F)), "");
  EXPECT_EQ(
      holdsItsEqual(make<btCylinderShape>(btVector3(1, 2, 1)), make<btCylinderShape>(btVector3(1, 2, 1))),
      "");
  EXPECT_EQ(
      holdsItsEqual(make<btCylinderShapeZ>(btVector3(1, 1, 2)), make<btCylinderShapeZ>(btVector3(1, 1, 2))),
      "");
  EXPECT_EQ(holdsItsEqual(make<btConeShape>(1.0F, 2.0F), make<btConeShape>(1.0F, 2.0F)), "");
  EXPECT_EQ(holdsItsEqual(make<btConeShapeX>(1.0F, 2.0F), make<btConeShapeX>(1.0F, 2.0F)), "");
  EXPECT_EQ(
      holdsItsEqual(make<btSphereShape>(1.0F), make<btUniformScalingShape>(make<btSphereShape>(0.5F), 2.0F)),
      "");
  EXPECT_NE(
      holdsItsEqual(make<btSphereShape>(1.0F), make<btUniformScalingShape>(make<btSphereShape>(0.5F), 2.1F)),
      "");
}

TEST_F(LevelSetTest, RoundShapesHoldWhatIsInside) {
  auto* sphere = make<btSphereShape>(1.0F);
  EXPECT_EQ(about(sphere, box(0.57F, 0.57F, 0.57F)), "");
  EXPECT_NE(about(sphere, box(0.59F, 0.59F, 0.59F)), "");
  EXPECT_EQ(about(sphere, make<btCapsuleShape>(0.4F, 1.19F)), "");
  EXPECT_NE(about(sphere, make<btCapsuleShape>(0.4F, 1.21F)), "");
  EXPECT_EQ(about(box(1, 1, 1), sphere), "");
  auto* cylinder = make<btCylinderShape>(btVector3(1, 1, 1));
  EXPECT_NE(about(make<btSphereShape>(1.38F), cylinder), "");
  EXPECT_EQ(about(make<btSphereShape>(1.41F), cylinder), "");
  EXPECT_EQ(about(cylinder, sphere), "");
  auto* cone = make<btConeShape>(1.0F, 2.0F);
  cone->setMargin(0);
  // The ball in it has the radius 2 / (1 + sqrt(5)) and touches the base.
  EXPECT_EQ(about(cone, compound({{at(0, -0.382F, 0), make<btSphereShape>(0.617F)}})), "");
  EXPECT_NE(about(cone, compound({{at(0, -0.382F, 0), make<btSphereShape>(0.622F)}})), "");
}

TEST_F(LevelSetTest, PartsMayLieInSeveralTogether) {
  auto* left = box(1, 1, 1);
  auto* coarse = compound({{at(-1, 0, 0), left}, {at(1, 0, 0), left}});
  EXPECT_EQ(about(coarse, box(1.9F, 0.9F, 0.9F)), "");
  EXPECT_EQ(about(coarse, box(2, 1, 1)), "");
  EXPECT_THAT(about(coarse, box(2.1F, 1, 1)), HasSubstr("by 0.1 m"));
  EXPECT_EQ(about(coarse, boxHull(0.96F, 0.04F)), "");
  auto* plate = make<btConvexHullShape>();
  for (const float x : {-2.5F, 2.5F}) {
    for (const float z : {-0.5F, 0.5F}) plate->addPoint(btVector3(x, 0, z));
  }
  plate->setMargin(0);
  EXPECT_NE(about(coarse, plate), "");
  EXPECT_NE(about(coarse, compound({{btTransform(btQuaternion(0.1F, 0.2F, 0.3F)), plate}})), "");
  auto* gap = compound({{at(-1.01F, 0, 0), left}, {at(1.01F, 0, 0), left}});
  EXPECT_NE(about(gap, box(1.9F, 0.9F, 0.9F)), "");
  auto* hulls = compound({{at(-1, 0, 0), boxHull(1, 0.04F)}, {at(1, 0, 0), boxHull(1, 0.04F)}});
  EXPECT_EQ(about(hulls, compound({{at(0, 0, 0), boxHull(1, 0.04F)}})), "");
  EXPECT_EQ(about(hulls, box(2, 1, 1)), "");
  auto* bars = compound({{at(0, 0, 0), box(2, 0.5F, 0.5F)}, {at(0, 0, 0), box(0.5F, 2, 0.5F)}});
  EXPECT_EQ(about(bars, make<btSphereShape>(0.49F)), "");
  EXPECT_NE(about(bars, make<btSphereShape>(0.8F)), "");
  auto* capsules = compound({{at(0, 0.5F, 0), make<btCapsuleShape>(0.5F, 1.0F)},
                             {at(0, -0.5F, 0), make<btCapsuleShape>(0.5F, 1.0F)}});
  EXPECT_EQ(about(capsules, box(0.3F, 1, 0.3F)), "");
}

// Nested by construction: a box is cut in two, over and over, and every part is a little smaller than its
// piece.
TEST_F(LevelSetTest, TakesEveryCutOfABox) {
  for (int run = 0; run < 40; ++run) {
    struct Piece {
      btVector3 low;
      btVector3 high;
    };
    std::vector<Piece> pieces{{btVector3(-1, -1, -1), btVector3(1, 1, 1)}};
    btHybridLevelSet levels;
    const btTransform turn = shapes_.random.pose(1);
    for (int level = 0; level < 5; ++level) {
      auto* parts = make<btCompoundShape>();
      for (const Piece& piece : pieces) {
        const btVector3 half = 0.5F * (piece.high - piece.low);
        const btTransform place =
            turn * btTransform(btQuaternion::getIdentity(), 0.5F * (piece.low + piece.high));
        parts->addChildShape(place, make<btBoxShape>(half));
      }
      const char* mistake = levels.addLevel(parts);
      ASSERT_EQ(mistake, nullptr) << mistake;
      std::vector<Piece> next;
      for (const Piece& piece : pieces) {
        const int axis = shapes_.random.index(3);
        Piece low = piece;
        Piece high = piece;
        low.high[axis] = high.low[axis] =
            piece.low[axis] + (piece.high[axis] - piece.low[axis]) * shapes_.random.between(0.2F, 0.8F);
        next.push_back(low);
        next.push_back(high);
      }
      pieces = next;
    }
    // The union of all the smallest is still the box that it was.
    btHybridLevelSet back;
    ASSERT_EQ(back.addLevel(levels.getLevelShape(5)), nullptr);
    const char* mistake = back.addLevel(levels.getLevelShape(1));
    EXPECT_EQ(mistake, nullptr) << mistake;
  }
}

/// A random point of a shape's surface, by its support function.
btVector3 surfacePoint(const btConvexShape& shape, Random& random) {
  return shape.localGetSupportingVertex(random.direction());
}

// What is taken is nested: no point of the finer part is further outside than the tolerance allows.
TEST_F(LevelSetTest, WhatItTakesIsNested) {
  int taken = 0;
  int refused = 0;
  for (int run = 0; run < 1000; ++run) {
    btConvexShape* coarse = shapes_.convex(2);
    btConvexShape* fine = shapes_.convex(shapes_.random.between(0.2F, 2.2F));
    const btTransform place = shapes_.random.pose(0.3F);
    if (!about(coarse, compound({{place, fine}})).empty()) {
      ++refused;
      continue;
    }
    ++taken;
    for (int i = 0; i < 300; ++i) {
      const btVector3 point = place(surfacePoint(*fine, shapes_.random));
      const btVector3 direction = shapes_.random.direction();
      const float reach = direction.dot(coarse->localGetSupportingVertex(direction));
      EXPECT_LE(direction.dot(point), reach + 2e-4F * 3.2F);
    }
  }
  EXPECT_GT(taken, 100);
  EXPECT_GT(refused, 100);
}

// Nested by construction: a hull of points between a point inside and the surface, and round shapes in a ball
// inside.
TEST_F(LevelSetTest, WhatOneConvexPartHoldsIsNeverRefused) {
  for (int run = 0; run < 300; ++run) {
    btConvexShape* coarse = shapes_.convex(2);
    btVector3 inside(0, 0, 0);
    for (int i = 0; i < 40; ++i) inside += surfacePoint(*coarse, shapes_.random) / 40;
    auto* hull = make<btConvexHullShape>();
    for (int i = 0; i < 20; ++i) {
      hull->addPoint(inside.lerp(surfacePoint(*coarse, shapes_.random), shapes_.random.between(0.1F, 0.99F)));
    }
    hull->setMargin(0);
    EXPECT_EQ(about(coarse, hull), "") << coarse->getName();
    float radius = 1e9F;
    for (int i = 0; i < 3000; ++i) {
      const btVector3 direction = shapes_.random.direction();
      radius = btMin(radius, direction.dot(coarse->localGetSupportingVertex(direction) - inside));
    }
    // The directions are a few hundredths apart, and what is looked for is no wider than three metres.
    radius -= 0.1F;
    if (radius < 0.01F) continue;
    const btTransform place(shapes_.random.rotation(), inside);
    btConvexShape* const fines[] = {make<btSphereShape>(radius), make<btCapsuleShape>(0.5F * radius, radius),
                                    make<btBoxShape>(btVector3(0.57F, 0.57F, 0.57F) * radius),
                                    make<btCylinderShape>(btVector3(0.7F, 0.7F, 0.7F) * radius),
                                    make<btConeShape>(0.7F * radius, 1.4F * radius)};
    fines[4]->setMargin(0);
    for (btConvexShape* fine : fines) {
      fine->setMargin(btMin(fine->getMargin(), 0.1F * radius));
      EXPECT_EQ(about(coarse, compound({{place, fine}})), "")
          << coarse->getName() << " around " << fine->getName();
    }
  }
}

TEST_F(LevelSetTest, ProvenLevelsAreTakenAsTheyAre) {
  btHybridLevelSet levels;
  ASSERT_EQ(levels.addLevel(box(1, 1, 1), BT_HYBRID_NESTING_IS_PROVEN), nullptr);
  EXPECT_EQ(levels.addLevel(box(2, 2, 2), BT_HYBRID_NESTING_IS_PROVEN), nullptr);
  EXPECT_EQ(levels.getNumLevels(), 2);
  EXPECT_NE(levels.addLevel(make<btStaticPlaneShape>(btVector3(0, 1, 0), 0.0F), BT_HYBRID_NESTING_IS_PROVEN),
            nullptr);
}

TEST_F(LevelSetTest, CoarsestBoundsHoldTheLevelAndAreInsideBullets) {
  RandomShapes shapes(1);
  for (int trial = 0; trial < 300; ++trial) {
    btCollisionShape* shape = randomLevel(shapes);
    btHybridLevelSet levels;
    ASSERT_EQ(levels.addLevel(shape), nullptr);
    const btTransform pose = shapes.random.pose(10);
    btVector3 low, high, bulletLow, bulletHigh;
    levels.getCoarsestAabb(pose, low, high);
    shape->getAabb(pose, bulletLow, bulletHigh);
    for (int axis = 0; axis < 3; ++axis) {
      btVector3 direction(0, 0, 0);
      direction[axis] = 1;
      EXPECT_GE(high[axis], reachOf(shape, pose, direction) - 1e-5F) << "shape " << shape->getName();
      EXPECT_LE(low[axis], -reachOf(shape, pose, -direction) + 1e-5F) << "shape " << shape->getName();
      EXPECT_LE(high[axis], bulletHigh[axis] + 1e-5F) << "shape " << shape->getName();
      EXPECT_GE(low[axis], bulletLow[axis] - 1e-5F) << "shape " << shape->getName();
    }
  }
}

// The longer a hull is, the more of a box around it is empty.
TEST_F(LevelSetTest, CoarsestBoundsOfATurnedHullAreCloserThanThoseOfItsBox) {
  auto* hull = make<btConvexHullShape>();
  for (int i = 0; i < 6; ++i) {
    btVector3 point(0, 0, 0);
    point[i / 2] = (i % 2 == 0 ? 1.0F : -1.0F) * (i < 2 ? 4.0F : 1.0F);
    hull->addPoint(point);
  }
  hull->setMargin(0);
  btHybridLevelSet levels;
  ASSERT_EQ(levels.addLevel(hull), nullptr);
  const btTransform pose(btQuaternion(btVector3(0, 0, 1), SIMD_PI / 4), btVector3(0, 0, 0));
  btVector3 low, high;
  levels.getCoarsestAabb(pose, low, high);
  EXPECT_NEAR(high.x(), 4 * SIMDSQRT12, 1e-5F);
  hull->getAabb(pose, low, high);
  EXPECT_GE(high.x(), 5 * SIMDSQRT12);
}

TEST_F(LevelSetTest, CoarsestRadiusIsThatOfLevelOne) {
  btHybridLevelSet levels;
  ASSERT_EQ(levels.addLevel(box(1, 2, 2)), nullptr);
  EXPECT_FLOAT_EQ(levels.getCoarsestRadius(), 3);
  ASSERT_EQ(levels.addLevel(box(1, 1, 1)), nullptr);
  EXPECT_FLOAT_EQ(levels.getCoarsestRadius(), 3);
}

TEST_F(LevelSetTest, LevelsThatAreNotThereAreNull) {
  btHybridLevelSet levels;
  btVector3 low;
  btVector3 high;
  levels.getCoarsestAabb(at(1, 2, 3), low, high);
  EXPECT_EQ(low, btVector3(1, 2, 3));
  EXPECT_EQ(high, btVector3(1, 2, 3));
  EXPECT_EQ(levels.getLevelShape(1), nullptr);
  EXPECT_EQ(levels.getCoarsestRadius(), 0);
  btBoxShape* shape = box(1, 1, 1);
  ASSERT_EQ(levels.addLevel(shape), nullptr);
  EXPECT_EQ(levels.getLevelShape(1), shape);
  EXPECT_EQ(levels.getLevelShape(0), nullptr);
  EXPECT_EQ(levels.getLevelShape(-1), nullptr);
  EXPECT_EQ(levels.getLevelShape(2), nullptr);
}

}  // namespace
}  // namespace scatter::test
