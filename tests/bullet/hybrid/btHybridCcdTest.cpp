#include <gtest/gtest.h>

#include <string>

#include "RandomShapes.h"
#include "ScriptedWorld.h"

namespace scatter::test {
namespace {

enum class Shot { kHybridOfParts, kConvexHybrid, kSphere };

/// Something thrown at a thin wall of parts, up to several of its lengths a step.
class Shooting : public ScriptedWorld {
 public:
  Shooting(bool pairAlgorithm, Shot kind, float speed, bool ccd, bool wallIsHybrid)
      : ScriptedWorld(pairAlgorithm), shapes_(9) {
    addWall(wallIsHybrid);
    // At no speed does it stop in the middle of the wall, where both ways out are as short.
    const btTransform start(btQuaternion::getIdentity(), btVector3(-9.1F, 0.2F, 0.1F));
    switch (kind) {
      case Shot::kHybridOfParts:
        shot_ = addHybrid(shapes_.oneLevel(cross()), start);
        break;
      case Shot::kConvexHybrid:
        shot_ = addHybrid(shapes_.oneLevel(shapes_.hull(0.9F, 20)), start);
        break;
      case Shot::kSphere:
        shot_ = addOther(1, shapes_.make<btSphereShape>(0.4F), start);
        break;
    }
    shot_->setLinearVelocity(btVector3(speed, 0, 0));
    shot_->setInterpolationLinearVelocity(shot_->getLinearVelocity());
    if (ccd) {
      shot_->setCcdMotionThreshold(0.3F);
      shot_->setCcdSweptSphereRadius(0.15F);
    }
    world.getSolverInfo().m_splitImpulse = false;
  }

  void run() {
    for (int i = 0; i < 60; ++i) world.stepSimulation(1.0F / 60, 0);
  }

  bool isThrough() const { return shot_->getWorldTransform().getOrigin().x() > 0.6F; }
  btVector3 end() const { return shot_->getWorldTransform().getOrigin(); }

 private:
  btCompoundShape* cross() {
    auto* shape = shapes_.make<btCompoundShape>();
    for (int axis = 0; axis < 3; ++axis) {
      btVector3 half(0.15F, 0.15F, 0.15F);
      half[axis] = 0.4F;
      shape->addChildShape(btTransform::getIdentity(), shapes_.make<btBoxShape>(half));
    }
    return shape;
  }

  void addWall(bool isHybrid) {
    auto* wall = shapes_.make<btCompoundShape>();
    for (int i = -2; i <= 2; ++i) {
      wall->addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(0, static_cast<float>(i), 0)),
                          shapes_.make<btBoxShape>(btVector3(0.05F, 0.5F, 4)));
    }
    if (!isHybrid) {
      addOther(0, wall, btTransform::getIdentity());
      return;
    }
    btHybridRigidBody* body = addHybrid(shapes_.oneLevel(wall), btTransform::getIdentity());
    world.removeRigidBody(body);
    body->setMassProps(0, btVector3(0, 0, 0));
    world.addRigidBody(body);
  }

  RandomShapes shapes_;
  btRigidBody* shot_ = nullptr;
};

class Ccd : public InBothModes {};
INSTANTIATE_TEST_SUITE_P(Modes, Ccd, bothModes(), nameOfMode);

TEST_P(Ccd, FastBodiesStopWhereTheyStopInPlainBullet) {
  int stopped = 0;
  int through = 0;
  for (const Shot kind : {Shot::kHybridOfParts, Shot::kConvexHybrid, Shot::kSphere}) {
    for (const bool wallIsHybrid : {false, true}) {
      for (const bool ccd : {false, true}) {
        for (const float speed : {30.0F, 70.0F, 110.0F, 150.0F, 205.0F, 300.0F}) {
          const std::string what = "kind " + std::to_string(static_cast<int>(kind)) + ", hybrid wall " +
                                   std::to_string(static_cast<int>(wallIsHybrid)) + ", ccd " +
                                   std::to_string(static_cast<int>(ccd)) + ", speed " + std::to_string(speed);
          Shooting ours(true, kind, speed, ccd, wallIsHybrid);
          Shooting bullets(false, kind, speed, ccd, wallIsHybrid);
          ours.run();
          bullets.run();
          EXPECT_EQ(ours.isThrough(), bullets.isThrough()) << what;
          EXPECT_EQ(ours.report().m_missed, 0) << what;
          (bullets.isThrough() ? through : stopped) += 1;
          // What bounces depends on the order of the contacts, so only free flight must agree to the bit.
          const bool isFree = bullets.report().m_expected == 0;
          EXPECT_TRUE(!isFree || ours.end() == bullets.end()) << what;
          EXPECT_EQ(ours.end().x() < -0.2F, bullets.end().x() < -0.2F) << what;
          // Bullet sweeps convex shapes only.
          EXPECT_FALSE(ccd && kind != Shot::kHybridOfParts && ours.isThrough()) << what;
        }
      }
    }
  }
  // Both happen, so that the comparison says something.
  EXPECT_GT(stopped, 20);
  EXPECT_GT(through, 5);
}

TEST_P(Ccd, TheBoundsOfAContinuousStepMakeNoContacts) {
  for (const bool continuous : {false, true}) {
    Shooting w(true, Shot::kConvexHybrid, 200, true, true);
    w.world.getDispatchInfo().m_useContinuous = continuous;
    w.run();
    EXPECT_EQ(w.report().m_missed, 0);
    EXPECT_EQ(w.report().m_extra, 0);
    EXPECT_EQ(w.isThrough(), !continuous);
  }
}

}  // namespace
}  // namespace scatter::test
