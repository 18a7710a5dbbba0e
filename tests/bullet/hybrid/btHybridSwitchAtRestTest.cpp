#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <ostream>
#include <vector>

#include "PairTestWorld.h"
#include "trials.h"

// Bodies at rest that all change their levels at once: nobody may notice.

namespace scatter::test {
namespace {

constexpr float kPull = 10;    // metres per second squared
constexpr float kMass = 100;   // kilograms
constexpr int kSettle = 600;   // steps
constexpr int kWatched = 150;  // steps

/// Of a body of 100 kg whose height is off by a ten-thousandth of a millimetre, in every step, joules.
constexpr double kNoise = kWatched * 27 * kMass * kPull * 1e-7;

/// A clump never quite comes to rest: it creeps, its error reduction lifts it a little, and on credit it
/// creeps in other ways, some joules more or less. Of what a bad switch adds, that is next to nothing.
constexpr double kCreep = 1e-3;

enum class How { kNotAtAll, kOnCredit, kNaively };

/// A pile that settles, in one way of pulling it together.
class Pile : public PairTestWorld {
 public:
  using Build = std::function<void(Pile&, unsigned seed)>;

  Pile(const Build& build, unsigned seed) { build(*this, seed); }

  void pullStep() {
    for (auto& body : bodies) {
      const btVector3 position = body->getWorldTransform().getOrigin();
      if (central_ && position.length() > 0.01F) {
        body->applyCentralForce(position.normalized() * (-kPull * kMass));
      }
    }
    step();
  }

  void useCentralField() { central_ = true; }

  /// Kinetic and potential, joules.
  [[nodiscard]] double energy() const {
    double sum = kineticEnergy();
    for (const auto& body : bodies) {
      if (body->isStaticObject()) continue;
      const btVector3 position = body->getWorldTransform().getOrigin();
      sum += static_cast<double>(kPull * kMass * (central_ ? position.length() : position.y()));
    }
    return sum;
  }

  [[nodiscard]] std::vector<btVector3> centres() const {
    std::vector<btVector3> result;
    for (const auto& body : bodies) result.push_back(body->getWorldTransform().getOrigin());
    return result;
  }

 private:
  bool central_ = false;
};

struct Outcome {
  double risen = 0;  ///< The rises of the energy in the steps that were watched, joules.
  float moved = 0;   ///< The furthest that a centre was from where it was before, metres.
  int credited = 0;  ///< Pairs on credit, at the most.
  int unsafe = 0;
  float finest = 1;  ///< Of the touching pairs, the share at the finest level in the step after the switch.
};

Outcome watch(const Pile::Build& build, unsigned seed, How how, int level) {
  Pile w(build, seed);
  for (int i = 0; i < kSettle; ++i) w.pullStep();
  w.world.getPairSwitchingInfo().m_safetyConditions = how != How::kNaively;
  w.world.getPairSwitchingInfo().m_creditLevel = level;
  if (how != How::kNotAtAll) w.requestAll(level);
  const std::vector<btVector3> before = w.centres();
  Outcome outcome;
  double energy = w.energy();
  for (int i = 0; i < kWatched; ++i) {
    w.pullStep();
    outcome.risen += std::max(0.0, w.energy() - energy);
    energy = w.energy();
    const std::vector<btVector3> now = w.centres();
    for (std::size_t k = 0; k < now.size(); ++k) {
      outcome.moved = std::max(outcome.moved, static_cast<float>(now[k].distance(before[k])));
    }
    const btHybridPairStepInfo info = w.pairInfo();
    outcome.credited = std::max(outcome.credited, info.creditedPairs);
    outcome.unsafe += info.unsafeSwitches;
    if (i == 1 && info.touchingPairs > 0) {
      outcome.finest = static_cast<float>(info.touchingFinest) / static_cast<float>(info.touchingPairs);
    }
  }
  return outcome;
}

void clumpOf(Pile& w, const btHybridLevelSet& levels, float spacing, unsigned seed) {
  w.useCentralField();
  Random random(seed);
  for (int i = 0; i < 27; ++i) {
    const btVector3 cell(static_cast<float>(i % 3) - 1, static_cast<float>(i / 3 % 3) - 1,
                         static_cast<float>(i / 9) - 1);
    btHybridRigidBody* body =
        w.addBody(levels, btTransform(random.rotation(), cell * spacing + random.inCube(0.1F)), kMass);
    body->setDamping(0.3F, 0.3F);
    body->setFriction(0.6F);
  }
}

void clumpOfShips(Pile& w, unsigned seed) {
  clumpOf(w, w.ship, 2.4F, seed);
}

void clumpOfBlocks(Pile& w, unsigned seed) {
  clumpOf(w, w.block, 1.8F, seed);
}

/// Four towers of six blocks, near enough for the coarse levels of neighbours to overlap.
void towers(Pile& w, unsigned /*seed*/) {
  w.world.setGravity(btVector3(0, -kPull, 0));
  w.addFloor();
  for (int tower = 0; tower < 4; ++tower) {
    for (int i = 0; i < 6; ++i) {
      w.addBlock(btVector3(1.15F * static_cast<float>(tower % 2), 0.5F + static_cast<float>(i),
                           1.15F * static_cast<float>(tower / 2)),
                 kMass);
    }
  }
}

struct Case {
  const char* name;
  void (*build)(Pile&, unsigned seed);
  int level;
  bool isTower;
};

void PrintTo(const Case& one, std::ostream* out) {
  *out << one.name;
}

class SwitchAtRest : public testing::TestWithParam<Case> {};

void expectNoEnergy(const Case& one, unsigned seed) {
  const Outcome none = watch(one.build, seed, How::kNotAtAll, one.level);
  const Outcome credit = watch(one.build, seed, How::kOnCredit, one.level);
  const Outcome naive = watch(one.build, seed, How::kNaively, one.level);
  EXPECT_GT(credit.credited, 15) << "nothing switched, so nothing was tested";
  EXPECT_LT(credit.finest, 0.1F);
  EXPECT_EQ(credit.unsafe, 0);
  EXPECT_GT(naive.risen, 100) << "the test would not see a bad switch";
  if (one.isTower) {
    EXPECT_LE(credit.risen, none.risen + kNoise);
    EXPECT_LT(credit.moved, 0.02F);
    EXPECT_LT(none.moved, 0.02F);
    return;
  }
  EXPECT_LE(credit.risen, none.risen + kNoise + kCreep * naive.risen) << "joules; naively " << naive.risen;
}

TEST_P(SwitchAtRest, AddsNoEnergyOnCreditAndHundredsOfJoulesWithout) {
  for (const unsigned seed : trials<unsigned>({21, 3})) {
    SCOPED_TRACE(seed);
    expectNoEnergy(GetParam(), seed);
  }
}

INSTANTIATE_TEST_SUITE_P(Piles, SwitchAtRest,
                         testing::Values(Case{"ShipsToLevel2", clumpOfShips, 2, false},
                                         Case{"ShipsToLevel1", clumpOfShips, 1, false},
                                         Case{"BlocksToLevel2", clumpOfBlocks, 2, false},
                                         Case{"BlocksToLevel1", clumpOfBlocks, 1, false},
                                         Case{"TowersToLevel2", towers, 2, true},
                                         Case{"TowersToLevel1", towers, 1, true}),
                         [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace scatter::test
