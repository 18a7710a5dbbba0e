#include "pairs/foresee.h"

#include <gtest/gtest.h>

#include "collision/geometry.h"
#include "pairs/fake_engine.h"
#include "pairs/fake_ground_engine.h"
#include "pairs/ground_step.h"
#include "pairs/pair_step.h"

// A step of which something was found out before gives what a step gives that finds out everything.

namespace scatter::pairs {
namespace {

using testing::boxPart;
using testing::FakeEngine;
using testing::FakeGroundEngine;

std::vector<std::vector<PartDef>> oneLevel() {
  const Mat3 upright(1.0F);
  std::vector<PartDef> parts;
  for (const float y : {-0.6F, -0.2F, 0.2F, 0.6F}) {
    for (const float x : {-0.6F, 0.6F}) parts.push_back(boxPart(Vec3(x, y, 0.0F), Vec3(0.2F), upright, 0.0F));
  }
  return {parts};
}

/// Tells what the engine is going to say, or does it.
class Peek : public ContactPeek {
 public:
  Peek(FakeEngine& engine, bool carries) : engine_(engine), carries_(carries) {}
  [[nodiscard]] bool carries() const override { return carries_; }
  [[nodiscard]] bool wouldOutlast(void* contact) const override {
    if (carries_) return engine_.outlasts(contact);
    for (int i = 0; i < engine_.countPoints(contact); ++i) {
      if (!engine_.losesPoints && engine_.distanceNow(contact, i) <= engine_.threshold()) return true;
    }
    return false;
  }
  [[nodiscard]] float wouldSlide(void* contact) const override {
    return carries_ ? engine_.carry(contact) : engine_.wouldSlide(contact);
  }
  [[nodiscard]] bool detectsAnywhere(const ChildPair& /*child*/) const override { return false; }

 private:
  FakeEngine& engine_;
  bool carries_;
};

PairPlan planOf(int levels) {
  PairPlan plan;
  plan.view.finest = levels;
  plan.target = levels;
  plan.tries = true;
  return plan;
}

struct TwoBodies {
  TwoBodies() = default;
  TwoBodies(const TwoBodies&) = delete;
  TwoBodies& operator=(const TwoBodies&) = delete;
  ~TwoBodies() { pair.dropAll(engine); }

  /// Whether something was foreseen.
  bool foreseeStep(float x) {
    engine.x = x;
    scratches.used = 0;
    PlacedBodies bodies;
    if (!engine.place(1, bodies) || !isForeseeable(pair, bodies)) return false;
    foresee(pair, bodies, steps, Peek(engine, carries), locks, scratches);
    return true;
  }

  PairOutcome step(float x) {
    engine.x = x;
    const PairOutcome outcome = stepPair(pair, plan, steps, engine, scratch, work);
    plan.tries = false;
    plan.view.level = 1;
    return outcome;
  }

  FakeEngine engine{oneLevel()};
  bool carries = false;  ///< What is foreseen takes contacts along.
  Pair pair;
  PairPlan plan = planOf(1);
  PairSteps steps;
  StepScratch scratch;
  PairWork work;
  ForesightScratch scratches;
  BoundsLocks locks;
};

void expectSame(const PairWork& a, const PairWork& b) {
  EXPECT_EQ(a.pairs, b.pairs);
  EXPECT_EQ(a.pairsSkipped, b.pairsSkipped);
  EXPECT_EQ(a.rebuilds, b.rebuilds);
  EXPECT_EQ(a.childPairs, b.childPairs);
  EXPECT_EQ(a.childPairsAsleep, b.childPairsAsleep);
  EXPECT_EQ(a.recycled, b.recycled);
  EXPECT_EQ(a.boundsRejected, b.boundsRejected);
  EXPECT_EQ(a.axisRejected, b.axisRejected);
  EXPECT_EQ(a.gjkRuns, b.gjkRuns);
  EXPECT_EQ(a.detectorRuns, b.detectorRuns);
  EXPECT_EQ(a.halfSpaceRuns, b.halfSpaceRuns);
}

void expectSame(const Pair& a, const Pair& b) {
  EXPECT_EQ(a.quietUntil, b.quietUntil);
  EXPECT_EQ(a.origin, b.origin);
  ASSERT_EQ(a.parts.children().size(), b.parts.children().size());
  for (std::size_t i = 0; i < a.parts.children().size(); ++i) {
    const ChildPair& one = a.parts.children()[i];
    const ChildPair& other = b.parts.children()[i];
    EXPECT_EQ(one.wake, other.wake);
    EXPECT_EQ(one.touching, other.touching);
    EXPECT_EQ(one.settled, other.settled);
    EXPECT_EQ(one.stale, other.stale);
    EXPECT_EQ(one.turnAt, other.turnAt);
    EXPECT_EQ(one.contact == nullptr, other.contact == nullptr);
  }
}

TEST(Foresee, LeavesAPairAsItsStepWould) {
  int foreseen = 0;
  int touched = 0;
  int recycled = 0;
  int lookedBesides = 0;
  for (std::uint32_t seed = 1; seed <= 100; ++seed) {
    TwoBodies plain;
    TwoBodies early;
    const bool recycles = seed % 2 == 0;
    early.carries = seed % 4 > 1;
    plain.steps.recycling = early.steps.recycling = recycles ? 0.001F : 0.0F;
    testing::Random random(seed);
    float x = random.uniform(1.6F, 1.7F);
    for (int i = 0; i < 100; ++i) {
      const float stride = recycles && i % 4 != 0 ? 0.0004F : 0.03F;
      x = std::clamp(x + random.uniform(-stride, stride), 1.55F, 1.75F);
      plain.engine.losesPoints = early.engine.losesPoints = random.uniform(0.0F, 1.0F) < 0.1F;
      foreseen += early.foreseeStep(x) ? 1 : 0;
      const PairOutcome outcome = plain.step(x);
      const PairOutcome same = early.step(x);
      EXPECT_EQ(early.pair.foresight, nullptr) << "it was made use of";
      EXPECT_EQ(outcome.work.contacts, same.work.contacts) << "seed " << seed << ", step " << i;
      EXPECT_EQ(outcome.touching, same.touching);
      expectSame(outcome.work.counts, same.work.counts);
      expectSame(plain.pair, early.pair);
      ASSERT_EQ(plain.engine.manifolds(), early.engine.manifolds());
      touched += outcome.touching ? 1 : 0;
      recycled += outcome.work.counts.recycled;
      lookedBesides += recycles && outcome.touching && outcome.work.counts.gjkRuns > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(foreseen, 9000);
  EXPECT_GT(recycled, 1000);
  EXPECT_GT(lookedBesides, 200);
  EXPECT_GT(touched, 1000);
}

TEST(Foresee, IsNotForPairsWithCreditOrOtherShapes) {
  TwoBodies bodies;
  EXPECT_FALSE(bodies.foreseeStep(1.7F)) << "it has not looked yet";
  bodies.step(1.7F);
  EXPECT_TRUE(bodies.foreseeStep(1.7F));
  bodies.step(1.7F);
  bodies.pair.credit.kind = CreditKind::kCoarser;
  EXPECT_FALSE(bodies.foreseeStep(1.7F));
  bodies.pair.credit.kind = CreditKind::kNone;
  bodies.engine.version = 1;
  EXPECT_FALSE(bodies.foreseeStep(1.7F));
}

TEST(Foresee, GivesContactsBackThatNobodyAskedFor) {
  TwoBodies bodies;
  bodies.step(1.59F);
  ASSERT_GT(bodies.engine.manifolds(), 0);
  ASSERT_TRUE(bodies.foreseeStep(2.3F));
  ASSERT_NE(bodies.pair.foresight, nullptr);
  bodies.pair.dropAll(bodies.engine);
  EXPECT_EQ(bodies.engine.manifolds(), 0);
}

struct OverGround {
  OverGround() = default;
  OverGround(const OverGround&) = delete;
  OverGround& operator=(const OverGround&) = delete;
  ~OverGround() { pair.restart(0.0F, engine); }

  bool foreseeStep(const Vec3& position) {
    engine.position = position;
    scratches.used = 0;
    PlacedBody placed;
    if (!engine.place(1, placed) ||
        !isForeseeable(pair, placed, 1, engine.groundFrame(), engine.groundVersion(), steps))
      return false;
    foresee(pair, placed, engine.groundFrame(), steps, engine, scratch.ground.region, scratches);
    return true;
  }

  PairWork step(const Vec3& position) {
    engine.position = position;
    PairWork work;
    collideGround(pair, 1, steps, engine, scratch, work);
    return work;
  }

  FakeGroundEngine engine{oneLevel(), true};
  GroundPair pair;
  PairSteps steps;
  StepScratch scratch;
  ForesightScratch scratches;
};

TEST(Foresee, LeavesAPairOnAGroundAsItsStepWould) {
  int foreseen = 0;
  int recycled = 0;
  for (std::uint32_t seed = 1; seed <= 60; ++seed) {
    OverGround plain;
    OverGround early;
    plain.steps.recycling = early.steps.recycling = seed % 2 == 0 ? 0.001F : 0.0F;
    testing::Random random(seed);
    Vec3 position(0.0F, seed % 2 == 0 ? 0.82F : 1.0F, 0.0F);
    for (int i = 0; i < 60; ++i) {
      const float stride = seed % 2 == 0 && i % 3 != 0 ? 0.003F : 1.0F;
      position += stride * Vec3(random.uniform(-0.1F, 0.1F), random.uniform(-0.03F, 0.03F),
                                random.uniform(-0.1F, 0.1F));
      position.y = std::clamp(position.y, 0.77F, 1.2F);
      foreseen += early.foreseeStep(position) ? 1 : 0;
      const PairWork work = plain.step(position);
      expectSame(work, early.step(position));
      recycled += work.recycled;
      EXPECT_EQ(early.pair.foresight, nullptr);
      EXPECT_EQ(plain.pair.quietUntil, early.pair.quietUntil) << "seed " << seed << ", step " << i;
      ASSERT_EQ(plain.pair.contacts.size(), early.pair.contacts.size()) << "seed " << seed << ", step " << i;
      for (std::size_t k = 0; k < plain.pair.contacts.size(); ++k) {
        EXPECT_EQ(plain.pair.contacts[k].part, early.pair.contacts[k].part);
        EXPECT_EQ(plain.engine.point(plain.pair.contacts[k].manifold, 0).distance,
                  early.engine.point(early.pair.contacts[k].manifold, 0).distance);
      }
    }
  }
  EXPECT_GT(foreseen, 1500);
  EXPECT_GT(recycled, 200);
}

}  // namespace
}  // namespace scatter::pairs
