// The pair algorithm in a world that is not Scatter's: Featherstone bodies with compounds, as PyBullet makes
// them of a URDF file. Needs Bullet and BulletHybrid alone.
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <BulletHybrid/btHybridInstallation.h>
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>
#include <vector>

namespace {

/// A wheel's rim of hulls, as a convex decomposition of a mesh makes it.
class Rim {
 public:
  explicit Rim(int pieces) {
    const btScalar half = SIMD_PI / static_cast<btScalar>(pieces);
    for (int i = 0; i < pieces; ++i) {
      auto hull = std::make_unique<btConvexHullShape>();
      for (const btScalar radius : {0.35F, 0.5F}) {
        for (const btScalar side : {-half, half}) {
          const btScalar angle = 2 * half * static_cast<btScalar>(i) + side;
          for (const btScalar z : {-0.1F, 0.1F})
            hull->addPoint({radius * std::cos(angle), radius * std::sin(angle), z});
        }
      }
      shape_.addChildShape(btTransform::getIdentity(), hull.get());
      pieces_.push_back(std::move(hull));
    }
  }
  btCompoundShape* shape() { return &shape_; }

 private:
  std::vector<std::unique_ptr<btCollisionShape>> pieces_;
  btCompoundShape shape_;
};

/// Two rims on a hinge: a base and a link.
class Robot {
 public:
  Robot(btMultiBodyDynamicsWorld& world, btCompoundShape* shape, const btTransform& pose) : world_(world) {
    btVector3 inertia;
    shape->calculateLocalInertia(1, inertia);
    body_ = std::make_unique<btMultiBody>(1, 1.0F, inertia, false, false);
    const btQuaternion turned({1, 0, 0}, SIMD_HALF_PI);
    body_->setupRevolute(0, 1, inertia, -1, turned, {0, 1, 0}, {0.6F, 0, 0}, {0, 0, 0}, true);
    body_->setBaseWorldTransform(pose);
    body_->finalizeMultiDof();
    world.addMultiBody(body_.get());
    for (int link = -1; link < 1; ++link) {
      colliders_.push_back(std::make_unique<btMultiBodyLinkCollider>(body_.get(), link));
      btMultiBodyLinkCollider* collider = colliders_.back().get();
      collider->setCollisionShape(shape);
      world.addCollisionObject(collider, btBroadphaseProxy::DefaultFilter, btBroadphaseProxy::AllFilter);
      if (link < 0) {
        body_->setBaseCollider(collider);
      } else {
        body_->getLink(link).m_collider = collider;
      }
    }
    // Or all colliders are at the origin in the first step.
    btAlignedObjectArray<btQuaternion> rotations;
    btAlignedObjectArray<btVector3> positions;
    body_->forwardKinematics(rotations, positions);
    body_->updateCollisionObjectWorldTransforms(rotations, positions);
  }
  void spin(btScalar speed) { body_->setBaseOmega({0, 0, speed}); }

  Robot(const Robot&) = delete;
  Robot& operator=(const Robot&) = delete;
  ~Robot() {
    for (auto& collider : colliders_) world_.removeCollisionObject(collider.get());
    world_.removeMultiBody(body_.get());
  }

 private:
  btMultiBodyDynamicsWorld& world_;
  std::unique_ptr<btMultiBody> body_;
  std::vector<std::unique_ptr<btMultiBodyLinkCollider>> colliders_;
};

/// A chain of robots that reach through each other, the first one turning. Returns the processor time of a
/// second, in milliseconds.
double driftRobots(bool installs) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btMultiBodyConstraintSolver solver;
  btMultiBodyDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity({0, 0, 0});

  std::unique_ptr<btHybridInstallation> installation;
  if (installs) installation = std::make_unique<btHybridInstallation>(&dispatcher);
  if (installation && installation->getMistake() != nullptr) std::puts(installation->getMistake());

  Rim rim(40);
  std::vector<std::unique_ptr<Robot>> robots;
  for (int i = 0; i < 10; ++i) {
    const btVector3 position(1.2F * static_cast<btScalar>(i), 0, 0);
    robots.push_back(
        std::make_unique<Robot>(world, rim.shape(), btTransform(btQuaternion::getIdentity(), position)));
  }
  robots.front()->spin(0.5F);
  std::size_t contacts = 0;
  const std::clock_t start = std::clock();
  for (int step = 0; step < 120; ++step) {
    world.stepSimulation(1.0F / 60, 0);
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
      contacts += static_cast<std::size_t>(dispatcher.getManifoldByIndexInternal(i)->getNumContacts());
    }
  }
  const double milliseconds = 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  std::printf("%s: %.0f ms, %zu contacts\n", installs ? "with the pair algorithm" : "Bullet alone",
              milliseconds, contacts);
  return milliseconds;
}

}  // namespace

int main() {
  const double bullets = driftRobots(false);
  const double own = driftRobots(true);
  std::printf("%.2f of Bullet's time\n", own / bullets);
  return 0;
}
