#include <BulletCollision/CollisionDispatch/btCollisionDispatcherMt.h>
#include <BulletCollision/CollisionDispatch/btCompoundCollisionAlgorithm.h>
#include <LinearMath/btThreads.h>
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "RandomShapes.h"
#include "ScriptedWorld.h"

// Shapes that change while a pair lives, shapes of which Bullet makes something unexpected, and programs that
// reach into the collision detection. Bullet's own algorithms say what is right.

namespace scatter::test {
namespace {

const btVector3 kHalfMetre(0.5F, 0.5F, 0.5F);

btTransform at(const btVector3& position) {
  return btTransform(btQuaternion::getIdentity(), position);
}

/// Turned by 45 degrees about z.
btTransform turnedAt(const btVector3& position) {
  return btTransform(btQuaternion(btVector3(0, 0, 1), SIMD_HALF_PI / 2), position);
}

/// The same bodies in a world with the pair algorithm and in one with Bullet's own. They share their shapes.
class Twins {
 public:
  Twins() {
    for (ScriptedWorld* w : both()) w->world.verifyContacts(0);
  }

  void addHybrid(btCollisionShape* shape, const btTransform& pose) {
    for (ScriptedWorld* w : both()) w->addHybrid(shapes.oneLevel(shape), pose);
  }

  void addOther(btCollisionShape* shape, const btTransform& pose) {
    for (ScriptedWorld* w : both()) w->addOther(1, shape, pose);
  }

  void detect() {
    for (ScriptedWorld* w : both()) w->detect();
  }

  /// What a step does to the pairs, without a step.
  void dispatch() {
    for (ScriptedWorld* w : both()) {
      w->dispatcher.dispatchAllCollisionPairs(w->broadphase.getOverlappingPairCache(),
                                              w->world.getDispatchInfo(), &w->dispatcher);
    }
  }

  int pairs() const { return ours.world.getCollisionCounts().pairs; }
  std::array<ScriptedWorld*, 2> both() { return {&ours, &bullets}; }

  btCompoundShape* compound(std::initializer_list<std::pair<btCollisionShape*, btVector3>> children,
                            bool tree = true) {
    auto* shape = shapes.make<btCompoundShape>(tree);
    for (const auto& [child, position] : children) shape->addChildShape(at(position), child);
    return shape;
  }

  btCompoundShape* cube() { return compound({{shapes.make<btBoxShape>(kHalfMetre), btVector3(0, 0, 0)}}); }

  /// A cube of 1 m. A hull keeps the bounds that it has at its first margin.
  btConvexHullShape* hullCube(float margin) {
    auto* hull = shapes.make<btConvexHullShape>();
    hull->setMargin(margin);
    for (int i = 0; i < 8; ++i) {
      hull->addPoint(
          btVector3((i & 1) != 0 ? 0.5F : -0.5F, (i & 2) != 0 ? 0.5F : -0.5F, (i & 4) != 0 ? 0.5F : -0.5F));
    }
    return hull;
  }

  RandomShapes shapes{1};
  ScriptedWorld ours{true};
  ScriptedWorld bullets{false};
};

/// Both worlds have contacts at the same distances between the same children, `some` or none.
void expectAlike(Twins& twins, bool some) {
  const auto ours = twins.ours.contacts();
  const auto bullets = twins.bullets.contacts();
  EXPECT_EQ(!bullets.empty(), some);
  EXPECT_EQ(ours.size(), bullets.size());
  for (const auto& [pair, contact] : bullets) {
    ASSERT_TRUE(ours.contains(pair)) << "children " << pair[2] << " and " << pair[3];
    EXPECT_NEAR(ours.at(pair).distance, contact.distance, 1e-4F);
  }
}

/// Gives a global of Bullet's a value for as long as it lives.
template <class T>
class Global {
 public:
  Global(T& global, T value) : global_(global), before_(std::exchange(global, value)) {}
  ~Global() { global_ = before_; }
  Global(const Global&) = delete;
  Global& operator=(const Global&) = delete;

 private:
  T& global_;
  T before_;
};

/// A partner gets `odd` as a child, and loses it again. `pairs`: with a child that is no convex part, and has
/// none, Bullet's own algorithm is at work.
void expectContactsGoOn(Twins& twins, btCollisionShape* odd, const btVector3& where, int pairs) {
  btCompoundShape* partner = twins.compound({{twins.hullCube(0.04F), btVector3(0, 0, 0)}});
  twins.addHybrid(twins.cube(), at({0, 0, 0}));
  twins.addOther(partner, turnedAt({0.1F, 1.2F, 0.05F}));
  twins.detect();
  EXPECT_EQ(twins.pairs(), 1);
  expectAlike(twins, true);

  partner->addChildShape(at(where), odd);
  for (int step = 0; step < 2; ++step) {
    twins.detect();
    EXPECT_EQ(twins.pairs(), pairs);
    expectAlike(twins, true);
  }

  partner->removeChildShape(odd);
  twins.detect();
  EXPECT_EQ(twins.pairs(), 1);
  expectAlike(twins, true);
}

class PairShapeChanges : public InBothModes {};
INSTANTIATE_TEST_SUITE_P(Modes, PairShapeChanges, bothModes(), nameOfMode);

TEST_P(PairShapeChanges, AChildThatIsACompoundBringsItsChildren) {
  Twins twins;
  expectContactsGoOn(twins, twins.cube(), {-0.5F, -0.5F, 0}, 1);
}

TEST_P(PairShapeChanges, AChildThatIsAMeshLeavesThePairToBullet) {
  btTriangleMesh mesh;
  mesh.addTriangle(btVector3(-3, -1, -3), btVector3(3, -1, -3), btVector3(0, -1, 3));
  Twins twins;
  expectContactsGoOn(twins, twins.shapes.make<btBvhTriangleMeshShape>(&mesh, true), {0, 0, 0}, 0);
}

// The partner's edge is 0.35 m from the hybrid's face; their bounds overlap.
const btVector3 kBesideAnEdge(1.1F, 1.1F, 0);

TEST_P(PairShapeChanges, AHullGetsAPoint) {
  Twins twins;
  btConvexHullShape* hull = twins.hullCube(0.04F);
  twins.addHybrid(twins.cube(), turnedAt({0, 0, 0}));
  twins.addOther(hull, at(kBesideAnEdge));
  twins.detect();
  EXPECT_EQ(twins.pairs(), 1);
  expectAlike(twins, false);

  hull->addPoint(btVector3(-0.72F, -0.72F, 0));
  twins.detect();
  EXPECT_EQ(twins.pairs(), 1);
  expectAlike(twins, true);
}

TEST_P(PairShapeChanges, AnotherBoxIsMadeInThePlaceOfOne) {
  std::optional<btBoxShape> box(std::in_place, kHalfMetre);
  Twins twins;
  twins.addHybrid(twins.cube(), turnedAt({0, 0, 0}));
  twins.addOther(&*box, at(kBesideAnEdge));
  twins.detect();
  EXPECT_EQ(twins.pairs(), 1);
  expectAlike(twins, false);

  box.emplace(1.52F * kHalfMetre);
  twins.detect();
  EXPECT_EQ(twins.pairs(), 1);
  expectAlike(twins, true);
}

/// The one contact point of a world.
btManifoldPoint onlyPoint(const ScriptedWorld& w) {
  std::vector<btManifoldPoint> points;
  for (int i = 0; i < w.dispatcher.getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *w.dispatcher.getManifoldByIndexInternal(i);
    for (int k = 0; k < manifold.getNumContacts(); ++k) points.push_back(manifold.getContactPoint(k));
  }
  EXPECT_EQ(points.size(), 1U);
  return points.empty() ? btManifoldPoint() : points.front();
}

/// `tip` sinks 5 mm into a board thinner than its margin, which is the hybrid's part or its partner.
void expectBoardAsBullets(btConvexShape* tip, bool isPart) {
  Twins twins;
  auto* board = twins.shapes.make<btBoxShape>(btVector3(1, 0.02F, 1));
  board->setMargin(0.04F);
  const btTransform over = at({0.1F, 0.515F, 0.2F});
  twins.addHybrid(twins.compound({{isPart ? board : tip, btVector3(0, 0, 0)}}),
                  isPart ? at({0, 0, 0}) : over);
  twins.addOther(isPart ? tip : board, isPart ? over : at({0, 0, 0}));
  twins.detect();
  EXPECT_EQ(twins.pairs(), 1);
  const btManifoldPoint ours = onlyPoint(twins.ours);
  const btManifoldPoint bullets = onlyPoint(twins.bullets);
  EXPECT_NEAR(ours.getDistance(), bullets.getDistance(), 1e-5F);
  EXPECT_LT((ours.getPositionWorldOnA() - bullets.getPositionWorldOnA()).length(), 1e-5F);
  EXPECT_LT((ours.getPositionWorldOnB() - bullets.getPositionWorldOnB()).length(), 1e-5F);
}

TEST_P(PairShapeChanges, ABoardIsThinnerThanItsMargin) {
  btSphereShape sphere(0.5F);
  btConvexHullShape spike;
  spike.setMargin(0.01F);
  for (const btVector3& point : {btVector3(0, -0.49F, 0), btVector3(0.5F, 0.5F, 0.5F),
                                 btVector3(-0.5F, 0.5F, 0.4F), btVector3(0, 0.5F, -0.5F)}) {
    spike.addPoint(point);
  }
  for (const bool isPart : {false, true}) {
    SCOPED_TRACE(isPart ? "part" : "partner");
    expectBoardAsBullets(&sphere, isPart);
    expectBoardAsBullets(&spike, isPart);
  }
}

TEST_P(PairShapeChanges, PairsDispatchedByHandSeeAChangeAtOnce) {
  Twins twins;
  btCompoundShape* partner = twins.cube();
  twins.addHybrid(twins.cube(), turnedAt({0, 0, 0}));
  twins.addOther(partner, at(kBesideAnEdge));
  twins.detect();
  expectAlike(twins, false);

  partner->updateChildTransform(0, at({-0.26F, -0.26F, 0}));
  twins.dispatch();
  expectAlike(twins, true);

  partner->updateChildTransform(0, at({5, 5, 0}));
  twins.dispatch();
  expectAlike(twins, false);
}

TEST_P(PairShapeChanges, ADispatchBetweenTwoStepsSeesAChangeAtOnce) {
  RandomShapes shapes(1);
  ScriptedWorld w;
  auto* form = shapes.make<btCompoundShape>();
  auto* partner = shapes.make<btCompoundShape>();
  for (btCompoundShape* shape : {form, partner}) {
    shape->addChildShape(at({0, 0, 0}), shapes.make<btBoxShape>(kHalfMetre));
  }
  btHybridRigidBody hybrid(ScriptedWorld::info(1, form, {0, 0, 0}), &shapes.oneLevel(form));
  btRigidBody other(ScriptedWorld::info(1, partner, kBesideAnEdge));
  hybrid.setWorldTransform(turnedAt({0, 0, 0}));
  for (btRigidBody* body : {static_cast<btRigidBody*>(&hybrid), &other}) w.world.addRigidBody(body);
  w.world.performDiscreteCollisionDetection();
  EXPECT_EQ(w.world.getCollisionMemory().m_pairs, 1);
  EXPECT_EQ(w.dispatcher.getNumManifolds(), 0);

  partner->updateChildTransform(0, at({-0.26F, -0.26F, 0}));
  w.dispatcher.dispatchAllCollisionPairs(w.broadphase.getOverlappingPairCache(), w.world.getDispatchInfo(),
                                         &w.dispatcher);
  EXPECT_EQ(w.dispatcher.getNumManifolds(), 1);
  for (btRigidBody* body : {static_cast<btRigidBody*>(&hybrid), &other}) w.world.removeRigidBody(body);
}

TEST_P(PairShapeChanges, AnotherWorldOnTheDispatcherHasBulletsAlgorithms) {
  RandomShapes shapes(1);
  ScriptedWorld idle;
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld plain(&idle.dispatcher, &broadphase, &solver, &idle.configuration);
  auto* form = shapes.make<btCompoundShape>();
  form->addChildShape(at({0, 0, 0}), shapes.make<btBoxShape>(kHalfMetre));
  btHybridRigidBody hybrid(ScriptedWorld::info(1, form, {0, 0, 0}), &shapes.oneLevel(form));
  btRigidBody other(ScriptedWorld::info(1, form, {0.9F, 0, 0}));
  for (btRigidBody* body : {static_cast<btRigidBody*>(&hybrid), &other}) plain.addRigidBody(body);
  plain.performDiscreteCollisionDetection();
  EXPECT_EQ(idle.world.getCollisionMemory().m_pairs, 0);
  EXPECT_EQ(idle.dispatcher.getNumManifolds(), 1);
  for (btRigidBody* body : {static_cast<btRigidBody*>(&hybrid), &other}) plain.removeRigidBody(body);
}

int processed = 0;

bool countProcessed(btManifoldPoint& /*point*/, void* /*body0*/, void* /*body1*/) {
  ++processed;
  return false;
}

TEST_P(PairShapeChanges, TheProcessedCallbackHearsOfAContactInItsFirstStep) {
  Twins twins;
  twins.addHybrid(twins.compound({{twins.hullCube(0.04F), btVector3(-1.5F, 0, 0)},
                                  {twins.shapes.make<btBoxShape>(kHalfMetre), btVector3(0, 0, 0)},
                                  {twins.shapes.make<btSphereShape>(0.5F), btVector3(1.5F, 0, 0)}}),
                  btTransform(btQuaternion(btVector3(1, 0.3F, 0.1F).normalized(), 0.02F)));
  twins.addOther(twins.shapes.make<btBoxShape>(btVector3(3, 0.5F, 3)), at({0, -0.98F, 0}));
  const Global callback(gContactProcessedCallback, &countProcessed);
  for (int step = 1; step <= 2; ++step) {
    std::array<int, 2> heard{};
    for (std::size_t i = 0; i < 2; ++i) {
      processed = 0;
      twins.both()[i]->detect();
      heard[i] = processed;
    }
    EXPECT_GT(heard[1], 2) << "step " << step;
    EXPECT_EQ(heard[0], heard[1]) << "step " << step;
  }
  expectAlike(twins, true);
}

std::vector<std::pair<const btCollisionShape*, const btCollisionShape*>> asked;
bool answer = true;

bool ask(const btCollisionShape* shape0, const btCollisionShape* shape1) {
  asked.emplace_back(shape0, shape1);
  return answer;
}

/// A compound and a sphere, of which one is the hybrid.
void expectFilterAsBullets(bool hybridFirst, bool hybridIsCompound) {
  Twins twins;
  auto* child = twins.shapes.make<btBoxShape>(kHalfMetre);
  btCollisionShape* compound = twins.compound({{child, btVector3(0, 0, 0)}});
  btCollisionShape* sphere = twins.shapes.make<btSphereShape>(0.5F);
  const btTransform beside = at({0.1F, 0.99F, 0.2F});
  btCollisionShape* shapes[2] = {hybridIsCompound ? compound : sphere, hybridIsCompound ? sphere : compound};
  for (const bool hybrid : {hybridFirst, !hybridFirst}) {
    if (hybrid) {
      twins.addHybrid(shapes[0], at({0, 0, 0}));
    } else {
      twins.addOther(shapes[1], beside);
    }
  }
  for (const bool let : {false, true}) {
    answer = let;
    for (ScriptedWorld* w : twins.both()) {
      asked.clear();
      w->detect();
      EXPECT_EQ(asked, decltype(asked)({{sphere, child}})) << (w == &twins.ours ? "ours" : "Bullet's");
    }
    EXPECT_EQ(twins.pairs(), 1);
    expectAlike(twins, let);
  }
}

TEST_P(PairShapeChanges, TheFilterGetsTheCompoundsChildLast) {
  const Global filter(gCompoundChildShapePairCallback, &ask);
  for (const bool hybridFirst : {true, false}) {
    for (const bool hybridIsCompound : {true, false}) {
      SCOPED_TRACE(std::string(hybridFirst ? "first" : "second") +
                   (hybridIsCompound ? " compound" : " sphere"));
      expectFilterAsBullets(hybridFirst, hybridIsCompound);
    }
  }
}

/// Cubes 1 cm apart, one of the hybrid and one of a compound that keeps no tree: whose bounds are tested in
/// whose frame decides whether they get a contact.
void expectTreelessAsBullets(bool partnerFirst, const btTransform& hybridPose, const btTransform& partnerPose,
                             bool some) {
  Twins twins;
  btCompoundShape* form = twins.compound({{twins.hullCube(0), btVector3(0, 0, 0)}});
  btCompoundShape* partner = twins.compound(
      {{twins.hullCube(0), btVector3(1.01F, 0, 0)}, {twins.hullCube(0), btVector3(0, 3, 0)}}, false);
  if (partnerFirst) twins.addOther(partner, partnerPose);
  twins.addHybrid(form, hybridPose);
  if (!partnerFirst) twins.addOther(partner, partnerPose);
  twins.detect();
  EXPECT_EQ(twins.pairs(), 1);
  expectAlike(twins, some);
}

TEST_P(PairShapeChanges, ACompoundWithoutATreeHasBulletsContacts) {
  expectTreelessAsBullets(false, turnedAt({0, 0, 0}), turnedAt({0, 0, 0}), true);
  expectTreelessAsBullets(true, turnedAt({0, 0, 0}), turnedAt({0, 0, 0}), false);
  // The hybrid's edge meets the face that the partner turns to it.
  const btTransform partner = turnedAt({0, 0, 0});
  const btTransform hybrid = at(partner * btVector3(0.5F - SIMDSQRT12, 0, 0));
  expectTreelessAsBullets(true, hybrid, partner, true);
  expectTreelessAsBullets(false, hybrid, partner, true);
}

TEST_P(PairShapeChanges, AParallelDispatcherRunsBulletsAlgorithms) {
  if (btGetTaskScheduler() == nullptr) btSetTaskScheduler(btGetSequentialTaskScheduler());
  RandomShapes shapes(1);
  auto* form = shapes.make<btCompoundShape>();
  form->addChildShape(at({0, 0, 0}), shapes.make<btBoxShape>(kHalfMetre));
  btHybridRigidBody hybrid(ScriptedWorld::info(1, form, {0, 0, 0}), &shapes.oneLevel(form));
  btRigidBody other(ScriptedWorld::info(1, shapes.make<btSphereShape>(0.5F), {0, 0.99F, 0}));
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcherMt dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btHybridDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  for (btRigidBody* body : {static_cast<btRigidBody*>(&hybrid), &other}) world.addRigidBody(body);
  for (int step = 0; step < 2; ++step) {
    world.performDiscreteCollisionDetection();
    EXPECT_EQ(world.getCollisionCounts().pairs, 0);
    ASSERT_EQ(dispatcher.getNumManifolds(), 1);
    EXPECT_EQ(dispatcher.getManifoldByIndexInternal(0)->getNumContacts(), 1);
  }
  for (btRigidBody* body : {static_cast<btRigidBody*>(&hybrid), &other}) world.removeRigidBody(body);
}

/// A program's own create function, which leaves the work to another.
struct CountingCreate : btCollisionAlgorithmCreateFunc {
  btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                 const btCollisionObjectWrapper* body0,
                                                 const btCollisionObjectWrapper* body1) override {
    ++calls;
    return original->CreateCollisionAlgorithm(info, body0, body1);
  }

  btCollisionAlgorithmCreateFunc* original = nullptr;
  int calls = 0;
};

/// How many pairs have contacts between a compound and a plane, a mesh, and another compound. `prepare` is
/// called once the world is there.
template <class World>
int pairsInContact(btCollisionDispatcher& dispatcher, btCollisionConfiguration& configuration,
                   const std::function<void()>& prepare) {
  btTriangleMesh mesh;
  mesh.addTriangle(btVector3(-3, -0.49F, -3), btVector3(3, -0.49F, -3), btVector3(0, -0.49F, 3));
  RandomShapes shapes(1);
  auto* cube = shapes.make<btCompoundShape>();
  cube->addChildShape(at({0, 0, 0}), shapes.make<btBoxShape>(kHalfMetre));
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  World world(&dispatcher, &broadphase, &solver, &configuration);
  prepare();
  btHybridRigidBody hybrid(ScriptedWorld::info(1, cube, {0, 0, 0}), &shapes.oneLevel(cube));
  btRigidBody compound(ScriptedWorld::info(1, cube, {0, 0.98F, 0}));
  btRigidBody ground(
      ScriptedWorld::info(0, shapes.make<btStaticPlaneShape>(btVector3(0, 1, 0), -0.49F), {0, 0, 0}));
  btRigidBody carpet(ScriptedWorld::info(0, shapes.make<btBvhTriangleMeshShape>(&mesh, true), {0, 0, 0}));
  const std::array<btRigidBody*, 4> bodies{&hybrid, &compound, &ground, &carpet};
  for (btRigidBody* body : bodies) world.addRigidBody(body);
  world.performDiscreteCollisionDetection();
  int inContact = 0;
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    inContact += dispatcher.getManifoldByIndexInternal(i)->getNumContacts() > 0 ? 1 : 0;
  }
  for (btRigidBody* body : bodies) world.removeRigidBody(body);
  return inContact;
}

TEST_P(PairShapeChanges, CreateFunctionsThatAProgramRegistersAfterTheWorldAreUsed) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  std::array<CountingCreate, 2> creates;
  const int types[2] = {STATIC_PLANE_PROXYTYPE, TRIANGLE_MESH_SHAPE_PROXYTYPE};
  const auto prepare = [&] {
    for (std::size_t i = 0; i < 2; ++i) {
      creates[i].original = configuration.getCollisionAlgorithmCreateFunc(COMPOUND_SHAPE_PROXYTYPE, types[i]);
      dispatcher.registerCollisionCreateFunc(COMPOUND_SHAPE_PROXYTYPE, types[i], &creates[i]);
    }
  };
  EXPECT_EQ(pairsInContact<btHybridDynamicsWorld>(dispatcher, configuration, prepare), 3);
  // The ground's plane is near both compounds.
  EXPECT_EQ(creates[0].calls, 2);
  EXPECT_EQ(creates[1].calls, 1);
  EXPECT_EQ(pairsInContact<btDiscreteDynamicsWorld>(dispatcher, configuration, prepare), 3);
  EXPECT_EQ(creates[0].calls, 4);
  EXPECT_EQ(creates[1].calls, 2);
}

/// Leaves something else in the fourth number of its bounds every time, as shapes of Bullet's do that leave
/// there what was in memory.
class UntidySphere : public btSphereShape {
 public:
  using btSphereShape::btSphereShape;
  void getAabb(const btTransform& pose, btVector3& low, btVector3& high) const override {
    btSphereShape::getAabb(pose, low, high);
    low[3] = high[3] = static_cast<float>(++calls_);
  }

 private:
  mutable int calls_ = 0;
};

TEST(ShapeChanges, AreNotSeenInNumbersThatNobodySets) {
  Twins twins;
  twins.addHybrid(twins.cube(), at(btVector3(0, 0, 0)));
  auto* untidy = twins.shapes.make<UntidySphere>(0.2F);
  // Its bounds meet those of the cube, its parts are far from it.
  twins.addOther(twins.compound({{untidy, btVector3(1.5F, 0, 0)}, {untidy, btVector3(0, 1.5F, 0)}}),
                 at(btVector3(0, 0, 0)));
  for (int step = 0; step < 4; ++step) twins.detect();
  EXPECT_EQ(twins.pairs(), 1);
  EXPECT_EQ(twins.ours.world.getCollisionCounts().pairsSkipped, 1);
}

}  // namespace
}  // namespace scatter::test
