#include <BulletHybrid/btHybridContactSolver.h>
#include <LinearMath/btThreads.h>
#include <gtest/gtest.h>

#include <atomic>
#include <bit>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <thread>

#include "../../trials.h"
#include "PairTestWorld.h"

// A world gives the same bits for any number of threads: positions, contacts, counts.

namespace scatter::test {
namespace {

/// Ships and blocks that are drawn together until they are a heap, with plain bodies among them.
class Crowd : public PairTestWorld {
 public:
  explicit Crowd(std::uint64_t seed, btHybridSwitchingMode mode = BT_HYBRID_PAIR_SWITCHING)
      : PairTestWorld(mode, seed), shapes_(seed) {
    Random& random = shapes_.random;
    for (int i = 0; i < kBodies; ++i) {
      const btVector3 cell(static_cast<float>(i % 4), static_cast<float>(i / 4 % 4),
                           static_cast<float>(i / 16));
      addBody(i % 4 == 3 ? block : ship, btTransform(random.rotation(), 2.2F * cell));
    }
    for (int i = 0; i < 6; ++i) {
      btCollisionShape* shape = shapes_.compound(5, 1);
      if (i % 3 == 2) shape = shapes_.hull(1, 16);
      btRigidBody* plain = add(1, shape, btVector3(static_cast<float>(i) * 2, -3, 1));
      plain->setActivationState(DISABLE_DEACTIVATION);
    }
    btHybridCollisionInfo info = world.getCollisionInfo();
    info.m_plainBodies = true;
    world.setCollisionInfo(info);
    for (auto& body : bodies) body->setAngularVelocity(random.inCube(2));
  }

  ~Crowd() {
    world.setConstraintSolver(&solver);
    for (auto& body : bodies) {
      if (body->getWorldArrayIndex() >= 0) world.removeRigidBody(body.get());
    }
  }

  /// A net of triangles with hills below, and a large box beside it that leans.
  void addGrounds() {
    const auto at = [](int x, int z) {
      const auto fx = static_cast<float>(x);
      const auto fz = static_cast<float>(z);
      return btVector3(fx, -1 + 0.4F * std::sin(1.3F * fx) * std::cos(0.9F * fz), fz);
    };
    for (int x = -12; x < 18; ++x) {
      for (int z = -12; z < 18; ++z) {
        hills_.addTriangle(at(x, z), at(x, z + 1), at(x + 1, z));
        hills_.addTriangle(at(x + 1, z), at(x, z + 1), at(x + 1, z + 1));
      }
    }
    add(0, shape<btBvhTriangleMeshShape>(&hills_, true), btVector3(0, 0, 0));
    btRigidBody* box = add(0, shape<btBoxShape>(btVector3(60, 1, 60)), btVector3(0, -2, 0));
    box->setWorldTransform(btTransform(btQuaternion(btVector3(0, 0, 1), 0.05F), btVector3(0, -1.6F, 0)));
  }

  /// And a half-space below them.
  void addPlane() { add(0, shape<btStaticPlaneShape>(btVector3(0, 1, 0), -1.2F), btVector3(0, 0, 0)); }

  void useWideSolver() { world.setConstraintSolver(&wide_); }

  /// With joints, and with contacts that are Bullet's own business, besides.
  void solveWide() {
    useWideSolver();
    for (std::size_t i = 0; i + 9 < bodies.size(); i += 16)
      join<btPoint2PointConstraint>(*bodies[i], *bodies[i + 1], btVector3(0, 1, 0), btVector3(0, -1, 0));
    for (std::size_t i = 5; i < bodies.size(); i += 16) bodies[i]->setRollingFriction(0.1F);
  }

  [[nodiscard]] btHybridContactSolverInfo solved() const { return wide_.getContactSolverInfo(); }

  void pull() {
    for (auto& body : bodies)
      body->applyCentralForce((btVector3(3, 3, 3) - body->getWorldTransform().getOrigin()) * 6);
    step();
  }

  /// All that a program could see of a step.
  [[nodiscard]] std::vector<std::uint32_t> all() const {
    std::vector<std::uint32_t> result = bits();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
      const btPersistentManifold& manifold = manifoldAt(i);
      for (int k = 0; k < manifold.getNumContacts(); ++k) {
        const float values[] = {manifold.getContactPoint(k).getDistance(),
                                manifold.getContactPoint(k).m_appliedImpulse};
        for (const float value : values) {
          std::uint32_t word = 0;
          std::memcpy(&word, &value, sizeof word);
          result.push_back(word);
        }
        result.push_back(static_cast<std::uint32_t>(manifold.getContactPoint(k).getLifeTime()));
      }
    }
    const btHybridCollisionCounts counts = world.getCollisionCounts();
    for (const int count : {counts.pairs, counts.pairsSkipped, counts.rebuilds, counts.childPairs,
                            counts.childPairsAsleep, counts.boundsRejected, counts.axisRejected,
                            counts.gjkRuns, counts.gjkIterations, counts.detectorRuns, counts.halfSpaceRuns})
      result.push_back(static_cast<std::uint32_t>(count));
    const btHybridPairStepInfo info = world.getPairStepInfo();
    for (const int count : {info.pairs, info.finestPairs, info.touchingPairs, info.touchingFinest})
      result.push_back(static_cast<std::uint32_t>(count));
    const std::uint64_t units = std::bit_cast<std::uint64_t>(info.units);
    result.push_back(static_cast<std::uint32_t>(units >> 32U));
    result.push_back(static_cast<std::uint32_t>(units));
    return result;
  }

 private:
  static constexpr int kBodies = 48;
  RandomShapes shapes_;
  btTriangleMesh hills_;
  btHybridContactSolver wide_;
};

struct Way {
  const char* name;
  btHybridSwitchingMode mode = BT_HYBRID_PAIR_SWITCHING;
  std::function<void(Crowd&, int step)> act = [](Crowd&, int) {};
};

void PrintTo(const Way& way, std::ostream* out) {
  *out << way.name;
}

class Threads : public testing::TestWithParam<Way> {};

TEST_P(Threads, GiveTheSameBits) {
  for (const std::uint64_t seed : seeds(11, 2)) {
    Crowd one(seed, GetParam().mode);
    std::vector<std::unique_ptr<Crowd>> others;
    for (const int threads : trials<int>({3, 2, 8})) {
      others.push_back(std::make_unique<Crowd>(seed, GetParam().mode));
      ASSERT_STREQ(others.back()->world.setNumThreads(threads), nullptr);
    }
    for (int step = 0; step < 120; ++step) {
      GetParam().act(one, step);
      one.pull();
      for (auto& other : others) {
        GetParam().act(*other, step);
        other->pull();
        ASSERT_EQ(other->all(), one.all())
            << other->world.getNumThreads() << " threads, seed " << seed << ", step " << step;
      }
    }
    EXPECT_GT(one.world.getCollisionCounts().gjkRuns, 50) << "there is work to share";
  }
}

void requestNowAndThen(Crowd& crowd, int step) {
  if (step % 15 == 5) crowd.requestAll(1 + step / 15 % 3);
}

void giveBudgets(Crowd& crowd, int step) {
  if (step % 20 == 10) crowd.world.setBudgetUnits(step % 40 == 10 ? 50 : 1000);
  if (step == 60) crowd.world.addPolicy("proximity");
}

// As little as what lies still in contact can be made do with, and more than it needs.
void giveBudgetsOnGrounds(Crowd& crowd, int step) {
  if (step == 0) {
    crowd.addGrounds();
    crowd.addPlane();
  }
  if (step % 15 == 5) crowd.world.setBudgetUnits(step % 30 == 5 ? 300 : 900);
  for (auto& body : crowd.bodies) body->applyCentralForce(btVector3(0, -30, 0));
}

void recycle(Crowd& crowd, int step) {
  if (step > 0) return;
  btHybridCollisionInfo info = crowd.world.getCollisionInfo();
  info.m_steps.recycling = 0.001F;
  crowd.world.setCollisionInfo(info);
}

void recycleWithBudgets(Crowd& crowd, int step) {
  recycle(crowd, step);
  giveBudgetsOnGrounds(crowd, step);
}

void layGrounds(Crowd& crowd, int step) {
  if (step == 0) crowd.addGrounds();
  for (auto& body : crowd.bodies) body->applyCentralForce(btVector3(0, -30, 0));
  if (step % 40 == 20) crowd.requestAll(1 + step / 40);
}

void searchByWorldBoxes(Crowd& crowd, int step) {
  layGrounds(crowd, step);
  if (step > 0) return;
  btHybridCollisionInfo info = crowd.world.getCollisionInfo();
  info.m_steps.midphase = BT_HYBRID_WORLD_BOXES;
  crowd.world.setCollisionInfo(info);
}

void leaveManifolds(Crowd& crowd, int step) {
  if (step > 0) return;
  btHybridCollisionInfo info = crowd.world.getCollisionInfo();
  info.m_steps.lazyManifolds = false;
  crowd.world.setCollisionInfo(info);
}

void removeAndAdd(Crowd& crowd, int step) {
  btRigidBody* body = crowd.bodies[static_cast<std::size_t>(step) % crowd.bodies.size()].get();
  if (step % 7 == 3) crowd.world.removeRigidBody(body);
  if (step % 7 == 3) crowd.world.addRigidBody(body);
}

void recycleOnGrounds(Crowd& crowd, int step) {
  recycle(crowd, step);
  layGrounds(crowd, step);
}

// So fast that they pass through the hills within a step.
void throwAtGrounds(Crowd& crowd, int step) {
  if (step == 0) crowd.addGrounds();
  if (step % 25 != 5) return;
  for (auto& body : crowd.bodies) body->setLinearVelocity(btVector3(0, -70, 0));
}

void solveWideOnGrounds(Crowd& crowd, int step) {
  if (step == 0) crowd.solveWide();
  layGrounds(crowd, step);
}

// Without joints and grounds it is one island.
void solveWideInAPile(Crowd& crowd, int step) {
  if (step == 0) crowd.useWideSolver();
  recycle(crowd, step);
}

void throwFarAway(Crowd& crowd, int step) {
  if (step % 30 != 20) return;
  btTransform pose = crowd.bodies[5]->getWorldTransform();
  pose.setOrigin(pose.getOrigin() + btVector3(step < 40 ? 1e9F : 3.0F, 0, 0));
  crowd.bodies[5]->setWorldTransform(pose);
}

INSTANTIATE_TEST_SUITE_P(Ways, Threads,
                         testing::Values(Way{.name = "Finest"},
                                         Way{.name = "ByBodies", .mode = BT_HYBRID_BODY_SWITCHING},
                                         Way{.name = "Requests", .act = requestNowAndThen},
                                         Way{.name = "Budgets", .act = giveBudgets},
                                         Way{.name = "BudgetsOnGrounds", .act = giveBudgetsOnGrounds},
                                         Way{.name = "RecycledWithBudgets", .act = recycleWithBudgets},
                                         Way{.name = "Recycled", .act = recycle},
                                         Way{.name = "AllManifolds", .act = leaveManifolds},
                                         Way{.name = "WorldBoxes", .act = searchByWorldBoxes},
                                         Way{.name = "BodiesComeAndGo", .act = removeAndAdd},
                                         Way{.name = "OnGrounds", .act = layGrounds},
                                         Way{.name = "RecycledOnGrounds", .act = recycleOnGrounds},
                                         Way{.name = "ThrownAtGrounds", .act = throwAtGrounds},
                                         Way{.name = "WideOnGrounds", .act = solveWideOnGrounds},
                                         Way{.name = "WideInAPile", .act = solveWideInAPile},
                                         Way{.name = "FarAway", .act = throwFarAway}),
                         [](const auto& way) { return way.param.name; });

// There are islands to be solved beside each other, and some that joints and Bullet's own contacts move too.
TEST(Threads, HaveIslandsToShare) {
  Crowd crowd(11);
  crowd.world.setNumThreads(3);
  int most = 0;
  int points = 0;
  bool hasBullets = false;
  for (int step = 0; step < 120; ++step) {
    solveWideOnGrounds(crowd, step);
    crowd.step();
    const btHybridContactSolverInfo info = crowd.solved();
    most = std::max(most, info.m_groups);
    points = std::max(points, info.m_points);
    hasBullets = hasBullets || info.m_bulletManifolds > 0;
  }
  EXPECT_GT(most, 1);
  EXPECT_GT(points, 256);
  EXPECT_TRUE(hasBullets);
}

/// So many boxes that one island has the contacts from which on threads share its rows and impulses.
class Wall : public PairTestWorld {
 public:
  explicit Wall(int threads) : PairTestWorld(BT_HYBRID_PAIR_SWITCHING, 1) {
    EXPECT_STREQ(world.setNumThreads(threads), nullptr);
    world.setConstraintSolver(&wide_);
    world.setGravity(btVector3(0, -10, 0));
    add(0, shape<btBoxShape>(btVector3(60, 1, 60)), btVector3(0, -1, 0));
    for (int i = 0; i < 900; ++i) {
      const auto across = static_cast<float>(i % 30);
      add(1, shape<btBoxShape>(btVector3(0.5F, 0.5F, 0.5F)),
          btVector3(across, 0.5F + static_cast<float>(i / 30), 0.01F * across));
    }
  }
  ~Wall() { world.setConstraintSolver(&solver); }

  [[nodiscard]] btHybridContactSolverInfo solved() const { return wide_.getContactSolverInfo(); }

 private:
  btHybridContactSolver wide_;
};

TEST(Threads, GiveTheSameBitsToALargePile) {
  Wall one(1);
  Wall many(3);
  for (int step = 0; step < 5; ++step) {
    one.step();
    many.step();
    ASSERT_EQ(many.bits(), one.bits()) << "step " << step;
  }
  EXPECT_GE(many.solved().m_points, 2048) << "there was nothing to share";
  EXPECT_EQ(many.solved().m_groups, 1);
}

// There is a pile, in one group.
TEST(Threads, HaveAPileToShare) {
  Crowd crowd(11);
  crowd.world.setNumThreads(3);
  int points = 0;
  for (int step = 0; step < 120; ++step) {
    solveWideInAPile(crowd, step);
    crowd.pull();
    const btHybridContactSolverInfo info = crowd.solved();
    if (info.m_groups == 1) points = std::max(points, info.m_points);
  }
  EXPECT_GT(points, 256);
}

void handOn(btBroadphasePair& pair, btCollisionDispatcher& dispatcher, const btDispatcherInfo& info) {
  btCollisionDispatcher::defaultNearCallback(pair, dispatcher, info);
}

// Pairs that need nothing of Bullet are not shown to it, but to a program that wants to see them.
void compareWithANearCallback(int threads, int budgetUnits) {
  Crowd one(13);
  Crowd other(13);
  other.dispatcher.setNearCallback(handOn);
  for (Crowd* crowd : {&one, &other}) {
    crowd->world.setPromises(BT_HYBRID_NEAR_CALLBACK_FORWARDS);
    crowd->world.setNumThreads(threads);
    if (budgetUnits > 0) crowd->world.setBudgetUnits(budgetUnits);
  }
  int skipped = 0;
  for (int step = 0; step < 120; ++step) {
    one.pull();
    other.pull();
    ASSERT_EQ(other.all(), one.all()) << threads << " threads, step " << step;
    ASSERT_EQ(one.pairInfo().pairs, other.pairInfo().pairs) << "step " << step;
    skipped += one.world.getCollisionCounts().pairsSkipped;
  }
  EXPECT_GT(skipped, 1000);
}

TEST(Dispatch, GivesTheSameBitsWithANearCallbackOfTheProgram) {
  for (const int threads : {1, 3}) {
    for (const int budgetUnits : {0, 700}) compareWithANearCallback(threads, budgetUnits);
  }
}

/// A program's scheduler: does the work backwards.
class BackwardScheduler : public btITaskScheduler {
 public:
  BackwardScheduler() : btITaskScheduler("backward") {}
  int getMaxNumThreads() const override { return 1; }
  int getNumThreads() const override { return 1; }
  void setNumThreads(int) override {}
  void parallelFor(int begin, int end, int, const btIParallelForBody& body) override {
    ++runs;
    for (int i = end; i-- > begin; ++calls) body.forLoop(i, i + 1);
  }
  btScalar parallelSum(int, int, int, const btIParallelSumBody&) override { return 0; }

  int runs = 0;
  int calls = 0;
};

TEST(Threads, MayBeAProgramsOwn) {
  BackwardScheduler scheduler;
  Crowd one(3);
  Crowd other(3);
  ASSERT_STREQ(other.world.setTaskScheduler(&scheduler), nullptr);
  for (int step = 0; step < 100; ++step) {
    one.pull();
    other.pull();
    ASSERT_EQ(other.all(), one.all()) << "step " << step;
  }
  EXPECT_GT(scheduler.calls, 100);
  ASSERT_STREQ(other.world.setTaskScheduler(nullptr), nullptr);
  const int before = scheduler.calls;
  other.pull();
  EXPECT_EQ(scheduler.calls, before);
}

// A budget takes nothing from them: pairs in contact, and on credit, are looked at beside each other, too.
TEST(Threads, ShareStepsWithABudget) {
  BackwardScheduler scheduler;
  Crowd one(3);
  Crowd other(3);
  ASSERT_STREQ(other.world.setTaskScheduler(&scheduler), nullptr);
  int portions = 0;
  int kept = 0;
  int credited = 0;
  for (int step = 0; step < 120; ++step) {
    const double units = step < 60 ? 1500 : 500;
    one.world.setBudgetUnits(units);
    other.world.setBudgetUnits(units);
    scheduler.runs = 0;
    one.pull();
    other.pull();
    ASSERT_EQ(other.all(), one.all()) << "step " << step;
    portions += std::max(scheduler.runs - 2, 0);
    kept += one.pairInfo().reusedPairs;
    credited += one.pairInfo().creditedPairs;
  }
  EXPECT_GT(portions, 100) << "of pairs in contact, besides what is asked of all pairs, and of those apart";
  EXPECT_GT(kept, 100);
  EXPECT_GT(credited, 100);
}

bool skipsNow = false;

void skipSome(btBroadphasePair& pair, btCollisionDispatcher& dispatcher, const btDispatcherInfo& info) {
  const auto* object = static_cast<const btCollisionObject*>(pair.m_pProxy0->m_clientObject);
  if (skipsNow && object->getWorldArrayIndex() % 3 == 0) return;
  btCollisionDispatcher::defaultNearCallback(pair, dispatcher, info);
}

// What was found out about pairs that a program leaves out is not made use of, and their manifolds do not
// leak.
TEST(Threads, LetAProgramLeavePairsOut) {
  Crowd crowd(5);
  crowd.world.setNumThreads(3);
  crowd.dispatcher.setNearCallback(skipSome);
  for (int step = 0; step < 200; ++step) {
    skipsNow = step % 4 != 0;
    crowd.pull();
  }
  skipsNow = false;
  while (!crowd.bodies.empty()) {
    crowd.world.removeRigidBody(crowd.bodies.back().get());
    crowd.bodies.pop_back();
  }
  EXPECT_EQ(crowd.dispatcher.getNumManifolds(), 0);
}

struct Call {
  std::thread::id thread;
  int bodies[2];
  float distance;
  bool operator==(const Call&) const = default;
};

std::vector<Call> calls;

void note(const btManifoldPoint& point, const void* a, const void* b) {
  const auto at = [](const void* body) {
    return static_cast<const btCollisionObject*>(body)->getWorldArrayIndex();
  };
  calls.push_back({std::this_thread::get_id(), {at(a), at(b)}, point.getDistance()});
}

bool noteProcessed(btManifoldPoint& point, void* a, void* b) {
  note(point, a, b);
  return true;
}

bool noteAdded(btManifoldPoint& point, const btCollisionObjectWrapper* a, int, int,
               const btCollisionObjectWrapper* b, int, int) {
  note(point, a->getCollisionObject(), b->getCollisionObject());
  return false;
}

/// What Bullet's callbacks hear while a crowd comes together.
std::vector<Call> hear(int threads) {
  Crowd crowd(7);
  crowd.world.setNumThreads(threads);
  for (auto& body : crowd.bodies)
    body->setCollisionFlags(body->getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
  calls.clear();
  for (int step = 0; step < 60; ++step) crowd.pull();
  return calls;
}

TEST(Threads, LeaveCallbacksToOneInTheirOrder) {
  gContactProcessedCallback = noteProcessed;
  const std::vector<Call> processed = hear(1);
  EXPECT_GT(processed.size(), 1000U);
  EXPECT_TRUE(hear(3) == processed);
  gContactProcessedCallback = nullptr;
  gContactAddedCallback = noteAdded;
  const std::vector<Call> added = hear(1);
  EXPECT_GT(added.size(), 1000U);
  EXPECT_TRUE(hear(3) == added);
  gContactAddedCallback = nullptr;
}

std::atomic<int> numAdded = 0;

bool countAdded(btManifoldPoint&, const btCollisionObjectWrapper*, int, int, const btCollisionObjectWrapper*,
                int, int) {
  ++numAdded;
  return false;
}

TEST(Threads, MayCallBackAnywhereIfAProgramPromises) {
  gContactAddedCallback = countAdded;
  int counts[2];
  for (const int threads : {1, 3}) {
    numAdded = 0;
    Crowd crowd(7);
    crowd.world.setNumThreads(threads);
    crowd.world.setPromises(BT_HYBRID_NEAR_CALLBACK_FORWARDS | BT_HYBRID_CONTACT_ADDED_ON_ANY_THREAD);
    for (auto& body : crowd.bodies)
      body->setCollisionFlags(body->getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
    for (int step = 0; step < 60; ++step) crowd.pull();
    counts[threads == 1 ? 0 : 1] = numAdded;
  }
  gContactAddedCallback = nullptr;
  EXPECT_GT(counts[0], 1000);
  EXPECT_EQ(counts[0], counts[1]);
}

// A program that leaves pairs out has the same bits too: their contacts stay as they are.
TEST(Threads, LeaveContactsOfPairsThatAreLeftOut) {
  Crowd one(5);
  Crowd other(5);
  other.world.setNumThreads(3);
  for (Crowd* crowd : {&one, &other}) crowd->dispatcher.setNearCallback(skipSome);
  for (int step = 0; step < 100; ++step) {
    skipsNow = step % 4 == 3;
    one.pull();
    other.pull();
    ASSERT_EQ(other.bits(), one.bits()) << "step " << step;
  }
  skipsNow = false;
}

/// A scheduler that says when it is at work.
class NotedScheduler : public BackwardScheduler {
 public:
  void parallelFor(int begin, int end, int grain, const btIParallelForBody& body) override {
    isAtWork = true;
    BackwardScheduler::parallelFor(begin, end, grain, body);
    isAtWork = false;
  }

  static inline bool isAtWork = false;
};

/// A box that counts how often it is asked for its margin while such a scheduler is at work.
class NotedBox : public btBoxShape {
 public:
  using btBoxShape::btBoxShape;
  btScalar getMargin() const override {
    if (NotedScheduler::isAtWork) ++shared;
    return btBoxShape::getMargin();
  }

  static inline int shared = 0;
};

/// A wall of boxes that sways, with a detailed body on it or without.
class Blocks : public PairTestWorld {
 public:
  explicit Blocks(bool hasHybrid) {
    world.setGravity(btVector3(0, -10, 0));
    auto* box = shape<NotedBox>(btVector3(0.5F, 0.5F, 0.5F));
    add(0, shape<NotedBox>(btVector3(60, 1, 60)), btVector3(0, -1, 0));
    for (int i = 0; i < 300; ++i) {
      const auto number = static_cast<float>(i);
      add(1, box,
          btVector3(static_cast<float>(i % 20), 0.5F + static_cast<float>(i / 20), 0.3F * std::sin(number)))
          ->setActivationState(DISABLE_DEACTIVATION);
    }
    if (hasHybrid) addBlock(btVector3(9, 17, 0));
  }

  /// Steps with another world that has no threads, in which the same must come about.
  void stepBeside(Blocks& other, int steps) {
    for (int i = 0; i < steps; ++i) {
      step();
      other.step();
      ASSERT_EQ(bits(), other.bits()) << "step " << i;
    }
  }
};

/// How often boxes were asked by what a scheduler shares.
int countShared(bool hasHybrid, const std::function<void(Blocks&)>& change) {
  NotedScheduler scheduler;
  Blocks one(hasHybrid);
  Blocks other(hasHybrid);
  EXPECT_STREQ(one.world.setTaskScheduler(&scheduler), nullptr);
  change(one);
  change(other);
  NotedBox::shared = 0;
  one.stepBeside(other, 60);
  return NotedBox::shared;
}

// Bullet's own steps of two boxes reach for nothing else. On a quick machine only one step in seventeen is
// shared.
TEST(Threads, TakeStepsOfPlainBoxes) {
  for (const bool hasHybrid : {true, false})
    EXPECT_GT(countShared(hasHybrid, [](Blocks&) {}), 1000)
        << (hasHybrid ? "with" : "without") << " a hybrid";
}

TEST(Threads, LeavePlainBoxesToWhoSeesOrHearsOfThem) {
  const auto look = [](Blocks& blocks) {
    blocks.world.setPromises(BT_HYBRID_NEAR_CALLBACK_FORWARDS);
    blocks.dispatcher.setNearCallback(handOn);
  };
  EXPECT_EQ(countShared(false, look), 0);
  gContactProcessedCallback = noteProcessed;
  EXPECT_EQ(countShared(false, [](Blocks&) {}), 0);
  gContactProcessedCallback = nullptr;
}

TEST(Threads, GiveTheSameBitsToPlainBoxes) {
  for (const bool hasHybrid : {true, false}) {
    Blocks one(hasHybrid);
    Blocks many(hasHybrid);
    ASSERT_STREQ(many.world.setNumThreads(3), nullptr);
    many.stepBeside(one, 120);
    // What others take is counted alike, whoever does it.
    for (Blocks* blocks : {&one, &many}) blocks->world.setBudgetUnits(one.pairInfo().units + 5);
    many.stepBeside(one, 60);
    EXPECT_EQ(many.pairInfo().units, one.pairInfo().units);
  }
}

/// How often threads of this process have gone to sleep by themselves; 0 where that is not to be had.
int countSleeps() {
  int sleeps = 0;
  std::error_code error;
  for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task", error)) {
    constexpr std::string_view kKey = "voluntary_ctxt_switches:\t";
    std::ifstream status(thread.path() / "status");
    for (std::string line; std::getline(status, line);) {
      if (!line.starts_with(kKey)) continue;
      int count = 0;
      std::from_chars(line.data() + kKey.size(), line.data() + line.size(), count);
      sleeps += count;
    }
  }
  return sleeps;
}

void rest() {
  std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

// To wake a thread takes a tenth of the step of a scene in which nothing is to be shared.
TEST(Threads, SleepWhereNothingIsToBeShared) {
  constexpr int kSteps = 100;
  PairTestWorld world;
  world.world.setNumThreads(3);
  for (int i = 0; i < 8; ++i) world.addBlock(btVector3(static_cast<float>(10 * i), 0, 0), 1);
  for (int i = 0; i < 10; ++i) rest();
  const int before = countSleeps();
  if (before == 0) GTEST_SKIP() << "this system does not count how often threads sleep";
  for (int step = 0; step < kSteps; ++step) {
    world.step();
    rest();
  }
  // This thread rests after each step, and two others might.
  EXPECT_LT(countSleeps() - before, 2 * kSteps);
}

TEST(Threads, AreFrom1To64) {
  PairTestWorld world;
  EXPECT_EQ(world.world.getNumThreads(), 1);
  EXPECT_STREQ(world.world.setNumThreads(4), nullptr);
  for (const int threads : {0, -1, 65}) EXPECT_STRNE(world.world.setNumThreads(threads), nullptr);
  EXPECT_EQ(world.world.getNumThreads(), 4);
  EXPECT_STREQ(world.world.setNumThreads(1), nullptr);
  EXPECT_EQ(world.world.getNumThreads(), 1);
}

}  // namespace
}  // namespace scatter::test
