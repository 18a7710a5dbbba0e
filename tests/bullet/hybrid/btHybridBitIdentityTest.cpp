#include <BulletHybrid/btHybridDynamicsWorld.h>
#include <gtest/gtest.h>

#include <cmath>

#include "BulletTestWorld.h"

namespace scatter::test {
namespace {

template <class World>
void buildStacks(BulletTestWorld<World>& w) {
  w.addGround();
  auto* box = w.template shape<btBoxShape>(btVector3(0.5F, 0.5F, 0.5F));
  for (int tower = 0; tower < 4; ++tower) {
    for (int level = 0; level < 8; ++level) {
      w.add(1, box, btVector3(tower * 1.3F, 0.5F + level * 1.02F, 0.05F * static_cast<float>(level % 3)));
    }
  }
}

template <class World>
void buildJoints(BulletTestWorld<World>& w) {
  w.addGround();
  auto* link = w.template shape<btCapsuleShape>(btScalar(0.2), btScalar(0.6));
  btRigidBody* previous = w.add(0, w.template shape<btBoxShape>(btVector3(0.2F, 0.2F, 0.2F)), {0, 6, 0});
  for (int i = 0; i < 5; ++i) {
    btRigidBody* next = w.add(1, link, btVector3(1.0F + static_cast<float>(i), 6, 0));
    const btVector3 half(0.5F, 0, 0);
    if (i % 2 == 0) {
      w.template join<btPoint2PointConstraint>(*previous, *next, half, -half);
    } else {
      w.template join<btHingeConstraint>(*previous, *next, half, -half, btVector3(0, 0, 1),
                                         btVector3(0, 0, 1));
    }
    previous = next;
  }
  btTransform frame = btTransform::getIdentity();
  btRigidBody* a = w.add(1, link, {-3, 3, 0});
  btRigidBody* b = w.add(1, link, {-3, 5, 0});
  auto* slider = w.template join<btSliderConstraint>(*a, *b, frame, frame, true);
  slider->setLowerLinLimit(-1);
  slider->setUpperLinLimit(1);
  btTransform up = frame;
  up.setOrigin(btVector3(0, 2, 0));
  w.template join<btGeneric6DofSpring2Constraint>(*b, *w.add(1, link, {-3, 7, 0}), up, frame);
  w.template join<btFixedConstraint>(*a, *w.add(1, link, {-3, 1, 0}), frame, up);
}

template <class World>
void buildCompounds(BulletTestWorld<World>& w) {
  w.addGround();
  auto* cross = w.template shape<btCompoundShape>();
  for (int axis = 0; axis < 3; ++axis) {
    btVector3 half(0.2F, 0.2F, 0.2F);
    half[axis] = 0.8F;
    cross->addChildShape(btTransform::getIdentity(), w.template shape<btBoxShape>(half));
  }
  for (int i = 0; i < 27; ++i) {
    w.add(1, cross,
          btVector3(static_cast<float>(i % 3) * 1.1F, 2 + static_cast<float>(i) * 0.6F,
                    static_cast<float>(i / 3 % 3) * 1.2F));
  }
}

template <class World>
void buildSpheresOnMesh(BulletTestWorld<World>& w) {
  auto mesh = std::make_unique<btTriangleMesh>();
  auto corner = [](int x, int z) {
    return btVector3(static_cast<float>(x), std::sin(static_cast<float>(x * 3 + z * 5)),
                     static_cast<float>(z));
  };
  for (int x = -8; x < 8; ++x) {
    for (int z = -8; z < 8; ++z) {
      mesh->addTriangle(corner(x, z), corner(x, z + 1), corner(x + 1, z));
      mesh->addTriangle(corner(x + 1, z), corner(x, z + 1), corner(x + 1, z + 1));
    }
  }
  w.add(0, w.template shape<btBvhTriangleMeshShape>(mesh.get(), true), {0, 0, 0});
  w.meshes.push_back(std::move(mesh));
  auto* sphere = w.template shape<btSphereShape>(btScalar(0.4));
  for (int i = 0; i < 40; ++i) {
    w.add(1, sphere,
          btVector3(static_cast<float>(i % 7) - 3, 3 + static_cast<float>(i) * 0.3F,
                    static_cast<float>(i % 5) - 2));
  }
}

template <class World>
void buildMixedHulls(BulletTestWorld<World>& w) {
  w.addGround();
  auto* hull = w.template shape<btConvexHullShape>();
  for (int i = 0; i < 12; ++i) {
    const float t = static_cast<float>(i);
    hull->addPoint(btVector3(std::cos(t), 0.5F * std::sin(3 * t), std::sin(t)));
  }
  auto* cylinder = w.template shape<btCylinderShape>(btVector3(0.5F, 0.4F, 0.5F));
  auto* cone = w.template shape<btConeShape>(btScalar(0.5), btScalar(1));
  btCollisionShape* forms[] = {hull, cylinder, cone};
  for (int i = 0; i < 30; ++i) {
    btRigidBody* body = w.add(
        1, forms[i % 3], btVector3(0.2F * static_cast<float>(i % 4), 1.5F + 1.1F * static_cast<float>(i), 0));
    body->setAngularVelocity(btVector3(1, static_cast<float>(i % 5), 0));
    body->setRestitution(0.3F);
  }
}

template <class World>
void buildFastWithCcd(BulletTestWorld<World>& w) {
  buildStacks(w);
  auto* bullet = w.template shape<btSphereShape>(btScalar(0.1));
  for (int i = 0; i < 5; ++i) {
    btRigidBody* body = w.add(0.5F, bullet, btVector3(-20, 1.0F + static_cast<float>(i), 0));
    body->setLinearVelocity(btVector3(200, 0, 0));
    body->setCcdMotionThreshold(0.1F);
    body->setCcdSweptSphereRadius(0.08F);
  }
}

template <class World>
void removeSome(BulletTestWorld<World>& w, int step) {
  if (step < 100 || step % 40 != 0) return;
  const auto index = static_cast<std::size_t>(1 + (step / 40) % (static_cast<int>(w.bodies.size()) - 1));
  btRigidBody* body = w.bodies[index].get();
  if (body->getWorldArrayIndex() >= 0) {
    w.world.removeRigidBody(body);
  } else {
    w.world.addRigidBody(body);
    body->activate(true);
  }
}

struct Case {
  const char* name;
  void (*plain)(BulletTestWorld<btDiscreteDynamicsWorld>&);
  void (*hybrid)(BulletTestWorld<btHybridDynamicsWorld>&);
  bool removal;
};

class BitIdentity : public testing::TestWithParam<Case> {};

TEST_P(BitIdentity, WorldWithoutHybridsEqualsPlainBulletForAThousandSteps) {
  BulletTestWorld<btDiscreteDynamicsWorld> plain;
  BulletTestWorld<btHybridDynamicsWorld> hybrid;
  GetParam().plain(plain);
  GetParam().hybrid(hybrid);
  const auto start = plain.bits();
  for (int step = 0; step < 1000; ++step) {
    if (GetParam().removal) {
      removeSome(plain, step);
      removeSome(hybrid, step);
    }
    plain.step();
    hybrid.step();
    ASSERT_EQ(plain.bits(), hybrid.bits()) << "first diverged at step " << step;
  }
  EXPECT_NE(start, plain.bits()) << "nothing moved, so nothing was compared";
}

TEST(BitIdentityScenes, SleepingSceneReallyFallsAsleep) {
  BulletTestWorld<btHybridDynamicsWorld> w;
  buildStacks(w);
  for (int step = 0; step < 1000; ++step) w.step();
  int asleep = 0;
  for (const auto& body : w.bodies) asleep += body->getActivationState() == ISLAND_SLEEPING;
  EXPECT_GT(asleep, 16);
}

#define SCATTER_CASE(name, removal)                                                              \
  Case {                                                                                         \
#name, build##name < btDiscreteDynamicsWorld>, build##name < btHybridDynamicsWorld>, removal \
  }
INSTANTIATE_TEST_SUITE_P(Scenes, BitIdentity,
                         testing::Values(SCATTER_CASE(Stacks, false), SCATTER_CASE(Joints, false),
                                         SCATTER_CASE(Compounds, false), SCATTER_CASE(SpheresOnMesh, false),
                                         SCATTER_CASE(MixedHulls, false), SCATTER_CASE(FastWithCcd, false)),
                         [](const auto& instance) { return instance.param.name; });
INSTANTIATE_TEST_SUITE_P(WithRemoval, BitIdentity,
                         testing::Values(SCATTER_CASE(Compounds, true), SCATTER_CASE(Stacks, true)),
                         [](const auto& instance) { return instance.param.name; });
#undef SCATTER_CASE

}  // namespace
}  // namespace scatter::test
