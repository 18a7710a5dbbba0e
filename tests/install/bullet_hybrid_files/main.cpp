#include <BulletHybrid/btHybridDynamicsWorld.h>
#include <BulletHybridFiles/btHybridModel.h>
#include <btBulletDynamicsCommon.h>

#include <cstdio>

// Two bodies of the level file that is the argument fly toward each other.
int main(int argc, char** argv) {
  btHybridModel ship;  // owns shapes and levels, which both bodies share
  if (const char* mistake = ship.load(argc > 1 ? argv[1] : nullptr)) {
    std::printf("%s\n", mistake);
    return 1;
  }
  std::printf("%s: %d levels, %.0f kg\n", ship.getName(), ship.getLevels().getNumLevels(),
              static_cast<double>(ship.getMass()));

  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btHybridDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity({0, 0, 0});
  // Where the model's frame is; the construction info shifts it to the centre of mass.
  const btTransform left(btQuaternion::getIdentity(), {-4, 0, 0});
  const btTransform right(btQuaternion(btVector3(0, 1, 0), SIMD_PI), {4, 0, 0});
  btHybridRigidBody one(ship.getConstructionInfo(left), &ship.getLevels());
  btHybridRigidBody other(ship.getConstructionInfo(right), &ship.getLevels());
  one.setLinearVelocity({3, 0, 0});
  other.setLinearVelocity({-3, 0, 0});
  world.addRigidBody(&one);
  world.addRigidBody(&other);
  int level = 0;
  for (int frame = 0; frame < 60; ++frame) {
    world.stepSimulation(1.0F / 60, 0, 1.0F / 60);
    if (level == 0 && one.getLinearVelocity().x() < 2.9F) level = world.getPairLevel(&one, &other);
  }
  std::printf("they have met at level %d\n", level);
  world.removeRigidBody(&one);
  world.removeRigidBody(&other);
}
