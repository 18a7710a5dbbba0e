#include <BulletHybrid/btHybridDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <cstdio>

// Calls that can be misused return what is wrong, or 0.
static bool isRefused(const char* mistake) {
  if (mistake != nullptr) std::printf("%s\n", mistake);
  return mistake != nullptr;
}

// One body of two levels falls onto another, and goes coarse while it lies on it: nothing moves.
int main() {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btHybridDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  if (isRefused(world.setBudgetMilliseconds(4)) || isRefused(world.addPolicy("contact-time:steps=30")))
    return 1;
  btBoxShape plank({0.5F, 0.1F, 0.5F});
  btCompoundShape detailed;
  detailed.addChildShape(btTransform(btQuaternion::getIdentity(), {0, 0.3F, 0}), &plank);
  detailed.addChildShape(btTransform(btQuaternion::getIdentity(), {0, -0.3F, 0}), &plank);
  btBoxShape box({0.6F, 0.5F, 0.6F});
  btHybridLevelSet levels;
  if (isRefused(levels.addLevel(&box)) || isRefused(levels.addLevel(&detailed))) return 1;
  btStaticPlaneShape plane({0, 1, 0}, 0);
  btRigidBody ground(0, nullptr, &plane);
  btHybridRigidBody lower({1, nullptr, nullptr, {0.1F, 0.1F, 0.1F}}, &levels);
  btHybridRigidBody upper({1, nullptr, nullptr, {0.1F, 0.1F, 0.1F}}, &levels);
  lower.setWorldTransform(btTransform(btQuaternion::getIdentity(), {0, 0.4F, 0}));
  upper.setWorldTransform(btTransform(btQuaternion::getIdentity(), {0, 1.4F, 0}));
  for (btRigidBody* body : {&ground, static_cast<btRigidBody*>(&lower), static_cast<btRigidBody*>(&upper)}) {
    world.addRigidBody(body);
  }
  for (const int level : {2, 1}) {
    world.requestLevel(&upper, level);
    for (int frame = 0; frame < 100; ++frame) {
      world.stepSimulation(1.0F / 60, 0, 1.0F / 60);
    }
    const double height = upper.getWorldTransform().getOrigin().y();
    std::printf("the pair is at level %d, the upper one at a height of %.1f\n",
                world.getPairLevel(&upper, &lower), height);
  }
  for (btRigidBody* body : {static_cast<btRigidBody*>(&upper), static_cast<btRigidBody*>(&lower), &ground}) {
    world.removeRigidBody(body);
  }
}
