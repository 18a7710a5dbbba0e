#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <BulletCollision/CollisionShapes/btMinkowskiSumShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "RandomShapes.h"
#include "ScriptedWorld.h"

// Hybrids against everything that Bullet has, compared with the same world under Bullet's own algorithms.

namespace scatter::test {
namespace {

using MakeShape = std::function<btCollisionShape*(RandomShapes&)>;

/// The same bodies in two worlds.
class OddTwins {
 public:
  explicit OddTwins(std::uint64_t seed, const MakeShape& makeOther) : shapes(seed) {
    const btHybridLevelSet& levels = shapes.oneLevel(shapes.compound(10, 1));
    btCollisionShape* other = makeOther(shapes);
    for (ScriptedWorld* w : {&ours, &bullets}) {
      w->addHybrid(levels, btTransform::getIdentity());
      w->addOther(0, other, btTransform::getIdentity());
    }
  }

  void place(int body, const btTransform& pose) {
    ours.place(body, pose);
    bullets.place(body, pose);
  }

  void detect() {
    ours.detect();
    bullets.detect();
  }

  RandomShapes shapes;
  ScriptedWorld ours{true};
  ScriptedWorld bullets{false};
};

/// Contacts near the threshold may differ.
void expectCovered(const std::map<ChildPair, ChildContact>& contacts,
                   const std::map<ChildPair, ChildContact>& by, const std::string& what, long& compared) {
  for (const auto& [pair, contact] : contacts) {
    if (contact.distance > 0.9F * contact.threshold) continue;
    ++compared;
    ASSERT_TRUE(by.contains(pair)) << what << ", children " << pair[2] << " and " << pair[3] << ", distance "
                                   << contact.distance;
  }
}

/// Moves the hybrid through the other shape and compares which child pairs are in contact.
long compareWithBullet(const char* what, const MakeShape& makeOther, const btVector3& centre = {0, 0, 0}) {
  long compared = 0;
  for (std::uint64_t seed = 300; seed < 304; ++seed) {
    OddTwins twins(seed, makeOther);
    for (int step = 0; step < 60; ++step) {
      // Far away in between, so that no world has old contacts to keep.
      twins.place(0, btTransform(btQuaternion::getIdentity(), btVector3(0, 500, 0)));
      twins.detect();
      const btTransform pose(twins.shapes.random.rotation(), centre + twins.shapes.random.inCube(1));
      twins.place(0, pose);
      twins.detect();
      const auto ours = twins.ours.contacts();
      const auto bullets = twins.bullets.contacts();
      const std::string where =
          std::string(what) + ", seed " + std::to_string(seed) + ", step " + std::to_string(step);
      expectCovered(bullets, ours, where + ", Bullet's", compared);
      // The pair algorithm tests less roughly than Bullet's midphase: what it has more is verified elsewhere.
      EXPECT_LE(ours.size(), bullets.size() + 2 + bullets.size() / 4) << where;
    }
    EXPECT_EQ(twins.ours.report().m_missed, 0) << what << ", seed " << seed;
  }
  return compared;
}

class PairShapes : public InBothModes {};
INSTANTIATE_TEST_SUITE_P(Modes, PairShapes, bothModes(), nameOfMode);

TEST_P(PairShapes, ConvexPrimitives) {
  const btVector3 half(0.5F, 0.4F, 0.3F);
  EXPECT_GT(compareWithBullet("box", [&](RandomShapes& s) { return s.make<btBoxShape>(half); }), 50);
  EXPECT_GT(compareWithBullet("sphere", [](RandomShapes& s) { return s.make<btSphereShape>(0.5F); }), 50);
  EXPECT_GT(compareWithBullet("capsule", [](RandomShapes& s) { return s.make<btCapsuleShape>(0.3F, 0.6F); }),
            50);
  EXPECT_GT(
      compareWithBullet("capsule x", [](RandomShapes& s) { return s.make<btCapsuleShapeX>(0.3F, 0.6F); }),
      50);
  EXPECT_GT(
      compareWithBullet("cylinder",
                        [](RandomShapes& s) { return s.make<btCylinderShape>(btVector3(0.5F, 0.4F, 0.5F)); }),
      50);
  EXPECT_GT(compareWithBullet(
                "cylinder z",
                [](RandomShapes& s) { return s.make<btCylinderShapeZ>(btVector3(0.5F, 0.5F, 0.4F)); }),
            50);
  EXPECT_GT(compareWithBullet("cone", [](RandomShapes& s) { return s.make<btConeShape>(0.5F, 0.8F); }), 50);
  EXPECT_GT(compareWithBullet("cone x", [](RandomShapes& s) { return s.make<btConeShapeX>(0.5F, 0.8F); }),
            50);
  EXPECT_GT(compareWithBullet("hull", [](RandomShapes& s) { return s.hull(1, 30); }), 50);
}

TEST_P(PairShapes, CylindersThatReachOutOfTheirBounds) {
  // Bullet takes one of the three half extents for the radius and bounds the cylinder by all of them.
  const btVector3 half(0.5F, 0.4F, 0.3F);
  EXPECT_GT(compareWithBullet("y", [&](RandomShapes& s) { return s.make<btCylinderShape>(half); }), 50);
  EXPECT_GT(compareWithBullet("x", [&](RandomShapes& s) { return s.make<btCylinderShapeX>(half); }), 50);
}

TEST_P(PairShapes, UnusualConvexShapes) {
  EXPECT_GT(compareWithBullet("triangle",
                              [](RandomShapes& s) {
                                return s.make<btTriangleShape>(btVector3(-1, 0, -1), btVector3(1, 0, -1),
                                                               btVector3(0, 0, 1));
                              }),
            50);
  EXPECT_GT(compareWithBullet("tetrahedron",
                              [](RandomShapes& s) {
                                return s.make<btBU_Simplex1to4>(btVector3(-1, 0, -1), btVector3(1, 0, -1),
                                                                btVector3(0, 0, 1), btVector3(0, 1, 0));
                              }),
            50);
  EXPECT_GT(
      compareWithBullet("spheres",
                        [](RandomShapes& s) {
                          const btVector3 centres[] = {btVector3(-0.4F, 0, 0), btVector3(0.4F, 0.2F, 0)};
                          const btScalar radii[] = {0.3F, 0.2F};
                          return s.make<btMultiSphereShape>(centres, radii, 2);
                        }),
      50);
  EXPECT_GT(compareWithBullet("sum",
                              [](RandomShapes& s) {
                                return s.make<btMinkowskiSumShape>(
                                    s.make<btBoxShape>(btVector3(0.3F, 0.3F, 0.3F)),
                                    s.make<btSphereShape>(0.2F));
                              }),
            50);
  EXPECT_GT(
      compareWithBullet("uniformly scaled",
                        [](RandomShapes& s) { return s.make<btUniformScalingShape>(s.hull(1, 20), 1.3F); }),
      50);
  EXPECT_GT(compareWithBullet("hull with features",
                              [](RandomShapes& s) {
                                btConvexHullShape* hull = s.hull(1, 20);
                                hull->initializePolyhedralFeatures();
                                return hull;
                              }),
            50);
}

TEST_P(PairShapes, Compounds) {
  EXPECT_GT(compareWithBullet("one part", [](RandomShapes& s) { return s.compound(1, 1); }), 50);
  EXPECT_GT(compareWithBullet("many parts", [](RandomShapes& s) { return s.compound(40, 1); }), 50);
  EXPECT_GT(compareWithBullet("no tree",
                              [](RandomShapes& s) {
                                auto* compound = s.make<btCompoundShape>(false);
                                for (int i = 0; i < 4; ++i)
                                  compound->addChildShape(s.random.pose(0.3F), s.convex(0.5F));
                                return compound;
                              }),
            50);
  EXPECT_GT(compareWithBullet("nested",
                              [](RandomShapes& s) {
                                auto* outer = s.make<btCompoundShape>();
                                outer->addChildShape(s.random.pose(0.2F), s.compound(3, 0.6F));
                                outer->addChildShape(s.random.pose(0.2F), s.convex(0.5F));
                                return outer;
                              }),
            50);
  EXPECT_GT(compareWithBullet("with a plane in it",
                              [](RandomShapes& s) {
                                auto* outer = s.make<btCompoundShape>();
                                outer->addChildShape(btTransform::getIdentity(),
                                                     s.make<btStaticPlaneShape>(btVector3(0, 1, 0), -0.3F));
                                outer->addChildShape(s.random.pose(0.2F), s.convex(0.5F));
                                return outer;
                              }),
            50);
  EXPECT_EQ(compareWithBullet("empty compound", [](RandomShapes& s) { return s.make<btCompoundShape>(); }),
            0);
}

TEST_P(PairShapes, ConcaveShapes) {
  EXPECT_GT(
      compareWithBullet("plane",
                        [](RandomShapes& s) { return s.make<btStaticPlaneShape>(btVector3(0, 1, 0), 0.0F); }),
      50);
  EXPECT_EQ(compareWithBullet("empty", [](RandomShapes& s) { return s.make<btEmptyShape>(); }), 0);
  btTriangleMesh mesh;
  std::vector<float> heights;
  const auto height = [](int x, int z) { return 0.2F * std::sin(static_cast<float>(3 * x + 5 * z)); };
  const auto corner = [&](int x, int z) {
    return btVector3(static_cast<float>(x) * 0.5F, height(x, z), static_cast<float>(z) * 0.5F);
  };
  for (int x = -5; x <= 5; ++x) {
    for (int z = -5; z <= 5; ++z) {
      heights.push_back(height(x, z));
      if (x == 5 || z == 5) continue;
      mesh.addTriangle(corner(x, z), corner(x, z + 1), corner(x + 1, z));
      mesh.addTriangle(corner(x + 1, z), corner(x, z + 1), corner(x + 1, z + 1));
    }
  }
  EXPECT_GT(
      compareWithBullet("mesh", [&](RandomShapes& s) { return s.make<btBvhTriangleMeshShape>(&mesh, true); }),
      50);
  EXPECT_GT(compareWithBullet("scaled mesh",
                              [&](RandomShapes& s) {
                                return s.make<btScaledBvhTriangleMeshShape>(
                                    s.make<btBvhTriangleMeshShape>(&mesh, true), btVector3(1.2F, 0.8F, 1));
                              }),
            50);
  EXPECT_GT(compareWithBullet("height field",
                              [&](RandomShapes& s) {
                                return s.make<btHeightfieldTerrainShape>(11, 11, heights.data(), -1.0F, 1.0F,
                                                                         1, false);
                              }),
            50);
}

TEST_P(PairShapes, ABareConvexLevel) {
  // A hybrid whose level is one convex shape, without a compound around it.
  RandomShapes shapes(5);
  ScriptedWorld w;
  w.addHybrid(shapes.oneLevel(shapes.hull(1, 12)), btTransform::getIdentity());
  w.addHybrid(shapes.oneLevel(shapes.make<btSphereShape>(0.4F)), btTransform::getIdentity());
  w.addHybrid(shapes.oneLevel(shapes.compound(6, 1)), btTransform::getIdentity());
  w.addOther(1, shapes.make<btBoxShape>(btVector3(0.4F, 0.4F, 0.4F)), btTransform::getIdentity());
  for (int step = 0; step < 300; ++step) {
    for (int i = 0; i < 4; ++i) w.place(i, shapes.random.pose(0.8F));
    w.detect();
    ASSERT_EQ(w.report().m_missed, 0) << "step " << step;
  }
  EXPECT_GT(w.report().m_expected, 500);
}

}  // namespace
}  // namespace scatter::test
