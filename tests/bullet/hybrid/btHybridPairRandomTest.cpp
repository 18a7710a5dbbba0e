#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "PairTestWorld.h"

// Many small worlds of random bodies, and random reasons to switch: each is compared with a copy of itself
// that is given no reason in one step.

namespace scatter::test {
namespace {

#if defined(__SANITIZE_ADDRESS__) || !defined(NDEBUG)
constexpr int kWorlds = 25;
#else
constexpr int kWorlds = 300;
#endif
constexpr int kRandomSteps = 90;
constexpr float kTimeStep = 1.0F / 60;

/// A reason to switch, from a step on.
struct Reason {
  int step = 0;
  enum class Kind { kRequests, kBudget, kPolicy, kNothing } kind = Kind::kRequests;
  std::vector<int> levels{};  ///< Of the bodies; 0: no request.
  double units = 0;           ///< 0: no budget from now on.
  const char* policy = nullptr;
};

const char* const kPolicies[] = {"speed", "proximity", "coarsest", "load", "group-density"};

std::vector<Reason> randomReasons(Random& random, int bodies) {
  std::vector<Reason> reasons;
  const int count = 2 + random.index(3);
  for (int i = 0; i < count; ++i) {
    Reason reason;
    reason.step = 4 + (kRandomSteps - 4) * i / count + random.index(kRandomSteps / count - 4);
    reason.kind = static_cast<Reason::Kind>(random.index(3));
    for (int k = 0; k < bodies; ++k) reason.levels.push_back(random.chance(0.6F) ? 1 + random.index(3) : 0);
    reason.units = random.chance(0.2F) ? 0 : static_cast<double>(random.between(5, 400));
    reason.policy = kPolicies[random.index(5)];
    reasons.push_back(reason);
  }
  return reasons;
}

struct State {
  double energy;
  float fastest;  ///< Of any point of a body, metres per second.
  std::vector<btVector3> centres;
};

/// Slow bodies that crowd each other, without gravity.
class SmallWorld : public PairTestWorld {
 public:
  explicit SmallWorld(std::uint64_t seed) : PairTestWorld(BT_HYBRID_PAIR_SWITCHING, seed) {
    Random random(seed);
    const int count = 8 + random.index(8);
    const float spread = random.between(1.6F, 2.6F);
    for (int i = 0; i < count; ++i) {
      const btVector3 cell(static_cast<float>(i % 2), static_cast<float>(i / 2 % 3),
                           static_cast<float>(i / 6));
      const btHybridLevelSet& levels = random.chance(0.3F) ? block : random.chance(0.5F) ? ship : cross;
      const btTransform pose(random.rotation(), cell * spread + random.inCube(0.2F));
      btHybridRigidBody* body =
          addBody(levels, pose, random.between(0.5F, 5), random.chance(0.3F) ? 1 + random.index(3) : 0);
      body->setLinearVelocity((btVector3(0.5F, 1, 0.5F) * spread - pose.getOrigin()) * 0.4F +
                              random.inCube(0.4F));
      body->setAngularVelocity(random.inCube(0.4F));
    }
    if (random.chance(0.5F)) {
      add(1, shape<btSphereShape>(btScalar(0.5)), btVector3(1, 1, 1) * spread);
      add(0, shape<btBoxShape>(btVector3(0.5F, 0.5F, 0.5F)), btVector3(-1, 0, -0.5F) * spread);
    }
    world.getPairSwitchingInfo().m_creditLevel = 1 + random.index(2);
    world.getPairSwitchingInfo().m_credit = random.chance(0.8F);
    removeOverlapping();
    bodyCount = world.getNumHybrids();
    reasons = randomReasons(random, bodyCount);
  }

  /// Runs to the end of step `last`, without the reason with number `without`.
  void run(int last, int without = -1) {
    for (; now_ <= last; ++now_) {
      for (std::size_t i = 0; i < reasons.size(); ++i) {
        if (reasons[i].step == now_ && static_cast<int>(i) != without) give(reasons[i]);
      }
      step();
      const btHybridPairStepInfo info = pairInfo();
      switches += info.switchesCoarser + info.switchesFiner;
      onCredit += info.creditSwitches;
      unsafe += info.unsafeSwitches;
    }
  }

  [[nodiscard]] State state() const {
    State result{kineticEnergy(), 0, {}};
    for (const auto& body : bodies) {
      result.centres.push_back(body->getWorldTransform().getOrigin());
      const float speed = body->getLinearVelocity().length() + 2 * body->getAngularVelocity().length();
      result.fastest = std::max(result.fastest, speed);
    }
    return result;
  }

  [[nodiscard]] int indexOf(const btCollisionObject* object) const {
    int index = 0;
    while (bodyAt(index) != object) ++index;
    return index;
  }

  [[nodiscard]] btRigidBody* bodyAt(int index) const { return bodies[static_cast<std::size_t>(index)].get(); }

  int bodyCount = 0;
  std::vector<Reason> reasons;
  int switches = 0;
  int onCredit = 0;
  int unsafe = 0;

 private:
  /// Bodies that start inside each other are driven apart, whatever their level.
  void removeOverlapping() {
    for (bool found = true; found;) {
      world.performDiscreteCollisionDetection();
      found = false;
      for (int i = 0; i < dispatcher.getNumManifolds() && !found; ++i) {
        const btPersistentManifold& manifold = manifoldAt(i);
        for (int k = 0; k < manifold.getNumContacts() && !found; ++k) {
          found = manifold.getContactPoint(k).getDistance() < -0.005F;
        }
        if (!found) continue;
        const btCollisionObject* one = manifold.getBody0();
        if (one->isStaticObject()) one = manifold.getBody1();
        world.removeRigidBody(bodyAt(indexOf(one)));
      }
    }
  }

  void give(const Reason& reason) {
    switch (reason.kind) {
      case Reason::Kind::kRequests:
        for (int i = 0; i < bodyCount; ++i) {
          const int level = reason.levels[static_cast<std::size_t>(i)];
          if (level > 0) world.requestLevel(world.getHybrid(i), level);
        }
        break;
      case Reason::Kind::kBudget:
        if (reason.units > 0) {
          world.setBudgetUnits(reason.units);
        } else {
          world.removeBudget();
        }
        break;
      case Reason::Kind::kPolicy:
        world.removePolicies();
        ASSERT_EQ(world.addPolicy(reason.policy), nullptr);
        break;
      case Reason::Kind::kNothing:
        break;
    }
  }

  int now_ = 0;
};

struct Totals {
  int switches = 0;
  int onCredit = 0;
  int compared = 0;
  int comparedSwitches = 0;
};

/// Contacts of the pairs that have switched in the last step, against those of the copy.
void expectNoDeeperContacts(const SmallWorld& with, const SmallWorld& without, float travel,
                            const std::string& where) {
  for (const btHybridPairEvent& event : with.pairs.events) {
    if (event.m_kind != BT_HYBRID_PAIR_SWITCHED) continue;
    const int one = with.indexOf(event.m_objectA);
    const int other = with.indexOf(event.m_objectB);
    const float copy = without.deepestOf(without.bodyAt(one), without.bodyAt(other));
    const float now = with.deepestOf(event.m_objectA, event.m_objectB);
    EXPECT_GE(now, std::min(copy, 0.0F) - 0.002F - travel)
        << where << ", bodies " << one << " and " << other << ", " << event.m_fromLevel << " to "
        << event.m_toLevel;
  }
}

/// The step with a reason, with it and without.
void compare(std::uint64_t seed, int number, Totals& totals) {
  SmallWorld with(seed);
  SmallWorld without(seed);
  const int step = with.reasons[static_cast<std::size_t>(number)].step;
  with.run(step - 1);
  without.run(step - 1);
  ASSERT_EQ(with.bits(), without.bits());
  const State before = with.state();
  const int switchesBefore = with.switches;
  with.pairs.events.clear();
  with.run(step);
  without.run(step, number);
  const State a = with.state();
  const State b = without.state();
  totals.compared++;
  totals.comparedSwitches += with.switches - switchesBefore;
  const std::string where = "world " + std::to_string(seed) + ", step " + std::to_string(step);

  // The solver's impulses are good to about a millionth of what is at work, in each of its iterations.
  const double noise = 1e-4 * std::max(before.energy, b.energy) + 1e-6;
  EXPECT_LE(a.energy, std::max(before.energy, b.energy) + noise) << where;

  // A contact that comes earlier or later makes bodies stop, or not; nothing may push them further.
  const float travel = 2 * before.fastest * kTimeStep + 1e-4F;
  for (std::size_t i = 0; i < a.centres.size(); ++i) {
    EXPECT_LE(a.centres[i].distance(b.centres[i]), travel) << where << ", body " << i;
  }
  expectNoDeeperContacts(with, without, travel, where);
}

TEST(RandomSwitches, GainNoEnergyMoveNoBodyAndMakeNoContactDeeper) {
  Totals totals;
  for (std::uint64_t seed = 1; seed <= kWorlds && !HasFatalFailure(); ++seed) {
    SmallWorld w(seed);
    w.run(kRandomSteps - 1);
    EXPECT_EQ(w.unsafe, 0) << "world " << seed;
    totals.switches += w.switches;
    totals.onCredit += w.onCredit;
    for (std::size_t i = 0; i < w.reasons.size(); ++i) compare(seed, static_cast<int>(i), totals);
  }
  RecordProperty("switches", std::to_string(totals.switches));
  RecordProperty("onCredit", std::to_string(totals.onCredit));
  RecordProperty("compared", std::to_string(totals.comparedSwitches));
  EXPECT_GT(totals.switches, 20 * kWorlds);
  EXPECT_GT(totals.onCredit, 4 * kWorlds);
  EXPECT_GT(totals.comparedSwitches, 5 * kWorlds);
}

/// The test would see a bad switch: without the safety conditions the same worlds fail.
TEST(RandomSwitches, WithoutSafetyMakeContactsDeeper) {
  int unsafe = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SmallWorld w(seed);
    w.world.getPairSwitchingInfo().m_safetyConditions = false;
    w.run(kRandomSteps - 1);
    unsafe += w.unsafe;
  }
  EXPECT_GT(unsafe, 10);
}

}  // namespace
}  // namespace scatter::test
