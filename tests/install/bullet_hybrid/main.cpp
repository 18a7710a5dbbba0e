#include <BulletHybrid/btHybridDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <cstdio>

// One body of two levels falls onto another and becomes coarse on its way.
int main() {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btHybridDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  btSphereShape fine(0.5F);
  btBoxShape coarse({0.5F, 0.5F, 0.5F});
  btHybridLevelSet levels;
  levels.addLevel(&coarse);
  levels.addLevel(&fine);
  btStaticPlaneShape plane({0, 1, 0}, 0);
  btRigidBody ground(0, nullptr, &plane);
  btHybridRigidBody lower({1, nullptr, nullptr, {0.1F, 0.1F, 0.1F}}, &levels);
  btHybridRigidBody upper({1, nullptr, nullptr, {0.1F, 0.1F, 0.1F}}, &levels);
  lower.setWorldTransform(btTransform(btQuaternion::getIdentity(), {0, 0.5F, 0}));
  upper.setWorldTransform(btTransform(btQuaternion::getIdentity(), {0, 3, 0}));
  for (btRigidBody* body : {&ground, static_cast<btRigidBody*>(&lower), static_cast<btRigidBody*>(&upper)}) {
    world.addRigidBody(body);
  }
  std::printf("level %d of %d\n", upper.getLevel(), upper.getFinestLevel());
  for (int frame = 0; frame < 50; ++frame) {
    world.stepSimulation(1.0F / 60, 0, 1.0F / 60);
  }
  const double height = upper.getWorldTransform().getOrigin().y();
  std::printf("level %d of %d at a height of %.1f\n", upper.getLevel(), upper.getFinestLevel(), height);
  for (btRigidBody* body : {static_cast<btRigidBody*>(&upper), static_cast<btRigidBody*>(&lower), &ground}) {
    world.removeRigidBody(body);
  }
}
