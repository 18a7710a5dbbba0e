#include <BulletHybrid/btHybridInstallation.h>
#include <gtest/gtest.h>

#include <BulletCollision/CollisionDispatch/btInternalEdgeUtility.h>
#include <algorithm>
#include <map>
#include <memory>
#include <string>

#include "../../trials.h"
#include "PairTestWorld.h"
#include "RandomGrounds.h"
#include "ScriptedMotion.h"
#include "ScriptedWorld.h"

namespace scatter::test {
namespace {

class Grounds : public testing::TestWithParam<GroundType> {};

std::string nameOfGround(const testing::TestParamInfo<GroundType>& info) {
  return nameOf(info.param);
}

/// A body of parts that moves over a ground as a script says, and what the verifier finds.
struct Stage {
  Stage(GroundType type, std::uint64_t seed, float length, int parts)
      : shapes(seed), grounds(shapes), size(length) {
    btCompoundShape* compound = shapes.compound(parts, length);
    // Both orders of the two in a pair.
    const bool groundFirst = seed % 2 == 0;
    if (groundFirst) addGround(type);
    body = w.addHybrid(shapes.oneLevel(compound), btTransform::getIdentity());
    if (!groundFirst) addGround(type);
  }

  void addGround(GroundType type) {
    const btTransform pose(shapes.random.rotation(0.5F), shapes.random.inCube(3 * size));
    ground = w.addOther(0, grounds.make(type, size), pose);
  }

  /// `moves`: the ground is carried along a path of its own.
  void run(Motion motion, int steps, bool moves) {
    ScriptedMotion drift(Motion::kDrift, shapes.random, size, 0.2F, ground->getWorldTransform().getOrigin());
    ScriptedMotion path(motion, shapes.random, size, 0.6F, ground->getWorldTransform().getOrigin());
    if (moves) ground->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
    for (int i = 0; i < steps; ++i) {
      if (moves) ScriptedWorld::place(ground, drift.next(shapes.random));
      ScriptedWorld::place(body, path.next(shapes.random));
      w.detect();
    }
  }

  RandomShapes shapes;
  RandomGrounds grounds;
  float size;
  ScriptedWorld w;
  btHybridRigidBody* body = nullptr;
  btRigidBody* ground = nullptr;
};

TEST_P(Grounds, HaveBulletsContacts) {
  long expected = 0;
  long doubtful = 0;
  long errs = 0;
  for (std::uint64_t seed = 1; seed <= 64; ++seed) {
    const float size = seed % 3 == 0 ? 0.2F : seed % 3 == 1 ? 1.0F : 5.0F;
    Stage stage(GetParam(), seed, size, 4 + static_cast<int>(seed % 3) * 12);
    const auto motion = static_cast<Motion>(seed / 2 % kMotions);
    stage.run(motion, 40, seed % 5 == 0);
    const btHybridContactReport& report = stage.w.report();
    EXPECT_EQ(report.m_missed, 0) << "seed " << seed << ", motion " << static_cast<int>(motion);
    EXPECT_EQ(report.m_extra, 0) << "seed " << seed << ", motion " << static_cast<int>(motion);
    expected += report.m_expected;
    doubtful += report.m_doubtful;
    errs += report.m_bulletErrs;
  }
  EXPECT_GT(expected, 1000);
  EXPECT_LT(doubtful, expected / 100);
  // Bullet's GJK does not find every contact of a triangle that has a margin.
  EXPECT_LT(errs, expected / 20);
}

TEST_P(Grounds, HaveBulletsContactsWhateverFindsThem) {
  long expected = 0;
  for (const std::uint64_t seed : seeds(101, 32)) {
    Stage stage(GetParam(), seed, 1.0F, 8);
    btHybridCollisionInfo info = stage.w.world.getCollisionInfo();
    info.m_steps.midphase = seed % 2 == 0 ? BT_HYBRID_WORLD_BOXES : BT_HYBRID_PART_BOXES;
    stage.w.world.setCollisionInfo(info);
    stage.run(static_cast<Motion>(seed / 2 % kMotions), 40, seed % 5 == 0);
    EXPECT_EQ(stage.w.report().m_missed, 0) << "seed " << seed;
    EXPECT_EQ(stage.w.report().m_extra, 0) << "seed " << seed;
    expected += stage.w.report().m_expected;
  }
  EXPECT_GT(expected, trials(500));
}

/// A contact of a part with the ground.
struct Touch {
  float distance;
  btVector3 away;  ///< From the ground.
};

/// Of each part of a body, its deepest contact with the ground, in worlds that are new.
std::map<int, Touch> deepest(const Stage& stage, btCollisionShape* shape, const btTransform& pose,
                             bool installs) {
  BulletTestWorld<btDiscreteDynamicsWorld> world;
  std::unique_ptr<btHybridInstallation> installation;
  if (installs) installation = std::make_unique<btHybridInstallation>(&world.dispatcher);
  btRigidBody* ground = world.add(0, stage.ground->getCollisionShape(), {0, 0, 0});
  btRigidBody* body = world.add(1, shape, {0, 0, 0});
  ground->setWorldTransform(stage.ground->getWorldTransform());
  body->setWorldTransform(pose);
  world.world.performDiscreteCollisionDetection();
  const bool isBareOnTriangles = !shape->isCompound() && ground->getCollisionShape()->isConcave();
  if (installs && isBareOnTriangles) {
    EXPECT_EQ(installation->takeCollisionCounts().pairs,
              world.broadphase.getOverlappingPairCache()->getNumOverlappingPairs());
  }
  std::map<int, Touch> result;
  for (int i = 0; i < world.dispatcher.getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *world.dispatcher.getManifoldByIndexInternal(i);
    const bool isBodyFirst = manifold.getBody0() == body;
    for (int k = 0; k < manifold.getNumContacts(); ++k) {
      const btManifoldPoint& point = manifold.getContactPoint(k);
      const btVector3 normal = point.m_normalWorldOnB;
      const Touch touch{point.getDistance(), isBodyFirst ? normal : -normal};
      const auto [entry, isNew] = result.try_emplace(isBodyFirst ? point.m_index0 : point.m_index1, touch);
      if (!isNew && touch.distance < entry->second.distance) entry->second = touch;
    }
  }
  return result;
}

// How far a shape reaches along a direction in the world, with what its margin rounds.
float reachOf(const btCollisionShape* shape, const btTransform& pose, const btVector3& direction) {
  const auto* convex = static_cast<const btConvexShape*>(shape);
  const btVector3 local = direction * pose.getBasis();
  return direction.dot(pose(convex->localGetSupportVertexWithoutMarginNonVirtual(local))) +
         convex->getMarginNonVirtual();
}

// Whether a part leaves a convex ground when it is moved as its contact says: Bullet may ask for a longer
// way.
bool isWayOut(const Stage& stage, const btTransform& pose, int part, const Touch& touch) {
  const auto* compound = static_cast<const btCompoundShape*>(stage.body->getCollisionShape());
  const float overlap =
      reachOf(compound->getChildShape(part), pose * compound->getChildTransform(part), -touch.away) +
      reachOf(stage.ground->getCollisionShape(), stage.ground->getWorldTransform(), touch.away);
  return overlap <= -touch.distance + 1e-4F;
}

TEST_P(Grounds, NoPartIsShallowerThanInBulletUnlessItsWayOutIsShorter) {
  int compared = 0;
  for (std::uint64_t seed = 101; seed <= 110; ++seed) {
    Stage stage(GetParam(), seed, 1.0F, 16);
    const bool isConvex = stage.ground->getCollisionShape()->isConvex();
    for (int i = 0; i < 20; ++i) {
      const btTransform pose(stage.shapes.random.rotation(),
                             stage.ground->getWorldTransform()(stage.shapes.random.inCube(0.5F)));
      btCollisionShape* shape = stage.body->getCollisionShape();
      const std::map<int, Touch> bullets = deepest(stage, shape, pose, false);
      const std::map<int, Touch> ours = deepest(stage, shape, pose, true);
      for (const auto& [part, touch] : bullets) {
        if (touch.distance > 0.015F) continue;
        ++compared;
        ASSERT_TRUE(ours.contains(part))
            << "seed " << seed << ", pose " << i << ", distance " << touch.distance;
        const Touch& our = ours.at(part);
        const bool isAsDeep = our.distance <= touch.distance + 1e-4F;
        EXPECT_TRUE(isAsDeep || (isConvex && isWayOut(stage, pose, part, our)))
            << "seed " << seed << ", pose " << i << ": " << our.distance << ", Bullet " << touch.distance;
      }
    }
  }
  EXPECT_GT(compared, 200);
}

class Terrains : public testing::TestWithParam<GroundType> {};

TEST_P(Terrains, HaveBulletsContactsWithBareHullsAndBoxes) {
  int compared = 0;
  for (const std::uint64_t seed : seeds(201, 10)) {
    Stage stage(GetParam(), seed, 1.0F, 1);
    for (int i = 0; i < 40; ++i) {
      btCollisionShape* shape = stage.shapes.hull(0.4F, 16);
      if (i % 2 == 0) shape = stage.shapes.make<btBoxShape>(btVector3(0.3F, 0.2F, 0.25F));
      const btTransform pose(stage.shapes.random.rotation(),
                             stage.ground->getWorldTransform()(stage.shapes.random.inCube(0.5F)));
      const std::map<int, Touch> bullets = deepest(stage, shape, pose, false);
      const std::map<int, Touch> ours = deepest(stage, shape, pose, true);
      for (const auto& [part, touch] : bullets) {
        if (touch.distance > 0.015F) continue;
        ++compared;
        ASSERT_TRUE(ours.contains(part)) << "seed " << seed << ", pose " << i;
        EXPECT_LE(ours.at(part).distance, touch.distance + 1e-4F) << "seed " << seed << ", pose " << i;
      }
    }
  }
  EXPECT_GT(compared, trials(100));
}

INSTANTIATE_TEST_SUITE_P(All, Terrains,
                         testing::Values(GroundType::kMesh, GroundType::kScaledMesh,
                                         GroundType::kHeightField),
                         nameOfGround);

/// Blocks of three levels, whose coarser shapes stick out by 10 and 20 cm, on a ground.
struct BlocksOnGround {
  explicit BlocksOnGround(GroundType type) : shapes(3), grounds(shapes) {
    w.world.setGravity(btVector3(0, -10, 0));
    w.add(0, flat(type), {0, type == GroundType::kBox || type == GroundType::kHull ? -1.0F : 0.0F, 0});
    for (int i = 0; i < 4; ++i) {
      blocks.push_back(w.addBlock({3.0F * static_cast<float>(i), 0.52F, 0}));
    }
  }

  btCollisionShape* flat(GroundType type) {
    if (type == GroundType::kBox) return w.shape<btBoxShape>(btVector3(50, 1, 50));
    if (type == GroundType::kPlane) return w.shape<btStaticPlaneShape>(btVector3(0, 1, 0), btScalar(0));
    addFlatNet(mesh, -10, 10);
    return w.shape<btBvhTriangleMeshShape>(&mesh, true);
  }

  [[nodiscard]] btRigidBody* ground() { return w.bodies.front().get(); }

  RandomShapes shapes;
  RandomGrounds grounds;
  btTriangleMesh mesh;
  PairTestWorld w;
  std::vector<btHybridRigidBody*> blocks;
};

class FlatGrounds : public testing::TestWithParam<GroundType> {};

TEST_P(FlatGrounds, BodiesSwitchToTheMiddleLevelAndBackWithoutMoving) {
  BlocksOnGround stage(GetParam());
  stage.w.steps(60);
  for (int round = 0; round < 4; ++round) {
    const int level = round % 2 == 0 ? 1 : 3;
    stage.w.requestAll(level);
    for (int i = 0; i < 60; ++i) {
      stage.w.steps(1);
      for (btHybridRigidBody* block : stage.blocks) {
        EXPECT_NEAR(block->getWorldTransform().getOrigin().y(), 0.5F, 0.003F);
        // It may fall by what rounding leaves under it, as boxes touch only where they overlap; nothing
        // pushes it up.
        EXPECT_LT(block->getLinearVelocity().y(), 0.05F);
        EXPECT_EQ(stage.w.pairInfo().unsafeSwitches, 0);
      }
    }
    for (btHybridRigidBody* block : stage.blocks) {
      EXPECT_EQ(stage.w.levelOf(stage.ground(), block), level == 1 ? 2 : 3)
          << "never the coarsest on a ground";
      EXPECT_FALSE(block->getRequest().isStanding());
    }
  }
}

TEST_P(FlatGrounds, AreKnownToTheGovernor) {
  BlocksOnGround stage(GetParam());
  stage.w.steps(60);
  stage.w.world.setBudgetUnits(1e-3);
  std::vector<int> coarsest(stage.blocks.size(), 3);
  for (int i = 0; i < 60; ++i) {
    stage.w.steps(1);
    for (std::size_t k = 0; k < coarsest.size(); ++k)
      coarsest[k] = std::min(coarsest[k], stage.w.levelOf(stage.ground(), stage.blocks[k]));
  }
  for (std::size_t k = 0; k < coarsest.size(); ++k) {
    // On triangles Bullet's detector has to look at coarse parts that overlap, and fine ones may be the
    // cheaper ones. Elsewhere the governor takes the detail, and may give it back where that saves nothing.
    if (GetParam() != GroundType::kMesh) {
      EXPECT_EQ(coarsest[k], 2);
    }
    EXPECT_GE(coarsest[k], 2);
    EXPECT_NEAR(stage.blocks[k]->getWorldTransform().getOrigin().y(), 0.5F, 0.003F);
  }
  EXPECT_GT(stage.w.pairInfo().units, 1.0);
}

TEST_P(FlatGrounds, KeepBodiesThatFallOnThem) {
  BlocksOnGround stage(GetParam());
  for (std::size_t i = 0; i < stage.blocks.size(); ++i) {
    btTransform pose(btQuaternion(btVector3(1, 1, 0).normalized(), static_cast<float>(i)),
                     btVector3(3.0F * static_cast<float>(i), 4, 0));
    stage.blocks[i]->setWorldTransform(pose);
  }
  stage.w.steps(240);
  for (btHybridRigidBody* block : stage.blocks) EXPECT_GT(block->getWorldTransform().getOrigin().y(), 0.49F);
}

INSTANTIATE_TEST_SUITE_P(All, FlatGrounds,
                         testing::Values(GroundType::kPlane, GroundType::kMesh, GroundType::kBox),
                         nameOfGround);

/// Thin bodies of several parts that come down fast on hills.
struct FastBodies {
  FastBodies(GroundType type, std::uint64_t seed, bool installs) : FastBodies(seed, installs) {
    fall(grounds.make(type, 1.0F));
  }

  FastBodies(std::uint64_t seed, bool installs) : shapes(seed), grounds(shapes) {
    if (installs) installation = std::make_unique<btHybridInstallation>(&w.dispatcher);
  }

  void fall(btCollisionShape* onto) {
    ground = w.add(0, onto, {0, 0, 0});
    for (int i = 0; i < 16; ++i) {
      // Apart from each other, as only the ground is asked about.
      const btVector3 place(4.0F * static_cast<float>(i % 4) - 6, 0, 4.0F * static_cast<float>(i / 4) - 6);
      btRigidBody* body = w.add(1, plate(), place + btVector3(0, shapes.random.between(4.0F, 6.0F), 0));
      body->setWorldTransform(btTransform(shapes.random.rotation(), body->getWorldTransform().getOrigin()));
      body->setLinearVelocity(btVector3(0, -shapes.random.between(5.0F, 40.0F), 0));
      body->setRestitution(0);
    }
  }

  btCompoundShape* plate() {
    auto* compound = w.shape<btCompoundShape>();
    for (int x = -1; x <= 1; ++x) {
      auto* hull = w.shape<btConvexHullShape>();
      for (int k = 0; k < 10; ++k) {
        const btVector3 point = shapes.random.inCube(0.25F) * btVector3(1, 0.3F, 1);
        hull->addPoint(point + btVector3(0.4F * static_cast<float>(x), 0, 0));
      }
      hull->setMargin(0.005F);
      compound->addChildShape(btTransform::getIdentity(), hull);
    }
    return compound;
  }

  /// Of those that still have ground below or above them.
  int countSunken() {
    int sunken = 0;
    for (std::size_t i = 1; i < w.bodies.size(); ++i) {
      const btVector3 middle = w.bodies[i]->getWorldTransform().getOrigin();
      const btVector3 high(middle.x(), 100, middle.z());
      const btVector3 low(middle.x(), -1e5F, middle.z());
      btCollisionWorld::ClosestRayResultCallback hit(high, low);
      btCollisionWorld::rayTestSingle(btTransform(btQuaternion::getIdentity(), high),
                                      btTransform(btQuaternion::getIdentity(), low), ground,
                                      ground->getCollisionShape(), ground->getWorldTransform(), hit);
      sunken += hit.hasHit() && hit.m_hitPointWorld.y() > middle.y() + 0.1F ? 1 : 0;
    }
    return sunken;
  }

  RandomShapes shapes;
  RandomGrounds grounds;
  BulletTestWorld<btDiscreteDynamicsWorld> w;
  std::unique_ptr<btHybridInstallation> installation;
  btRigidBody* ground = nullptr;
};

class Hills : public testing::TestWithParam<GroundType> {};

TEST_P(Hills, HoldFastThinBodiesThatFallThroughThemInBullet) {
  int sunken[2] = {0, 0};
  for (const std::uint64_t seed : seeds(1, 12)) {
    for (const bool installs : {false, true}) {
      FastBodies stage(GetParam(), seed, installs);
      for (int i = 0; i < 120; ++i) stage.w.step();
      sunken[installs ? 1 : 0] += stage.countSunken();
    }
  }
  EXPECT_GT(sunken[0], trials(12) * 16 / 4) << "or this test shows nothing";
  // One that is beyond the ground's bounds after a step is not asked about.
  EXPECT_LE(sunken[1], sunken[0] / 50);
}

// A level net has bounds without a height: what is below it after a step has no pair with it any more.
TEST(MeshGround, HoldsThinBodiesThatComeDownFast) {
  int sunken[2] = {0, 0};
  btTriangleMesh net;
  addFlatNet(net, -12, 12);
  for (const std::uint64_t seed : seeds(1, 12)) {
    for (const bool installs : {false, true}) {
      FastBodies stage(seed, installs);
      stage.fall(stage.w.shape<btBvhTriangleMeshShape>(&net, true));
      for (int i = 0; i < 120; ++i) stage.w.step();
      sunken[installs ? 1 : 0] += stage.countSunken();
    }
  }
  EXPECT_GT(sunken[0], trials(12) * 16 / 4) << "or this test shows nothing";
  EXPECT_EQ(sunken[1], 0);
}

INSTANTIATE_TEST_SUITE_P(All, Hills,
                         testing::Values(GroundType::kMesh, GroundType::kScaledMesh,
                                         GroundType::kHeightField),
                         nameOfGround);

/// Bullet's own mender of contacts with inner edges of a mesh, as a program sets it, and what it is told.
struct EdgeMender {
  static bool added(btManifoldPoint& point, const btCollisionObjectWrapper* body0, int part0, int index0,
                    const btCollisionObjectWrapper* body1, int part1, int index1) {
    const bool isFirst = body0->getCollisionShape()->getShapeType() == TRIANGLE_SHAPE_PROXYTYPE;
    triangles += isFirst || body1->getCollisionShape()->getShapeType() == TRIANGLE_SHAPE_PROXYTYPE ? 1 : 0;
    btAdjustInternalEdgeContacts(point, isFirst ? body0 : body1, isFirst ? body1 : body0,
                                 isFirst ? part0 : part1, isFirst ? index0 : index1);
    lean = std::max(lean, 1 - std::abs(point.m_normalWorldOnB.y()));
    return false;
  }
  static inline int triangles = 0;
  static inline float lean = 0;
};

/// A body of two boxes slides over a net of triangles, whose inner edges a program's callback mends: the most
/// that a normal leans.
float leanOfSlide(bool groundFirst, bool installs) {
  RandomShapes shapes(5);
  btTriangleMesh net;
  addFlatNet(net, -6, 6);
  auto* mesh = shapes.make<btBvhTriangleMeshShape>(&net, true);
  btTriangleInfoMap edges;
  btGenerateInternalEdgeInfo(mesh, &edges);
  BulletTestWorld<btDiscreteDynamicsWorld> world;
  std::unique_ptr<btHybridInstallation> installation;
  if (installs) installation = std::make_unique<btHybridInstallation>(&world.dispatcher);
  auto* compound = shapes.make<btCompoundShape>();
  for (const float x : {-0.3F, 0.3F}) {
    auto* hull = shapes.make<btConvexHullShape>();
    for (int corner = 0; corner < 8; ++corner) {
      hull->addPoint(btVector3((corner & 1) != 0 ? 0.2F : -0.2F, (corner & 2) != 0 ? 0.2F : -0.2F,
                               (corner & 4) != 0 ? 0.2F : -0.2F));
    }
    hull->setMargin(0.01F);
    compound->addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(x, 0, 0)), hull);
  }
  if (groundFirst) world.add(0, mesh, {0, 0, 0});
  btRigidBody* body = world.add(1, compound, {0.03F, 0.209F, 0.01F});
  if (!groundFirst) world.add(0, mesh, {0, 0, 0});
  for (auto& object : world.bodies) {
    object->setCollisionFlags(object->getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
  }
  EdgeMender::triangles = 0;
  EdgeMender::lean = 0;
  gContactAddedCallback = EdgeMender::added;
  body->setLinearVelocity(btVector3(3, 0, 0));
  for (int i = 0; i < 60; ++i) world.step();
  gContactAddedCallback = nullptr;
  EXPECT_GT(EdgeMender::triangles, 20);
  return EdgeMender::lean;
}

TEST(MeshGround, LetsTheProgramsCallbackMendInnerEdges) {
  for (const bool groundFirst : {true, false}) {
    EXPECT_LE(leanOfSlide(groundFirst, true), leanOfSlide(groundFirst, false) + 1e-3F);
  }
}

int countContacts(btDispatcher& dispatcher) {
  int count = 0;
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i)
    count += dispatcher.getManifoldByIndexInternal(i)->getNumContacts();
  return count;
}

TEST(MeshGround, ThatIsReplacedOrScaledStartsAnew) {
  RandomShapes shapes(6);
  RandomGrounds grounds(shapes);
  BulletTestWorld<btDiscreteDynamicsWorld> world;
  btHybridInstallation installation(&world.dispatcher);
  btCollisionShape* hills = grounds.make(GroundType::kHeightField, 1.0F);
  auto* stone = shapes.make<btSphereShape>(0.5F);
  btRigidBody* ground = world.add(0, hills, {0, 0, 0});
  btRigidBody* body = world.add(1, shapes.compound(12, 1.0F), {0, 0, 0});
  body->setActivationState(DISABLE_DEACTIVATION);
  const auto contacts = [&] {
    world.world.performDiscreteCollisionDetection();
    return countContacts(world.dispatcher);
  };
  EXPECT_GT(contacts(), 0);
  ground->setCollisionShape(stone);
  EXPECT_GT(contacts(), 0) << "Bullet's own algorithm";
  body->setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 5, 0)));
  EXPECT_EQ(contacts(), 0);
  ground->setCollisionShape(hills);
  body->setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, 0)));
  EXPECT_GT(contacts(), 0);
  hills->setLocalScaling(btVector3(1, 1e-3F, 1));
  body->setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 1.5F, 0)));
  EXPECT_EQ(contacts(), 0) << "the hills are gone";
}

// What was known of the ground that was there is of no use for another one, a plane above all, which has no
// pieces.
TEST(Ground, ThatIsAPlaneKnowsNothingOfAMeshThatWasThere) {
  PairTestWorld w;
  btTriangleMesh net;
  addFlatNet(net, -6, 6);
  btRigidBody* mesh = w.add(0, w.shape<btBvhTriangleMeshShape>(&net, true), {0, 0, 0});
  btHybridRigidBody* body = w.addBlock({-4, 0.5F, -4});
  w.world.performDiscreteCollisionDetection();
  ASSERT_GT(w.contactsOf(mesh, body), 0);
  w.world.removeRigidBody(mesh);
  w.world.performDiscreteCollisionDetection();
  btRigidBody* plane = w.addGround();
  body->setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(4, 0.495F, 4)));
  w.world.performDiscreteCollisionDetection();
  EXPECT_EQ(w.contactsOf(plane, body), 4) << "one of each box that lies on it";
}

/// Bodies over a net of triangles.
struct BodiesOverNet {
  BodiesOverNet(int half, int count) {
    addFlatNet(net, -half, half);
    auto* mesh = world.shape<btBvhTriangleMeshShape>(&net, true);
    ground = world.add(0, mesh, {0, 0, 0});
    for (int i = 0; i < count; ++i)
      bodies.push_back(world.add(1, shapes.compound(6, 1.0F), {static_cast<btScalar>(i - count / 2), 0, 0}));
  }

  int lookUp() {
    world.world.performDiscreteCollisionDetection();
    return installation.takeCollisionCounts().pieces;
  }
  void clean() {
    btBroadphaseProxy* proxy = ground->getBroadphaseHandle();
    world.broadphase.getOverlappingPairCache()->cleanProxyFromPairs(proxy, &world.dispatcher);
  }

  RandomShapes shapes{3};
  btTriangleMesh net;
  BulletTestWorld<btDiscreteDynamicsWorld> world;
  btHybridInstallation installation{&world.dispatcher};
  btRigidBody* ground = nullptr;
  std::vector<btRigidBody*> bodies;
};

TEST(MeshGround, IsLookedUpOnceForAllBodiesIfItIsSmall) {
  BodiesOverNet small(2, 3);
  EXPECT_EQ(small.lookUp(), 32);
  EXPECT_GT(countContacts(small.world.dispatcher), 0);
  small.bodies[0]->getWorldTransform().getOrigin().setX(1.5F);
  EXPECT_EQ(small.lookUp(), 0);
  small.clean();
  EXPECT_EQ(small.lookUp(), 32);
  BodiesOverNet large(20, 3);
  const int near = large.lookUp();
  EXPECT_GT(near, 0);
  EXPECT_LT(near, 3 * 100) << "of 3200";
}

TEST(MeshGround, WhoseVerticesMovedIsKnownAnewOnceItsPairsAreClean) {
  BodiesOverNet small(2, 3);
  const auto sink = [&](float furthest) {
    const btIndexedMesh& vertices = small.net.getIndexedMeshArray()[0];
    for (int i = 0; i < vertices.m_numVertices; ++i) {
      const unsigned char* place =
          vertices.m_vertexBase + static_cast<std::ptrdiff_t>(i) * vertices.m_vertexStride;
      btVector3& vertex = *reinterpret_cast<btVector3*>(const_cast<unsigned char*>(place));
      if (std::abs(vertex.x()) + std::abs(vertex.z()) <= furthest) vertex.setY(-5);
    }
    auto* mesh = static_cast<btBvhTriangleMeshShape*>(small.ground->getCollisionShape());
    mesh->refitTree(btVector3(-2, -5, -2), btVector3(2, 0, 2));
    small.clean();
    small.lookUp();
  };
  // Its middle, and then all but its corners, by which its bounds stay.
  sink(0.0F);
  ASSERT_GT(countContacts(small.world.dispatcher), 0);
  sink(3.0F);
  EXPECT_EQ(countContacts(small.world.dispatcher), 0);
}

INSTANTIATE_TEST_SUITE_P(All, Grounds, testing::ValuesIn(kGrounds), nameOfGround);

}  // namespace
}  // namespace scatter::test
