#include <BulletHybrid/btHybridDynamicsWorld.h>
#include <BulletHybrid/btHybridInstallation.h>
#include <LinearMath/btThreads.h>
#include <gtest/gtest.h>

#include <BulletCollision/CollisionDispatch/btCollisionDispatcherMt.h>
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>

#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "BulletTestWorld.h"
#include "HybridTestWorld.h"
#include "ScriptedMotion.h"

namespace scatter::test {
namespace {

using ChildPairs = std::set<std::tuple<int, int, int, int>>;

/// Eight hulls and boxes.
btCompoundShape* makeCompound(Random& random, std::vector<std::unique_ptr<btCollisionShape>>& shapes) {
  auto compound = std::make_unique<btCompoundShape>();
  for (int i = 0; i < 8; ++i) {
    if (i % 2 == 0) {
      shapes.push_back(std::make_unique<btBoxShape>(btVector3(0.2F, 0.15F, 0.1F)));
    } else {
      auto hull = std::make_unique<btConvexHullShape>();
      for (int corner = 0; corner < 12; ++corner) hull->addPoint(random.inCube(0.25F));
      shapes.push_back(std::move(hull));
    }
    compound->addChildShape(btTransform(random.rotation(), random.inCube(0.6F)), shapes.back().get());
  }
  btCompoundShape* raw = compound.get();
  shapes.push_back(std::move(compound));
  return raw;
}

/// Of every manifold with points, who is in contact.
template <class World>
ChildPairs childPairsInContact(World& world) {
  ChildPairs found;
  for (int i = 0; i < world.dispatcher.getNumManifolds(); ++i) {
    const btPersistentManifold* manifold = world.dispatcher.getManifoldByIndexInternal(i);
    for (int k = 0; k < manifold->getNumContacts(); ++k) {
      const btManifoldPoint& point = manifold->getContactPoint(k);
      std::tuple pair(manifold->getBody0()->getWorldArrayIndex(), point.m_index0,
                      manifold->getBody1()->getWorldArrayIndex(), point.m_index1);
      if (std::get<0>(pair) > std::get<2>(pair)) {
        pair = {std::get<2>(pair), std::get<3>(pair), std::get<0>(pair), std::get<1>(pair)};
      }
      found.insert(pair);
    }
  }
  return found;
}

/// Ten plain bodies, each with its own compound, two with a bare hull and two with a bare box, on paths of
/// their own.
struct InstalledCrowd {
  InstalledCrowd() : random(11) {
    for (int i = 0; i < 14; ++i) {
      btCollisionShape* shape = makeCompound(random, shapes);
      if (i >= 10) shape = static_cast<btCompoundShape*>(shape)->getChildShape(i < 12 ? 1 : 0);
      for (auto* world : {&own, &bullet}) world->add(1, shape, btVector3(0, 0, 0));
      paths.emplace_back(static_cast<Motion>(i % kMotions), random, 1.0F, 1.5F, btVector3(0, 0, 0));
    }
  }

  void step() {
    for (std::size_t i = 0; i < paths.size(); ++i) {
      const btTransform pose = paths[i].next(random);
      for (auto* world : {&own, &bullet}) world->bodies[i]->setWorldTransform(pose);
    }
    for (auto* world : {&own, &bullet}) world->world.performDiscreteCollisionDetection();
  }

  Random random;
  std::vector<std::unique_ptr<btCollisionShape>> shapes;
  BulletTestWorld<btDiscreteDynamicsWorld> own;
  BulletTestWorld<btDiscreteDynamicsWorld> bullet;
  std::vector<ScriptedMotion> paths;
};

TEST(btHybridInstallation, FindsBulletsContactsForPlainCompounds) {
  InstalledCrowd crowd;
  const btHybridInstallation installation(&crowd.own.dispatcher);
  ASSERT_EQ(installation.getMistake(), nullptr);
  std::size_t seen = 0;
  std::size_t different = 0;
  for (int step = 0; step < 400; ++step) {
    crowd.step();
    const ChildPairs own = childPairsInContact(crowd.own);
    const ChildPairs bullets = childPairsInContact(crowd.bullet);
    seen += bullets.size();
    for (const auto& pair : bullets) different += own.count(pair) == 0 ? 1 : 0;
    for (const auto& pair : own) different += bullets.count(pair) == 0 ? 1 : 0;
  }
  EXPECT_GT(seen, 10000U);
  // Where a distance is that of the threshold, rounding decides.
  EXPECT_LE(different, seen / 10000);
}

// Two boxes, and polyhedra on a plane, are as cheap in Bullet's own algorithms.
TEST(btHybridInstallation, TakesBarePolyhedraWhereThatPays) {
  btBoxShape box(btVector3(0.2F, 0.2F, 0.2F));
  btConvexHullShape hull;
  for (const float x : {-0.2F, 0.2F}) {
    for (const float y : {-0.2F, 0.2F}) {
      for (const float z : {-0.2F, 0.2F}) hull.addPoint(btVector3(x, y, z));
    }
  }
  btSphereShape sphere(0.2F);
  btStaticPlaneShape plane(btVector3(0, 1, 0), 0);
  btTriangleMesh net;
  net.addTriangle({-1, 0, -1}, {0, 0, 1}, {1, 0, -1});
  btBvhTriangleMeshShape mesh(&net, true);
  struct Case {
    btCollisionShape* a;
    btCollisionShape* b;
    bool isTaken;
  };
  const Case cases[]{{&hull, &hull, true},   {&hull, &box, true},    {&box, &box, false},
                     {&hull, &mesh, true},   {&box, &mesh, true},    {&sphere, &mesh, false},
                     {&hull, &plane, false}, {&hull, &sphere, false}};
  for (const Case& pair : cases) {
    for (const bool swapped : {false, true}) {
      BulletTestWorld<btDiscreteDynamicsWorld> world;
      btHybridInstallation installation(&world.dispatcher);
      btCollisionShape* shapes[2] = {pair.a, pair.b};
      for (int i = 0; i < 2; ++i) {
        btCollisionShape* shape = shapes[swapped ? 1 - i : i];
        world.add(shape == &mesh || shape == &plane ? 0.0F : 1.0F, shape,
                  btVector3(0, 0.1F * static_cast<float>(i), 0));
      }
      world.world.performDiscreteCollisionDetection();
      EXPECT_EQ(installation.takeCollisionCounts().pairs, pair.isTaken ? 1 : 0)
          << pair.a->getName() << " and " << pair.b->getName();
      EXPECT_GT(world.dispatcher.getNumManifolds(), 0);
    }
  }
}

TEST(btHybridInstallation, CountsItsWork) {
  InstalledCrowd crowd;
  btHybridInstallation installation(&crowd.own.dispatcher);
  crowd.step();
  const btHybridCollisionCounts counts = installation.takeCollisionCounts();
  EXPECT_GT(counts.pairs, 10);
  EXPECT_GT(counts.childPairs, 50);
  EXPECT_EQ(installation.takeCollisionCounts().pairs, 0);
  EXPECT_EQ(installation.getCollisionMemory().m_pairs, counts.pairs);
}

TEST(btHybridInstallation, TakesItselfBack) {
  InstalledCrowd crowd;
  {
    btHybridInstallation installation(&crowd.own.dispatcher);
    crowd.step();
    EXPECT_GT(installation.takeCollisionCounts().pairs, 0);
  }
  // Pairs that have it keep it, new ones do not get it.
  for (int step = 0; step < 20; ++step) crowd.step();
  btHybridInstallation again(&crowd.own.dispatcher);
  EXPECT_EQ(again.getMistake(), nullptr);
}

TEST(btHybridInstallation, SaysWhyItCannotWork) {
  BulletTestWorld<btDiscreteDynamicsWorld> world;
  const btHybridInstallation first(&world.dispatcher);
  const btHybridInstallation second(&world.dispatcher);
  EXPECT_EQ(first.getMistake(), nullptr);
  ASSERT_NE(second.getMistake(), nullptr);
  EXPECT_NE(std::string(second.getMistake()).find("give every world its own"), std::string::npos);

  if (btGetTaskScheduler() == nullptr) btSetTaskScheduler(btGetSequentialTaskScheduler());
  btCollisionDispatcherMt threads(&world.configuration);
  EXPECT_NE(std::string(btHybridInstallation(&threads).getMistake()).find("use a btCollisionDispatcher"),
            std::string::npos);
  EXPECT_NE(btHybridInstallation(nullptr).getMistake(), nullptr);
}

TEST(btHybridInstallation, NoticesChangesThatBulletCounts) {
  InstalledCrowd crowd;
  const btHybridInstallation installation(&crowd.own.dispatcher);
  for (int step = 0; step < 40; ++step) {
    if (step == 20) {
      auto* compound = static_cast<btCompoundShape*>(crowd.own.bodies[0]->getCollisionShape());
      compound->removeChildShapeByIndex(0);
      compound->setLocalScaling(btVector3(1.2F, 1.2F, 1.2F));
    }
    crowd.step();
    EXPECT_EQ(childPairsInContact(crowd.own), childPairsInContact(crowd.bullet)) << "step " << step;
  }
}

// A robot's links, as PyBullet makes them of a URDF: a base and three links with compounds, on a plane, under
// a few bodies.
struct Robot {
  explicit Robot(bool installs)
      : dispatcher(&configuration), world(&dispatcher, &broadphase, &solver, &configuration) {
    if (installs) installation = std::make_unique<btHybridInstallation>(&dispatcher);
    Random random(5);
    world.setGravity(btVector3(0, -10, 0));
    floor.setCollisionShape(&plane);
    world.addCollisionObject(&floor);
    btCompoundShape* shape = makeCompound(random, shapes);
    btVector3 inertia;
    shape->calculateLocalInertia(1, inertia);
    robot = std::make_unique<btMultiBody>(3, 1.0F, inertia, false, false);
    for (int link = 0; link < 3; ++link) {
      robot->setupRevolute(link, 1, inertia, link - 1, btQuaternion(0, 0, 0, 1), btVector3(0, 0, 1),
                           btVector3(1.6F, 0, 0), btVector3(0, 0, 0), true);
    }
    robot->setBaseWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 3, 0)));
    robot->finalizeMultiDof();
    world.addMultiBody(robot.get());
    for (int link = -1; link < 3; ++link) addCollider(link, shape);
    btAlignedObjectArray<btQuaternion> rotations;
    btAlignedObjectArray<btVector3> positions;
    robot->forwardKinematics(rotations, positions);
    robot->updateCollisionObjectWorldTransforms(rotations, positions);
    for (int i = 0; i < 4; ++i) {
      btRigidBody::btRigidBodyConstructionInfo info(1, nullptr, shape, inertia);
      info.m_startWorldTransform =
          btTransform(btQuaternion::getIdentity(), btVector3(1.2F * static_cast<float>(i), 5, 0));
      bodies.push_back(std::make_unique<btRigidBody>(info));
      world.addRigidBody(bodies.back().get());
    }
  }
  Robot(const Robot&) = delete;
  Robot& operator=(const Robot&) = delete;
  ~Robot() {
    for (auto& body : bodies) world.removeRigidBody(body.get());
    for (auto& collider : colliders) world.removeCollisionObject(collider.get());
    world.removeMultiBody(robot.get());
    world.removeCollisionObject(&floor);
  }

  void addCollider(int link, btCollisionShape* shape) {
    colliders.push_back(std::make_unique<btMultiBodyLinkCollider>(robot.get(), link));
    colliders.back()->setCollisionShape(shape);
    world.addCollisionObject(colliders.back().get(), btBroadphaseProxy::DefaultFilter,
                             btBroadphaseProxy::AllFilter);
    if (link < 0) {
      robot->setBaseCollider(colliders.back().get());
    } else {
      robot->getLink(link).m_collider = colliders.back().get();
    }
  }

  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher;
  btDbvtBroadphase broadphase;
  btMultiBodyConstraintSolver solver;
  btMultiBodyDynamicsWorld world;
  btStaticPlaneShape plane{btVector3(0, 1, 0), 0};
  btCollisionObject floor;
  std::vector<std::unique_ptr<btCollisionShape>> shapes;
  std::unique_ptr<btMultiBody> robot;
  std::vector<std::unique_ptr<btMultiBodyLinkCollider>> colliders;
  std::vector<std::unique_ptr<btRigidBody>> bodies;
  std::unique_ptr<btHybridInstallation> installation;
};

TEST(btHybridInstallation, WorksInAMultiBodyWorld) {
  Robot own(true);
  Robot bullets(false);
  ASSERT_EQ(own.installation->getMistake(), nullptr);
  int meetings = 0;
  bool hasMet = false;
  for (int step = 0; step < 400; ++step) {
    own.world.stepSimulation(1.0F / 60, 0);
    bullets.world.stepSimulation(1.0F / 60, 0);
    meetings += own.installation->takeCollisionCounts().pairs;
    // From the first contact on, the last digits go their own ways.
    if (hasMet) continue;
    ASSERT_EQ(childPairsInContact(own), childPairsInContact(bullets)) << "step " << step;
    hasMet = !childPairsInContact(bullets).empty();
  }
  EXPECT_TRUE(hasMet);
  EXPECT_GT(meetings, 400);
  for (const auto& body : own.bodies) {
    EXPECT_GT(body->getWorldTransform().getOrigin().y(), 0.0F);
    EXPECT_LT(body->getWorldTransform().getOrigin().y(), 4.0F);
  }
}

TEST(btHybridInstallation, WorksInASoftBodyWorld) {
  btSoftBodyRigidBodyCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btSoftRigidDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  btHybridInstallation installation(&dispatcher);
  EXPECT_EQ(installation.getMistake(), nullptr);
  Random random(3);
  std::vector<std::unique_ptr<btCollisionShape>> shapes;
  btCompoundShape* shape = makeCompound(random, shapes);
  std::vector<std::unique_ptr<btRigidBody>> bodies;
  for (int i = 0; i < 3; ++i) {
    bodies.push_back(std::make_unique<btRigidBody>(BulletTestWorld<btDiscreteDynamicsWorld>::info(
        1, shape, btVector3(0, 0.4F * static_cast<float>(i), 0))));
    world.addRigidBody(bodies.back().get());
  }
  world.stepSimulation(1.0F / 60, 0);
  EXPECT_EQ(installation.takeCollisionCounts().pairs, 3);
  EXPECT_GT(dispatcher.getNumManifolds(), 0);
  for (auto& body : bodies) world.removeRigidBody(body.get());
}

// In a hybrid world the same is a setting, and off: without hybrids its results are Bullet's bits.
TEST(btHybridInstallation, IsASettingOfHybridWorlds) {
  BulletTestWorld<btHybridDynamicsWorld> world;
  Random random(3);
  std::vector<std::unique_ptr<btCollisionShape>> shapes;
  btCompoundShape* shape = makeCompound(random, shapes);
  for (int i = 0; i < 3; ++i) world.add(1, shape, btVector3(0, 0.4F * static_cast<float>(i), 0));
  world.world.performDiscreteCollisionDetection();
  EXPECT_EQ(world.world.getCollisionCounts().pairs, 0);
  btHybridCollisionInfo info;
  info.m_plainBodies = true;
  EXPECT_EQ(world.world.setCollisionInfo(info), nullptr);
  world.world.performDiscreteCollisionDetection();
  EXPECT_EQ(world.world.getCollisionCounts().pairs, 3);
  EXPECT_EQ(world.world.getPairStepInfo().pairs, 0) << "none of them switches";
  EXPECT_EQ(world.world.setCollisionInfo(btHybridCollisionInfo()), nullptr);
  world.world.performDiscreteCollisionDetection();
  EXPECT_EQ(world.world.getCollisionCounts().pairs, 0);
}

}  // namespace
}  // namespace scatter::test
