#include <BulletHybrid/btHybridContactSolver.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>
#include <utility>

#include "../../trials.h"
#include "BulletTestWorld.h"
#include "RandomShapes.h"

namespace scatter::test {
namespace {

template <class Solver>
using SolverWorld = BulletTestWorld<btDiscreteDynamicsWorld, Solver>;
using PlainWorld = SolverWorld<btSequentialImpulseConstraintSolver>;
using WideWorld = SolverWorld<btHybridContactSolver>;

btCompoundShape* brick(auto& world, int perSide, const btVector3& half) {
  auto* compound = world.template shape<btCompoundShape>();
  const btVector3 part(half.x() / static_cast<float>(perSide), half.y(),
                       half.z() / static_cast<float>(perSide));
  auto* box = world.template shape<btBoxShape>(part);
  for (int i = 0; i < perSide * perSide; ++i) {
    const btVector3 place(static_cast<float>(2 * (i % perSide) + 1 - perSide) * part.x(), 0,
                          static_cast<float>(2 * (i / perSide) + 1 - perSide) * part.z());
    compound->addChildShape(btTransform(btQuaternion::getIdentity(), place), box);
  }
  return compound;
}

void setRandomSolverInfo(Random& random, btContactSolverInfo& info) {
  if (random.chance(0.3F)) info.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
  if (random.chance(0.3F)) info.m_solverMode |= SOLVER_DISABLE_VELOCITY_DEPENDENT_FRICTION_DIRECTION;
  if (random.chance(0.2F)) info.m_solverMode &= ~SOLVER_USE_WARMSTARTING;
  info.m_splitImpulse = random.chance(0.7F) ? 1 : 0;
  if (random.chance(0.3F)) info.m_splitImpulsePenetrationThreshold = -0.001F;
  if (random.chance(0.3F)) info.m_globalCfm = random.between(0, 1e-4F);
  if (random.chance(0.3F)) info.m_erp2 = random.between(0.05F, 0.5F);
  if (random.chance(0.3F)) info.m_linearSlop = random.between(-0.002F, 0.002F);
  if (random.chance(0.2F)) info.m_sor = random.between(0.7F, 1.2F);
  info.m_numIterations = 1 + random.index(12);
  if (random.chance(0.2F)) info.m_leastSquaresResidualThreshold = 1e-4F;
}

void setRandomMaterial(Random& random, btRigidBody& body) {
  body.setFriction(random.unit());
  body.setRestitution(random.chance(0.5F) ? random.unit() : 0.0F);
  if (random.chance(0.2F))
    body.setContactStiffnessAndDamping(random.between(1e3F, 1e5F), random.between(10, 1e3F));
  if (random.chance(0.2F)) body.setLinearFactor(btVector3(1, 1, random.chance(0.5F) ? 0.0F : 1.0F));
  if (random.chance(0.2F)) body.setAngularFactor(btVector3(1, 0, 1));
}

/// A body that is thrown at another, which is static, kinematic or free.
template <class World>
std::vector<float> playTwoBodies(std::uint64_t seed) {
  World world;
  Random random(seed);
  setRandomSolverInfo(random, world.world.getSolverInfo());
  const int kind = random.index(3);
  const btVector3 halfA(random.between(0.2F, 1), random.between(0.2F, 1), random.between(0.2F, 1));
  const btVector3 halfB(random.between(0.5F, 2), random.between(0.2F, 1), random.between(0.5F, 2));
  btRigidBody* below = world.add(kind == 0 ? random.between(1, 50) : 0.0F,
                                 brick(world, 1 + random.index(2), halfB), btVector3(0, -halfB.y(), 0));
  if (kind == 0) below->setGravity(btVector3(0, 0, 0));
  if (kind == 1) {
    below->setCollisionFlags(below->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    below->setLinearVelocity(btVector3(random.between(-1, 1), 0, random.between(-1, 1)));
    below->setAngularVelocity(btVector3(0, random.between(-1, 1), 0));
  }
  btRigidBody* above = world.add(random.between(0.5F, 50), brick(world, 1 + random.index(3), halfA),
                                 btVector3(0, halfA.y() - random.between(-0.05F, 0.06F), 0));
  above->setLinearVelocity(btVector3(random.between(-3, 3), random.between(-3, 0), random.between(-3, 3)));
  above->setAngularVelocity(btVector3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)));
  setRandomMaterial(random, *above);
  setRandomMaterial(random, *below);
  if constexpr (std::is_same_v<World, WideWorld>) world.solver.setFrictionClamp(false);
  world.step();
  std::vector<float> state;
  for (const auto& body : world.bodies) {
    for (const btVector3& v : {body->getWorldTransform().getOrigin(), body->getLinearVelocity(),
                               body->getAngularVelocity(), body->getWorldTransform().getBasis()[0]}) {
      for (int axis = 0; axis < 3; ++axis) state.push_back(v[axis]);
    }
  }
  return state;
}

// Only where a speed is within rounding of one at which Bullet decides (to bounce, to follow it with
// friction, to stop iterating) may the two differ.
TEST(ContactSolver, MovesTwoBodiesAsBulletDoes) {
  const int count = trials(2000);
  int moved = 0;
  int differ = 0;
  for (int i = 0; i < count; ++i) {
    const auto seed = static_cast<std::uint64_t>(i) + 1;
    const std::vector<float> plain = playTwoBodies<PlainWorld>(seed);
    const std::vector<float> wide = playTwoBodies<WideWorld>(seed);
    bool isSame = true;
    for (std::size_t k = 0; k < plain.size(); ++k)
      isSame = isSame && std::abs(plain[k] - wide[k]) <= 0.001F * (1 + std::abs(plain[k]));
    differ += isSame ? 0 : 1;
    moved += std::abs(plain[16]) > 0.01F ? 1 : 0;
  }
  EXPECT_GT(moved, count / 3);
  EXPECT_LE(differ, count / 500);
}

/// Ten boxes that fall onto each other, with what a test adds.
template <class World>
struct Heap {
  Heap() {
    world.addGround();
    auto* box = world.template shape<btBoxShape>(btVector3(0.5F, 0.5F, 0.5F));
    for (int i = 0; i < 10; ++i) {
      const auto n = static_cast<float>(i);
      world.add(1 + n, box, btVector3(0.3F * std::sin(n), 0.6F + 1.1F * n, 0.3F * std::cos(n)));
    }
  }

  void steps(int count) {
    for (int i = 0; i < count; ++i) world.step();
  }

  World world;
};

template <class World>
std::vector<std::uint32_t> heapBits(const std::function<void(World&)>& change) {
  Heap<World> heap;
  change(heap.world);
  heap.steps(120);
  return heap.world.bits();
}

// What is Bullet's own business is so bit for bit.
template <class Change>
void expectTheSameBits(Change change) {
  const auto plain = heapBits<PlainWorld>(change);
  const auto wide = heapBits<WideWorld>(change);
  EXPECT_EQ(plain, wide);
  EXPECT_NE(plain, heapBits<PlainWorld>([](auto&) {})) << "the change changes something";
}

TEST(ContactSolver, LeavesRollingFrictionToBullet) {
  expectTheSameBits([](auto& world) {
    for (auto& body : world.bodies) {
      body->setRollingFriction(0.1F);
      body->setSpinningFriction(0.1F);
    }
  });
}

TEST(ContactSolver, LeavesAnisotropicFrictionToBullet) {
  expectTheSameBits([](auto& world) {
    for (auto& body : world.bodies) body->setAnisotropicFriction(btVector3(1, 0.1F, 0.5F));
  });
}

TEST(ContactSolver, LeavesFrictionAnchorsToBullet) {
  expectTheSameBits([](auto& world) {
    for (auto& body : world.bodies)
      body->setCollisionFlags(body->getCollisionFlags() | btCollisionObject::CF_HAS_FRICTION_ANCHOR);
  });
}

TEST(ContactSolver, LeavesOtherOrdersToBullet) {
  for (const int mode : {SOLVER_RANDMIZE_ORDER, SOLVER_INTERLEAVE_CONTACT_AND_FRICTION_CONSTRAINTS})
    expectTheSameBits([mode](auto& world) { world.world.getSolverInfo().m_solverMode |= mode; });
}

/// A chain that hangs and swings, without contacts.
template <class World>
std::vector<std::uint32_t> swingingChain() {
  World world;
  auto* ball = world.template shape<btSphereShape>(0.2F);
  btRigidBody* last = world.add(0, ball, btVector3(0, 10, 0));
  for (int i = 1; i < 8; ++i) {
    btRigidBody* next = world.add(1, ball, btVector3(static_cast<float>(i), 10, 0));
    world.template join<btPoint2PointConstraint>(*last, *next, btVector3(0.5F, 0, 0), btVector3(-0.5F, 0, 0));
    last = next;
  }
  for (int i = 0; i < 120; ++i) world.step();
  return world.bits();
}

TEST(ContactSolver, LeavesJointsToBullet) {
  EXPECT_EQ(swingingChain<PlainWorld>(), swingingChain<WideWorld>());
}

/// Boxes that lie on each other, some with rolling friction, the lowest hanging from the highest.
template <class World>
void joinHeap(Heap<World>& heap) {
  for (std::size_t i = 1; i < heap.world.bodies.size(); i += 3)
    heap.world.bodies[i]->setRollingFriction(0.1F);
  heap.world.template join<btPoint2PointConstraint>(*heap.world.bodies[3], *heap.world.bodies[6],
                                                    btVector3(0, 1, 0), btVector3(0, -1, 0));
  auto* hinge = heap.world.template join<btHingeConstraint>(*heap.world.bodies[8], btVector3(0.5F, 0, 0),
                                                            btVector3(0, 0, 1));
  hinge->setLimit(-1, 1);
}

template <class World>
double heightOfHeap(World& world) {
  double sum = 0;
  for (const auto& body : world.bodies) sum += static_cast<double>(body->getWorldTransform().getOrigin().y());
  return sum;
}

TEST(ContactSolver, SolvesJointsAndBulletsContactsBesideItsOwn) {
  Heap<WideWorld> heap;
  joinHeap(heap);
  bool hadBoth = false;
  for (int i = 0; i < 400; ++i) {
    heap.steps(1);
    const btHybridContactSolverInfo info = heap.world.solver.getContactSolverInfo();
    hadBoth = hadBoth || (info.m_points > 0 && info.m_bulletManifolds > 0);
    for (const auto& body : heap.world.bodies)
      ASSERT_GT(body->getWorldTransform().getOrigin().y(), -0.1F) << "step " << i;
  }
  EXPECT_TRUE(hadBoth);
  const btVector3 hinge = heap.world.bodies[8]->getWorldTransform() * btVector3(0.5F, 0, 0);
  const btVector3 pivotA = heap.world.bodies[3]->getWorldTransform() * btVector3(0, 1, 0);
  const btVector3 pivotB = heap.world.bodies[6]->getWorldTransform() * btVector3(0, -1, 0);
  EXPECT_LT(pivotA.distance(pivotB), 0.02F);
  EXPECT_GT(hinge.y(), 1.0F) << "it hangs where it was put";
  for (const auto& body : heap.world.bodies) EXPECT_LT(body->getLinearVelocity().length(), 0.1F);
}

TEST(ContactSolver, GivesTheSameBitsAgain) {
  EXPECT_EQ(heapBits<WideWorld>([](auto&) {}), heapBits<WideWorld>([](auto&) {}));
}

/// Stacks beside each other in a world of Bullet's own, and how many contacts and groups of islands there
/// were.
std::vector<std::uint32_t> stackBits(int threads, btHybridContactSolverInfo& info) {
  WideWorld world;
  EXPECT_STREQ(world.solver.setNumThreads(threads), nullptr);
  world.world.getSolverInfo().m_minimumSolverBatchSize = 100000;
  world.addGround();
  for (int i = 0; i < 24; ++i)
    world.add(5, brick(world, 4, btVector3(0.5F, 0.25F, 0.5F)),
              btVector3(2 * static_cast<float>(i / 3), 0.3F + 0.6F * static_cast<float>(i % 3), 0));
  world.template join<btPoint2PointConstraint>(*world.bodies[1], *world.bodies[4], btVector3(1, 0, 0),
                                               btVector3(-1, 0, 0));
  for (int i = 0; i < 120; ++i) world.step();
  info = world.solver.getContactSolverInfo();
  return world.bits();
}

TEST(ContactSolver, GivesTheSameBitsOnAnyNumberOfThreads) {
  btHybridContactSolverInfo info;
  const auto one = stackBits(1, info);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(stackBits(threads, info), one) << threads << " threads";
  EXPECT_GT(info.m_points, 256) << "fewer are left to one thread";
  EXPECT_GT(info.m_groups, 2);
}

TEST(ContactSolver, WorksOn1To64Threads) {
  WideWorld world;
  for (const int threads : {0, -1, 65}) EXPECT_STRNE(world.solver.setNumThreads(threads), nullptr);
  EXPECT_EQ(world.solver.getNumThreads(), 1);
}

TEST(ContactSolver, KeepsAStackStandingAndLetsItSleep) {
  for (const bool reduces : {false, true}) {
    WideWorld world;
    if (reduces) world.solver.setContactReduction({});
    world.addGround();
    for (int i = 0; i < 8; ++i)
      world.add(5, brick(world, 4, btVector3(0.5F, 0.25F, 0.5F)),
                btVector3(0, 0.25F + 0.5F * static_cast<float>(i), 0));
    for (int i = 0; i < 300; ++i) world.step();
    for (std::size_t i = 1; i < world.bodies.size(); ++i) {
      const btVector3 place = world.bodies[i]->getWorldTransform().getOrigin();
      EXPECT_NEAR(place.y(), 0.25F + 0.5F * static_cast<float>(i - 1), 0.02F);
      EXPECT_LT(std::hypot(place.x(), place.z()), 0.02F);
      EXPECT_FALSE(world.bodies[i]->isActive()) << "body " << i << " reduced " << reduces;
    }
  }
}

TEST(ContactSolver, KeepsMomentumInAHeapThatExplodes) {
  Heap<WideWorld> heap;
  heap.world.world.removeRigidBody(heap.world.bodies[0].get());
  heap.world.world.setGravity(btVector3(0, 0, 0));
  btVector3 before(0, 0, 0);
  for (auto& body : heap.world.bodies) {
    if (body->isStaticObject()) continue;
    body->setGravity(btVector3(0, 0, 0));
    body->setLinearVelocity((btVector3(0, 5, 0) - body->getWorldTransform().getOrigin()) +
                            btVector3(0.1F, 0, 0));
    before += body->getLinearVelocity() / body->getInvMass();
  }
  heap.steps(200);
  btVector3 after(0, 0, 0);
  for (auto& body : heap.world.bodies) {
    if (!body->isStaticObject()) after += body->getLinearVelocity() / body->getInvMass();
  }
  EXPECT_LT((after - before).length(), 0.002F * before.length() + 0.01F);
}

/// A slab of 144 bricks, friction 0.5, on a slope of a box: how far it slides in two seconds, metres.
template <class World>
float slide(float degrees, const std::function<void(World&)>& change) {
  constexpr float kGravity = 10;
  World world;
  const float angle = degrees * SIMD_RADS_PER_DEG;
  world.add(0, world.template shape<btBoxShape>(btVector3(50, 1, 50)), btVector3(0, -1, 0))->setFriction(1);
  btRigidBody* slab = world.add(20, brick(world, 12, btVector3(1, 0.1F, 1)), btVector3(0, 0.1F, 0));
  slab->setFriction(0.5F);
  slab->setActivationState(DISABLE_DEACTIVATION);
  slab->setGravity(kGravity * btVector3(std::sin(angle), -std::cos(angle), 0));
  change(world);
  for (int i = 0; i < 30; ++i) world.step();
  const float speed = slab->getLinearVelocity().x();
  const float from = slab->getWorldTransform().getOrigin().x();
  for (int i = 0; i < 120; ++i) world.step();
  return slab->getWorldTransform().getOrigin().x() - from - 2 * speed;
}

TEST(ContactSolver, LetsASlabSlideAsTheFormulaSays) {
  for (const float degrees : {28.0F, 30.0F, 35.0F, 45.0F}) {
    const float angle = degrees * SIMD_RADS_PER_DEG;
    const float expected = 0.5F * 10 * (std::sin(angle) - 0.5F * std::cos(angle)) * 2 * 2;
    const float clamped = slide<WideWorld>(degrees, [](WideWorld&) {});
    EXPECT_NEAR(clamped, expected, 0.02F * expected) << degrees;
    const float reduced =
        slide<WideWorld>(degrees, [](WideWorld& world) { world.solver.setContactReduction({}); });
    EXPECT_NEAR(reduced, expected, 0.02F * expected) << degrees;
  }
  EXPECT_LT(slide<WideWorld>(25, [](WideWorld&) {}), 0.01F) << "the cone is 26.6 degrees";
  EXPECT_LT(slide<WideWorld>(30, [](WideWorld& world) { world.solver.setFrictionClamp(false); }), 1.3F)
      << "without the clamp it sticks, as in Bullet";
  EXPECT_LT(slide<PlainWorld>(30, [](PlainWorld&) {}), 1.3F) << "1.35 m is right";
}

TEST(ContactSolver, CountsWhatItSolves) {
  Heap<WideWorld> heap;
  heap.steps(100);
  const btHybridContactSolverInfo info = heap.world.solver.getContactSolverInfo();
  int points = 0;
  for (int i = 0; i < heap.world.dispatcher.getNumManifolds(); ++i)
    points += heap.world.dispatcher.getManifoldByIndexInternal(i)->getNumContacts();
  EXPECT_EQ(info.m_points, points);
  EXPECT_GT(info.m_pairs, 5);
  EXPECT_GE(4 * info.m_rows, info.m_points);
  EXPECT_LE(info.m_rows, info.m_points);
  EXPECT_EQ(info.m_bulletManifolds, 0);
}

TEST(ContactReduction, LeavesOutContactsOnlyWhileTheSolverWorks) {
  SolverWorld<btHybridContactReduction> world;
  world.addGround();
  btRigidBody* slab = world.add(20, brick(world, 6, btVector3(1, 0.1F, 1)), btVector3(0, 0.1F, 0));
  for (int i = 0; i < 60; ++i) world.step();
  const btHybridContactReductionCount count = world.solver.getCount();
  EXPECT_EQ(count.m_pairs, 1);
  EXPECT_GE(count.m_contacts, 100);
  EXPECT_EQ(count.m_left, 8);
  int bearing = 0;
  double impulse = 0;
  for (int i = 0; i < world.dispatcher.getNumManifolds(); ++i) {
    btPersistentManifold& manifold = *world.dispatcher.getManifoldByIndexInternal(i);
    for (int k = 0; k < manifold.getNumContacts(); ++k) {
      EXPECT_LT(std::abs(manifold.getContactPoint(k).getDistance()), 0.01F) << "it is where it was";
      bearing += manifold.getContactPoint(k).m_appliedImpulse > 0 ? 1 : 0;
      impulse += static_cast<double>(manifold.getContactPoint(k).m_appliedImpulse);
    }
  }
  EXPECT_LE(bearing, 8);
  EXPECT_NEAR(impulse, 20 * 10.0 / 60, 0.05);
  EXPECT_NEAR(slab->getWorldTransform().getOrigin().y(), 0.1F, 0.005F);
}

/// Remembers which contacts it has been shown.
class WatchingSolver : public btSequentialImpulseConstraintSolver {
 public:
  std::set<const btManifoldPoint*> shown;

  btScalar solveGroup(btCollisionObject** objects, int numObjects, btPersistentManifold** manifolds,
                      int numManifolds, btTypedConstraint** joints, int numJoints,
                      const btContactSolverInfo& info, btIDebugDraw* drawer,
                      btDispatcher* dispatcher) override {
    for (int i = 0; i < numManifolds; ++i) {
      for (int k = 0; k < manifolds[i]->getNumContacts(); ++k) {
        const btManifoldPoint& point = manifolds[i]->getContactPoint(k);
        if (point.getDistance() < 1) shown.insert(&point);
      }
    }
    return btSequentialImpulseConstraintSolver::solveGroup(objects, numObjects, manifolds, numManifolds,
                                                           joints, numJoints, info, drawer, dispatcher);
  }
};

// Contacts that come and go make a stack tremble.
TEST(ContactReduction, KeepsTheSameContactsOfWhatRests) {
  WatchingSolver watching;
  btHybridContactReduction reduction(&watching);
  PlainWorld world;
  world.world.setConstraintSolver(&reduction);
  world.addGround();
  for (int i = 0; i < 6; ++i)
    world
        .add(5, brick(world, 6, btVector3(1, 0.1F, 1)), btVector3(0, 0.1F + 0.2F * static_cast<float>(i), 0))
        ->setActivationState(DISABLE_DEACTIVATION);
  for (int i = 0; i < 60; ++i) world.step();
  std::size_t shown = 0;
  double changes = 0;
  for (int i = 0; i < 120; ++i) {
    const auto before = std::exchange(watching.shown, {});
    world.step();
    shown += watching.shown.size();
    for (const btManifoldPoint* point : watching.shown) changes += before.contains(point) ? 0 : 1;
  }
  EXPECT_GT(shown, 120U * 40U);
  // If only those that bore something were preferred, a fifth would be others than a step before.
  EXPECT_LT(changes, 0.15 * static_cast<double>(shown));
  world.world.setConstraintSolver(&world.solver);
}

TEST(ContactReduction, KeepsContactsThatTheProgramHasSetUp) {
  SolverWorld<btHybridContactReduction> world;
  world.addGround();
  btRigidBody* slab = world.add(20, brick(world, 6, btVector3(1, 0.1F, 1)), btVector3(0, 0.1F, 0));
  slab->setContactStiffnessAndDamping(1e5F, 1e3F);
  for (int i = 0; i < 30; ++i) world.step();
  EXPECT_EQ(world.solver.getCount().m_contacts, 0);
}

TEST(ContactReduction, IsTheSameBitsWhereNoTwoBodiesHaveManyContacts) {
  EXPECT_EQ(heapBits<PlainWorld>([](auto&) {}),
            heapBits<SolverWorld<btHybridContactReduction>>([](auto&) {}));
}

}  // namespace
}  // namespace scatter::test
