#include <BulletHybrid/btHybridDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <cstdio>

// One body rests, another of two levels falls onto it and becomes coarse on its way.
int main() {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btHybridDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  btSphereShape fine(btScalar(0.5));
  btBoxShape coarse(btVector3(btScalar(0.5), btScalar(0.5), btScalar(0.5)));
  btHybridLevelSet levels;
  levels.addLevel(&coarse);
  levels.addLevel(&fine);
  btHybridRigidBody lower({btScalar(0), nullptr, nullptr}, &levels);
  btHybridRigidBody upper({btScalar(1), nullptr, nullptr, btVector3(1, 1, 1)}, &levels);
  upper.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 3, 0)));
  world.addRigidBody(&lower);
  world.addRigidBody(&upper);
  world.requestLevel(&upper, 1);
  std::printf("level %d of %d\n", upper.getLevel(), upper.getFinestLevel());
  for (int frame = 0; frame < 120; ++frame) {
    world.stepSimulation(btScalar(1.0 / 60.0), 0, btScalar(1.0 / 60.0));
  }
  std::printf("level %d of %d at a height of %.1f\n", upper.getLevel(), upper.getFinestLevel(),
              static_cast<double>(upper.getWorldTransform().getOrigin().y()));
  world.removeRigidBody(&upper);
  world.removeRigidBody(&lower);
}
