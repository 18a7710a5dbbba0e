#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "HybridTestWorld.h"
#include "LevelReach.h"

namespace scatter::test {
namespace {

/// Bodies of four models in a heap, or far from each other, that turn a little or anyhow, go and come back.
class BoundsTest : public testing::Test {
 protected:
  void build(btHybridSwitchingMode mode, float spread) {
    w_ = std::make_unique<HybridTestWorld>(mode);
    for (btHybridLevelSet& model : models_) ASSERT_EQ(model.addLevel(randomLevel(shapes_)), nullptr);
    for (int i = 0; i < 40; ++i) add(spread);
  }

  void add(float spread) {
    bodies_.push_back(w_->addHybrid(models_[shapes_.random.index(4)], shapes_.random.inCube(spread)));
  }

  void turn() {
    for (btHybridRigidBody* body : bodies_) {
      const bool jumps = shapes_.random.chance(0.02F);
      const btQuaternion by = shapes_.random.rotation(jumps ? 3 : shapes_.random.between(0, 0.02F));
      btTransform pose = body->getWorldTransform();
      pose.setRotation(by * pose.getRotation());
      body->setWorldTransform(pose);
      pose.setRotation(shapes_.random.rotation(0.01F) * pose.getRotation());
      pose.setOrigin(pose.getOrigin() + shapes_.random.inCube(0.05F));
      body->setInterpolationWorldTransform(pose);
    }
  }

  void replaceOne() {
    btHybridRigidBody* body = bodies_[shapes_.random.index(static_cast<int>(bodies_.size()))];
    w_->world.removeRigidBody(body);
    w_->world.addRigidBody(body);
  }

  void expectHeld() {
    for (const btHybridRigidBody* body : bodies_) {
      const btBroadphaseProxy* proxy = body->getBroadphaseHandle();
      const btCollisionShape* shape = body->getLevels().getLevelShape(1);
      for (const btTransform& pose : {body->getWorldTransform(), body->getInterpolationWorldTransform()}) {
        for (int axis = 0; axis < 3; ++axis) {
          btVector3 direction(0, 0, 0);
          direction[axis] = 1;
          EXPECT_GE(proxy->m_aabbMax[axis], reachOf(shape, pose, direction) + margin_);
          EXPECT_LE(proxy->m_aabbMin[axis], -reachOf(shape, pose, -direction) - margin_);
        }
      }
    }
  }

  void run() {
    for (int step = 0; step < 60; ++step) {
      turn();
      if (step % 7 == 0) replaceOne();
      w_->world.updateAabbs();
      w_->world.computeOverlappingPairs();
      expectHeld();
    }
  }

  int countPairs() { return w_->world.getBroadphase()->getOverlappingPairCache()->getNumOverlappingPairs(); }

  RandomShapes shapes_{1};
  btHybridLevelSet models_[4];
  std::unique_ptr<HybridTestWorld> w_;
  std::vector<btHybridRigidBody*> bodies_;
  const btScalar margin_ = 0.0199F;  ///< Contacts begin, and queries of safety look, within 2 cm.
};

TEST_F(BoundsTest, HoldLevelOneInAHeap) {
  build(BT_HYBRID_PAIR_SWITCHING, 2);
  run();
  EXPECT_GT(countPairs(), 40);
}

TEST_F(BoundsTest, HoldLevelOneOfBodiesThatAreApart) {
  build(BT_HYBRID_PAIR_SWITCHING, 40);
  run();
  EXPECT_LT(countPairs(), 20);
}

TEST_F(BoundsTest, HoldLevelOneWhereBodiesSwitch) {
  build(BT_HYBRID_BODY_SWITCHING, 2);
  run();
}

/// Pairs of sixty rods in a heap that have moved for a few steps.
int countPairsOfRods(btHybridSwitchingMode mode) {
  HybridTestWorld w(mode);
  RandomShapes shapes(2);
  btHybridLevelSet rods;
  auto* rod = shapes.make<btConvexHullShape>();
  for (int i = 0; i < 6; ++i) {
    btVector3 point(0, 0, 0);
    point[i / 2] = (i % 2 == 0 ? 1.0F : -1.0F) * (i < 2 ? 1.0F : 0.2F);
    rod->addPoint(point);
  }
  EXPECT_EQ(rods.addLevel(rod), nullptr);
  std::vector<btHybridRigidBody*> bodies;
  for (int i = 0; i < 60; ++i) bodies.push_back(w.addHybrid(rods, btVector3(0, 0, 0)));
  for (int step = 0; step < 4; ++step) {
    for (btHybridRigidBody* body : bodies) {
      const btTransform pose = shapes.random.pose(2.5F);
      body->setWorldTransform(pose);
      body->setInterpolationWorldTransform(pose);
    }
    w.world.updateAabbs();
    w.world.computeOverlappingPairs();
  }
  return w.world.getBroadphase()->getOverlappingPairCache()->getNumOverlappingPairs();
}

// Body switching has Bullet's.
TEST(Bounds, OfAHeapMakeFewerPairsThanBullets) {
  const int fitting = countPairsOfRods(BT_HYBRID_PAIR_SWITCHING);
  EXPECT_GT(fitting, 60);
  EXPECT_LT(fitting, countPairsOfRods(BT_HYBRID_BODY_SWITCHING) * 4 / 5);
}

}  // namespace
}  // namespace scatter::test
