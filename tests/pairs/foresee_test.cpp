#include "pairs/foresee.h"

#include <gtest/gtest.h>

#include "collision/geometry.h"
#include "pairs/fake_ground_engine.h"
#include "pairs/ground_step.h"
#include "pairs/living_pair.h"
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
    return carries_ ? engine_.outlasts(contact) : keepsPoints(contact);
  }
  [[nodiscard]] float wouldSlide(void* contact) const override {
    return carries_ ? engine_.carry(contact) : engine_.wouldSlide(contact);
  }
  [[nodiscard]] bool keepsPoints(const void* contact) const override {
    for (int i = 0; i < engine_.countPoints(contact); ++i) {
      if (!engine_.losesPoints && engine_.distanceNow(contact, i) <= engine_.threshold()) return true;
    }
    return false;
  }
  [[nodiscard]] bool detectsAnywhere(const ChildPair& /*child*/) const override { return false; }

 private:
  FakeEngine& engine_;
  bool carries_;
};

/// A pair that can be foreseen before each of its steps.
struct ForeseenPair : testing::LivingPair {
  explicit ForeseenPair(const std::vector<std::vector<PartDef>>& levels = oneLevel())
      : testing::LivingPair(levels) {}

  /// As btHybridPairAlgorithm does. Whether something was foreseen, or nothing needs to be.
  bool foreseeStep(float x) {
    engine.x = x;
    scratches.used = 0;
    PlacedBodies bodies;
    const Peek peek(engine, carries);
    if (plan.target != plan.view.level || placedLevel != plan.view.level) return false;
    if (!engine.place(plan.view.level, bodies) || !isForeseeable(pair, bodies, peek)) return false;
    if (keepsContacts(pair, plan, 0, relativeFrame(bodies.a->frame(), bodies.b->frame()))) return true;
    foresee(pair, bodies, steps, peek, locks, scratches);
    return true;
  }

  PairOutcome step(float x) {
    const PairOutcome outcome = testing::LivingPair::step(x);
    placedLevel = outcome.audited ? plan.view.finest : plan.view.level;
    return outcome;
  }

  bool carries = false;  ///< What is foreseen takes contacts along.
  int placedLevel = 0;   ///< Whose shapes were looked at last.
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
    ForeseenPair plain;
    ForeseenPair early;
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

TEST(Foresee, IsNotForOtherShapes) {
  ForeseenPair bodies;
  EXPECT_FALSE(bodies.foreseeStep(1.7F)) << "it has not looked yet";
  bodies.step(1.7F);
  EXPECT_TRUE(bodies.foreseeStep(1.7F));
  bodies.step(1.7F);
  bodies.engine.version = 1;
  EXPECT_FALSE(bodies.foreseeStep(1.7F));
}

// Each within the one before: they touch at a distance of 2 and of 1.6 m.
std::vector<std::vector<PartDef>> twoLevels() {
  return {{boxPart(Vec3(0.0F), Vec3(1.0F), Mat3(1.0F), 0.0F)}, oneLevel().front()};
}

/// One that switches.
struct SwitchingPair : ForeseenPair {
  SwitchingPair() : ForeseenPair(twoLevels()) { plan.rules.creditLevel = 1; }
};

void expectSame(const SwitchingPair& a, const SwitchingPair& b) {
  EXPECT_EQ(a.plan.view.level, b.plan.view.level);
  EXPECT_EQ(a.pair.credit.kind, b.pair.credit.kind);
  EXPECT_EQ(a.pair.credit.freshUntil, b.pair.credit.freshUntil);
  EXPECT_EQ(a.pair.credit.seenMotion, b.pair.credit.seenMotion);
  EXPECT_EQ(a.pair.credit.gap, b.pair.credit.gap);
  EXPECT_EQ(a.pair.credit.account.empty(), b.pair.credit.account.empty());
  EXPECT_EQ(a.pair.held.manifolds().size(), b.pair.held.manifolds().size());
  EXPECT_EQ(a.pair.parts.motion(), b.pair.parts.motion());
  EXPECT_EQ(a.engine.manifolds(), b.engine.manifolds());
  expectSame(a.pair, b.pair);
}

// At random wishes, with audits that are due now or never, and contacts that are kept now and then.
TEST(Foresee, LeavesAPairThatSwitchesAsItsStepWould) {
  int foreseen = 0;
  int credited = 0;
  int kept = 0;
  for (std::uint32_t seed = 1; seed <= 100; ++seed) {
    SwitchingPair plain;
    SwitchingPair early;
    plain.steps.recycling = early.steps.recycling = seed % 2 == 0 ? 0.001F : 0.0F;
    testing::Random random(seed);
    float x = random.uniform(1.6F, 1.7F);
    for (int i = 0; i < 120; ++i) {
      x = std::max(x + random.uniform(-0.005F, 0.0045F), 1.57F);
      plain.engine.losesPoints = early.engine.losesPoints = random.uniform(0.0F, 1.0F) < 0.05F;
      const int target = random.uniform(0.0F, 1.0F) < 0.5F ? 1 : 2;
      const bool audits = random.uniform(0.0F, 1.0F) < 0.5F;
      const bool keeps = random.uniform(0.0F, 1.0F) < 0.3F;
      for (SwitchingPair* bodies : {&plain, &early}) {
        if (i % 10 == 0) bodies->plan.target = target;
        bodies->plan.auditsFrom = audits ? lod::lateness::kDue : lod::lateness::kNever;
        bodies->plan.keepsFrom = keeps ? 0 : PairPlan::kNever;
      }
      const bool isForeseen = early.foreseeStep(x);
      const PairOutcome outcome = plain.step(x);
      const PairOutcome same = early.step(x);
      EXPECT_EQ(early.pair.foresight, nullptr);
      EXPECT_EQ(outcome.work.reuses, same.work.reuses) << "seed " << seed << ", step " << i;
      EXPECT_EQ(outcome.work.contacts, same.work.contacts) << "seed " << seed << ", step " << i;
      EXPECT_EQ(outcome.late, same.late);
      expectSame(outcome.work.counts, same.work.counts);
      expectSame(plain, early);
      if (HasFailure()) return;
      foreseen += isForeseen ? 1 : 0;
      credited += isForeseen && outcome.credited && !outcome.audited ? 1 : 0;
      kept += isForeseen && outcome.work.reuses ? 1 : 0;
      EXPECT_FALSE(isForeseen && outcome.audited) << "audits are the step's own";
    }
  }
  EXPECT_GT(foreseen, 6000);
  EXPECT_GT(credited, 1000);
  EXPECT_GT(kept, 500);
}

TEST(Foresee, GivesContactsBackThatNobodyAskedFor) {
  ForeseenPair bodies;
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
    foresee(pair, placed, engine.groundFrame(), steps, engine, scratch.ground.region, locks, scratches);
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
  BoundsLocks locks;
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
