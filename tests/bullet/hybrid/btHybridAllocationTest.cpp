#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <new>

#include "RandomShapes.h"
#include "trials.h"

// A program of its own, because it counts every allocation there is.

namespace {

long allocations = 0;

void* countedAligned(std::size_t size, int alignment) {
  ++allocations;
  return std::aligned_alloc(static_cast<std::size_t>(alignment),
                            (size + static_cast<std::size_t>(alignment) - 1) /
                                static_cast<std::size_t>(alignment) * static_cast<std::size_t>(alignment));
}
void* counted(std::size_t size) {
  ++allocations;
  return std::malloc(size);
}
void release(void* memory) {
  std::free(memory);
}

}  // namespace

void* operator new(std::size_t size) {
  if (void* memory = counted(size)) return memory;
  throw std::bad_alloc();
}
void* operator new[](std::size_t size) {
  return operator new(size);
}
// The standard library's temporary buffers come from this one.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return counted(size);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}

#include <BulletHybrid/btHybridDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

namespace scatter::test {
namespace {

btDefaultCollisionConstructionInfo bigPools() {
  btDefaultCollisionConstructionInfo info;
  info.m_defaultMaxPersistentManifoldPoolSize = 1 << 16;
  info.m_defaultMaxCollisionAlgorithmPoolSize = 1 << 14;
  return info;
}

/// Of a call that returns what is wrong.
void require(const char* mistake) {
  if (mistake == nullptr) return;
  std::fprintf(stderr, "%s\n", mistake);
  std::abort();
}

/// A clump of hybrids that keeps moving a little, over and over in the same way.
class Swaying {
 public:
  explicit Swaying(int count) : shapes_(3) {
    auto* middle = shapes_.make<btCompoundShape>();
    auto* octant = shapes_.make<btBoxShape>(btVector3(0.3F, 0.3F, 0.3F));
    for (int i = 0; i < 8; ++i) {
      const btVector3 corner(i % 2 == 0 ? -0.3F : 0.3F, i / 2 % 2 == 0 ? -0.3F : 0.3F,
                             i / 4 == 0 ? -0.3F : 0.3F);
      middle->addChildShape(btTransform(btQuaternion::getIdentity(), corner), octant);
    }
    require(levels.addLevel(shapes_.make<btBoxShape>(btVector3(0.7F, 0.7F, 0.7F))));
    require(levels.addLevel(middle));
    require(levels.addLevel(shapes_.plainCompound(20, 1)));
    for (int i = 0; i < count; ++i) {
      rest_.push_back(shapes_.random.pose(0.8F));
      btRigidBody::btRigidBodyConstructionInfo info(1, nullptr, levels.getLevelShape(3), btVector3(1, 1, 1));
      bodies_.push_back(std::make_unique<btHybridRigidBody>(info, &levels));
      bodies_.back()->setActivationState(DISABLE_DEACTIVATION);
      bodies_.back()->setWorldTransform(rest_.back());
      world.addRigidBody(bodies_.back().get());
    }
  }

  ~Swaying() {
    for (auto& body : bodies_) world.removeRigidBody(body.get());
  }

  Swaying(const Swaying&) = delete;
  Swaying& operator=(const Swaying&) = delete;

  static constexpr int kPeriod = 50;

  /// The allocations of the narrowphase in one step.
  long step(int number) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const float phase =
          6.2831853F * (static_cast<float>(number % kPeriod) / kPeriod) + static_cast<float>(i);
      const btTransform sway(btQuaternion(btVector3(0, 1, 0), 0.2F * std::sin(phase)),
                             btVector3(0.1F * std::cos(phase), 0.05F * std::sin(2 * phase), 0));
      bodies_[i]->setWorldTransform(sway * rest_[i]);
    }
    const long before = allocations;
    world.performDiscreteCollisionDetection();
    return allocations - before;
  }

  btHybridLevelSet levels;
  btDefaultCollisionConfiguration configuration{bigPools()};
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btHybridDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};

 private:
  RandomShapes shapes_;
  std::vector<btTransform> rest_;
  std::vector<std::unique_ptr<btHybridRigidBody>> bodies_;
};

/// Counts Bullet's own allocations too, for as long as it lives.
class Counting {
 public:
  Counting() {
    btAlignedAllocSetCustom(counted, release);
    btAlignedAllocSetCustomAligned(countedAligned, release);
  }
  ~Counting() {
    btAlignedAllocSetCustom(nullptr, nullptr);
    btAlignedAllocSetCustomAligned(nullptr, nullptr);
  }
  Counting(const Counting&) = delete;
  Counting& operator=(const Counting&) = delete;
};

TEST(Allocations, TheNarrowphaseMakesNoneAfterWarmUp) {
  const Counting counting;
  Swaying w(20);
  long warmUp = 0;
  for (int i = 0; i < 3 * Swaying::kPeriod; ++i) warmUp += w.step(i);
  EXPECT_GT(warmUp, 0);
  long later = 0;
  for (int i = 0; i < 3 * Swaying::kPeriod; ++i) later += w.step(i);
  EXPECT_EQ(later, 0);
  EXPECT_GT(w.dispatcher.getNumManifolds(), 100);
}

TEST(Allocations, PairsThatSwitchWithinABudgetMakeNoneAfterWarmUp) {
  const Counting counting;
  Swaying w(kSanitized ? 10 : 20);
  ASSERT_EQ(w.world.addPolicy("speed"), nullptr);
  ASSERT_EQ(w.world.addPolicy("group-density"), nullptr);
  // The budget comes and goes with the swaying, and so do requests, so that pairs switch all the time.
  int switches = 0;
  const auto run = [&w, &switches](int steps) {
    long count = 0;
    for (int i = 0; i < steps; ++i) {
      const btHybridPairStepInfo info = w.world.getPairStepInfo();
      switches += info.switchesCoarser + info.switchesFiner;
      if (i % 2 == 0) w.world.requestLevel(w.world.getHybrid(i / 2 % w.world.getNumHybrids()), 1 + i / 2 % 3);
      count += w.step(i);
    }
    return count;
  };
  std::vector<btHybridBudgetUnits> units;
  for (int i = 0; i < 100 * Swaying::kPeriod; ++i) {
    units.push_back({.given = i % Swaying::kPeriod < 25 ? 150.0 : 20000.0});
  }
  w.world.replayBudget(units.data(), static_cast<int>(units.size()));
  EXPECT_GT(run(24 * Swaying::kPeriod), 0);
  switches = 0;
  EXPECT_EQ(run(6 * Swaying::kPeriod), 0);
  EXPECT_GT(switches, 100);
}

}  // namespace
}  // namespace scatter::test
