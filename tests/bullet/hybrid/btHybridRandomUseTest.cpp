#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "AnyProgram.h"
#include "RandomPrograms.h"

// A program that does between two steps whatever a program may, in any order: nothing breaks, nothing is left
// behind, and any number of threads gives the same bits.

namespace scatter::test {
namespace {

constexpr int kUseSteps = 150;

// Where contacts are recycled, others may begin a quarter of the contact threshold late.
constexpr btScalar kLate = 0.006F;

/// Contacts that Bullet has and the world has not, or the other way round, in its last verified step.
std::string describe(const btAlignedObjectArray<btHybridMissedContact>& contacts) {
  std::string text;
  for (int i = 0; i < btMin(contacts.size(), 3); ++i) {
    const btHybridMissedContact& one = contacts[i];
    for (const auto& [object, child] :
         {std::pair(one.m_bodyA, one.m_childA), std::pair(one.m_bodyB, one.m_childB)}) {
      text += std::string(object->getCollisionShape()->getName()) + " " +
              std::to_string(object->getWorldArrayIndex()) + " child " + std::to_string(child) + ", ";
    }
    text += std::to_string(one.m_distance) + " m\n";
  }
  return text;
}

/// Of these. Bullet's GJK does not find all that are a gap apart, or those of round shapes in both of two
/// worlds.
btScalar nearest(const btAlignedObjectArray<btHybridMissedContact>& contacts) {
  btScalar least = 1;
  for (int i = 0; i < contacts.size(); ++i) least = btMin(least, contacts[i].m_distance);
  return least;
}

/// What the programs have come to.
struct Seen {
  long expected = 0;
  long missed = 0;
  long extra = 0;
  long manifolds = 0;
  long credited = 0;
  long switches = 0;

  void add(AnyProgram& program) {
    const btHybridPairStepInfo info = program.world.getPairStepInfo();
    manifolds += program.dispatcher.getNumManifolds();
    credited += info.creditedPairs;
    switches += info.switchesCoarser + info.switchesFiner;
  }
  void add(const btHybridContactReport& report) {
    expected += report.m_expected;
    missed += report.m_missed;
    extra += report.m_extra;
  }
};

TEST(RandomUse, BreaksNothingAndGivesTheSameBitsOnThreads) {
  Seen seen;
  const std::vector<std::uint64_t> all = programs(100);
  for (const std::uint64_t seed : all) {
    SCOPED_TRACE("program " + std::to_string(seed));
    AnyProgram one(seed);
    AnyProgram other(seed);
    Random random(seed);
    const Callbacks callbacks;
    for (int step = 0; step < kUseSteps; ++step) {
      if (step % 20 == 0) other.world.setNumThreads(1 + random.index(4));
      if (step % 20 == 10) Callbacks::set(random.index(7));
      heard = 0;
      one.doAnything();
      one.stepSomehow();
      const std::uint64_t heardByOne = std::exchange(heard, 0);
      other.doAnything();
      other.stepSomehow();
      ASSERT_EQ(heard, heardByOne) << "step " << step;
      ASSERT_TRUE(one.isFinite()) << "step " << step;
      ASSERT_EQ(one.countOrphans(), 0) << "step " << step;
      ASSERT_EQ(one.all(), other.all()) << "step " << step;
      seen.add(one);
      const btHybridContactReport& report = one.world.getContactReport();
      ASSERT_GE(nearest(report.m_lastMissed), -kLate)
          << "step " << step << ": " << describe(report.m_lastMissed);
      ASSERT_GE(nearest(report.m_lastExtra), -kLate)
          << "step " << step << ": " << describe(report.m_lastExtra);
    }
    seen.add(one.world.getContactReport());
  }
  EXPECT_LE(seen.missed + seen.extra, seen.expected / 1000);
  const auto steps = static_cast<long>(all.size()) * kUseSteps;
  EXPECT_GT(seen.manifolds, 5 * steps);
  EXPECT_GT(seen.credited, steps / 10);
  EXPECT_GT(seen.switches, steps / 50);
}

// Verification silences Bullet's callbacks, which all worlds share.
std::vector<std::uint32_t> runOne(std::uint64_t seed) {
  heard = 0;
  AnyProgram program(seed, false);
  program.world.setNumThreads(1 + static_cast<int>(seed % 2));
  for (int step = 0; step < 60; ++step) {
    program.doAnything();
    program.stepSomehow();
  }
  return program.all();
}

TEST(RandomUse, WorldsOfSeveralThreadsAreAsAlone) {
  const std::vector<std::uint64_t> all = programs(24);
  std::vector<std::vector<std::uint32_t>> alone;
  for (const std::uint64_t seed : all) alone.push_back(runOne(seed));
  std::vector<std::vector<std::uint32_t>> beside(all.size());
  std::vector<std::thread> threads;
  for (std::size_t first = 0; first < 3; ++first) {
    threads.emplace_back([&all, &beside, first] {
      for (std::size_t i = first; i < all.size(); i += 3) beside[i] = runOne(all[i]);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(alone[i], beside[i]) << "program " << all[i];
}

}  // namespace
}  // namespace scatter::test
