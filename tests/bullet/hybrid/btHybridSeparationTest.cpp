#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <BulletHybrid/btHybridSeparation.h>
#include <gtest/gtest.h>

#include <random>

#include "BulletTestWorld.h"

namespace scatter::test {
namespace {

btTransform at(float x, float y = 0, float z = 0) {
  return btTransform(btQuaternion::getIdentity(), btVector3(x, y, z));
}

TEST(Separation, BoxesFaceToFaceAreMeasuredExactly) {
  const btBoxShape unit(btVector3(0.5F, 0.5F, 0.5F));
  EXPECT_TRUE(btHybridIsSeparated(&unit, at(0), &unit, at(1.02F), 0.01F));
  EXPECT_FALSE(btHybridIsSeparated(&unit, at(0), &unit, at(1.005F), 0.01F));
  EXPECT_FALSE(btHybridIsSeparated(&unit, at(0), &unit, at(0.5F), 0.01F));
  EXPECT_FALSE(btHybridIsSeparated(&unit, at(0), &unit, at(0), 0.01F));
}

TEST(Separation, MarginsOfHullsCount) {
  btConvexHullShape hull;
  for (int i = 0; i < 8; ++i) {
    hull.addPoint(
        btVector3((i & 1) != 0 ? 0.5F : -0.5F, (i & 2) != 0 ? 0.5F : -0.5F, (i & 4) != 0 ? 0.5F : -0.5F));
  }
  hull.setMargin(0.1F);
  // Faces reach 0.6 m, so a distance of 1.25 m leaves 5 cm.
  EXPECT_TRUE(btHybridIsSeparated(&hull, at(0), &hull, at(1.25F), 0.04F));
  EXPECT_FALSE(btHybridIsSeparated(&hull, at(0), &hull, at(1.25F), 0.06F));
}

TEST(Separation, ABodyUnderAPlaneTouchesIt) {
  const btStaticPlaneShape ground(btVector3(0, 1, 0), 0);
  const btSphereShape ball(0.5F);
  EXPECT_TRUE(btHybridIsSeparated(&ground, at(0), &ball, at(0, 0.6F), 0.01F));
  EXPECT_FALSE(btHybridIsSeparated(&ground, at(0), &ball, at(0, 0.505F), 0.01F));
  EXPECT_FALSE(btHybridIsSeparated(&ball, at(0, -100), &ground, at(0), 0.01F));
}

TEST(Separation, CompoundsAreSeparatedBetweenTheirPieces) {
  btBoxShape post(btVector3(0.1F, 1, 0.1F));
  for (const bool tree : {true, false}) {
    btCompoundShape gate(tree);
    gate.addChildShape(at(-1), &post);
    gate.addChildShape(at(1), &post);
    const btSphereShape ball(0.5F);
    EXPECT_TRUE(btHybridIsSeparated(&gate, at(0), &ball, at(0), 0.01F));
    EXPECT_TRUE(btHybridIsSeparated(&ball, at(0), &gate, at(0), 0.01F));
    EXPECT_FALSE(btHybridIsSeparated(&gate, at(0), &ball, at(0.5F), 0.01F));
  }
}

TEST(Separation, MeshesAndHeightFieldsAreTheirTriangles) {
  btTriangleMesh triangles;
  triangles.addTriangle(btVector3(-5, 0, -5), btVector3(-5, 0, 5), btVector3(5, 0, 0));
  btBvhTriangleMeshShape mesh(&triangles, true);
  mesh.setMargin(0.04F);
  const btSphereShape ball(0.5F);
  EXPECT_TRUE(btHybridIsSeparated(&mesh, at(0), &ball, at(0, 0.6F), 0.01F));
  EXPECT_FALSE(btHybridIsSeparated(&mesh, at(0), &ball, at(0, 0.53F), 0.01F));

  std::vector<float> heights(25, 0.0F);
  btHeightfieldTerrainShape field(5, 5, heights.data(), 1, -1, 1, 1, PHY_FLOAT, false);
  EXPECT_TRUE(btHybridIsSeparated(&field, at(0), &ball, at(0, 0.7F), 0.01F));
  EXPECT_FALSE(btHybridIsSeparated(&field, at(0), &ball, at(0, 0.4F), 0.01F));
}

TEST(Separation, UnknownShapesAreNeverSeparated) {
  struct Odd : btSphereShape {
    Odd() : btSphereShape(0.1F) { m_shapeType = CUSTOM_CONCAVE_SHAPE_TYPE; }
  } odd;
  const btSphereShape ball(0.5F);
  EXPECT_FALSE(btHybridIsSeparated(&odd, at(0), &ball, at(0.55F), 0.01F));
}

/// Bullet's own detector on the same pair: the smallest contact distance, or a large number.
class Nearest : public btCollisionWorld::ContactResultCallback {
 public:
  Nearest() { m_closestDistanceThreshold = 10; }
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                           const btCollisionObjectWrapper*, int, int) override {
    distance = btMin(distance, point.getDistance());
    return 0;
  }
  btScalar distance = 1e9F;
};

TEST(Separation, NeverClaimsMoreThanBulletsOwnDetectorFinds) {
  std::mt19937 random(7);
  auto uniform = [&random](float low, float high) {
    return low + (high - low) * static_cast<float>(random() >> 8) / static_cast<float>(1U << 24);
  };
  BulletTestWorld<btDiscreteDynamicsWorld> w;
  auto* hull = w.shape<btConvexHullShape>();
  for (int i = 0; i < 20; ++i) hull->addPoint(btVector3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)));
  auto* compound = w.shape<btCompoundShape>();
  compound->addChildShape(at(1), w.shape<btBoxShape>(btVector3(0.5F, 0.2F, 0.7F)));
  compound->addChildShape(at(-1), hull);
  btCollisionShape* forms[] = {w.shape<btBoxShape>(btVector3(0.4F, 0.9F, 0.6F)),
                               w.shape<btSphereShape>(0.7F),
                               w.shape<btCapsuleShape>(0.3F, 1.0F),
                               w.shape<btCylinderShape>(btVector3(0.5F, 0.7F, 0.5F)),
                               hull,
                               compound};
  constexpr btScalar kGap = 0.05F;
  int separated = 0;
  int together = 0;
  for (int i = 0; i < 6000; ++i) {
    btCollisionObject a;
    btCollisionObject b;
    a.setCollisionShape(forms[random() % 6]);
    b.setCollisionShape(forms[random() % 6]);
    auto pose = [&] {
      btQuaternion q(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(0.1F, 1));
      return btTransform(q.normalized(),
                         btVector3(uniform(-1.5F, 1.5F), uniform(-1.5F, 1.5F), uniform(-1.5F, 1.5F)));
    };
    a.setWorldTransform(pose());
    b.setWorldTransform(pose());
    const bool claim = btHybridIsSeparated(a.getCollisionShape(), a.getWorldTransform(),
                                           b.getCollisionShape(), b.getWorldTransform(), kGap);
    Nearest nearest;
    w.world.contactPairTest(&a, &b, nearest);
    separated += claim;
    together += !claim;
    if (claim) {
      ASSERT_GT(nearest.distance, kGap - 2e-3F) << "pair " << i;
    } else {
      // Conservative by at most what a box's rounded core hides at its corners.
      ASSERT_LT(nearest.distance, kGap + 0.08F) << "pair " << i;
    }
  }
  EXPECT_GT(separated, 1000);
  EXPECT_GT(together, 1000);
}

}  // namespace
}  // namespace scatter::test
