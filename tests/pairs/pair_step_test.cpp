#include "pairs/pair_step.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "collision/geometry.h"
#include "pairs/living_pair.h"

namespace scatter::pairs {
namespace {

using lod::SwitchKind;
using testing::boxPart;

constexpr int kFinest = 3;

// Each level within the one before: they touch at a distance of 2, 1.8 and 1.6 m.
std::vector<std::vector<PartDef>> threeLevels() {
  const Mat3 upright(1.0F);
  const auto box = [&upright](float x, float y, float half) {
    return boxPart(Vec3(x, y, 0.0F), Vec3(half), upright, 0.0F);
  };
  return {
      {box(0.0F, 0.0F, 1.0F)},
      {box(-0.45F, 0.0F, 0.45F), box(0.45F, 0.0F, 0.45F)},
      {box(-0.6F, 0.21F, 0.2F), box(-0.6F, -0.21F, 0.2F), box(0.6F, 0.21F, 0.2F), box(0.6F, -0.21F, 0.2F)}};
}

struct ThreeLevelPair : testing::LivingPair {
  ThreeLevelPair() : testing::LivingPair(threeLevels()) {}

  /// Meets 1 cm deep at its finest level; then what becomes of going to another one.
  PairOutcome meetAndGoTo(int level) {
    step(3.0F);
    step(1.59F);
    plan.target = level;
    return step(1.59F);
  }

  [[nodiscard]] float press() const {
    float most = 0.0F;
    pair.forEachManifold([&](void* manifold) {
      for (int i = 0; i < engine.countPoints(manifold); ++i) {
        const ContactPoint point = engine.point(manifold, i);
        if (point.presses) most = std::max(most, -point.distance);
      }
    });
    return most;
  }

  [[nodiscard]] bool isQuiet() {
    PlacedBodies bodies;
    return engine.place(plan.view.level, bodies) && staysQuiet(pair, bodies);
  }
};

TEST(PairStep, LivesFromTheFirstLookToTheLast) {
  ThreeLevelPair living;
  // New, and apart: what it should have is free.
  PairOutcome outcome = living.step(3.0F);
  EXPECT_EQ(outcome.choice.kind, SwitchKind::kFree);
  EXPECT_EQ(living.plan.view.level, kFinest);
  EXPECT_FALSE(outcome.touching);
  EXPECT_TRUE(living.isQuiet());
  living.engine.x = 1.61F;
  EXPECT_FALSE(living.isQuiet());

  // In contact at its finest level: 1 cm deep, and pressed.
  outcome = living.step(1.59F);
  EXPECT_TRUE(outcome.touching);
  EXPECT_EQ(outcome.work.contacts, outcome.work.manifolds);
  EXPECT_NEAR(living.press(), 0.01F, 1e-4F);

  // Coarser, on credit: the middle shapes overlap by 21 cm, and nothing is pressed that was not before.
  living.plan.target = 1;
  outcome = living.step(1.59F);
  EXPECT_EQ(outcome.choice.kind, SwitchKind::kOnCredit);
  EXPECT_EQ(living.plan.view.level, 2);
  EXPECT_TRUE(outcome.credited);
  EXPECT_FALSE(outcome.isUnsafe);
  EXPECT_LE(living.press(), 0.01F + 1e-4F);
  EXPECT_FALSE(living.pair.held.empty());
  for (const ChildPair& child : living.pair.parts.children())
    EXPECT_EQ(child.contact, nullptr) << "excused, as contacts are held";

  // It is content there; moving on, it looks at its finest shapes again.
  living.plan.target = 2;
  EXPECT_FALSE(living.step(1.59F).audited);
  outcome = living.step(1.585F);
  EXPECT_TRUE(outcome.audited);
  EXPECT_GT(outcome.auditWork.counts.childPairs, 0);
  EXPECT_NEAR(living.pair.credit.gap, -0.015F, 1e-4F);

  // Finer again, with an overlap of 1.5 cm on credit: the contacts go back to the parts that they are of.
  living.plan.target = kFinest;
  outcome = living.step(1.585F);
  EXPECT_EQ(outcome.choice.kind, SwitchKind::kOnCredit);
  EXPECT_EQ(living.plan.view.level, kFinest);
  EXPECT_EQ(living.pair.origin, ContactOrigin::kGivenBack);
  EXPECT_TRUE(living.pair.held.empty());
  EXPECT_FALSE(outcome.isUnsafe);
  EXPECT_GT(outcome.work.contacts, 0);

  // Apart: nothing is left of it but the proof that it is.
  outcome = living.step(1.75F);
  EXPECT_FALSE(outcome.touching);
  EXPECT_FALSE(outcome.credited);
  EXPECT_EQ(living.engine.manifolds(), 0);
  EXPECT_TRUE(living.isQuiet());
}

// Their contacts end at a fiftieth of their size, and so early they are looked at again.
TEST(PairStep, AuditsSmallBodiesSooner) {
  int audits[2] = {0, 0};
  for (const bool isSmall : {false, true}) {
    ThreeLevelPair living;
    if (isSmall) living.engine.breaking = 0.002F;
    living.step(1.59F);
    living.plan.target = 2;
    for (int i = 0; i < 200; ++i)
      audits[isSmall ? 1 : 0] += living.step(1.59F - 0.001F * static_cast<float>(i)).audited ? 1 : 0;
  }
  EXPECT_GT(audits[0], 5);
  EXPECT_GT(audits[1], 5 * audits[0]);
}

TEST(PairStep, LooksAgainOnceNoContactIsLeftThatIsHeld) {
  ThreeLevelPair living;
  living.step(1.61F);
  living.step(1.599F);
  living.plan.target = 2;
  living.step(1.599F);
  ASSERT_GT(living.pair.held.countPoints(living.engine), 0);
  // So far that a look is not due for a while.
  for (int i = 1; i <= 30; ++i) living.step(1.599F - (i % 2 == 0 ? 0.001F : 0.0F));
  ASSERT_FALSE(living.step(1.5985F).audited);
  living.engine.losesPoints = true;
  EXPECT_TRUE(living.step(1.5984F).audited);
  living.engine.losesPoints = false;
  EXPECT_FALSE(living.step(1.5984F).audited) << "not in every step";
}

TEST(PairStep, IsQuietWhileBothBodiesMoveTogether) {
  ThreeLevelPair living;
  living.step(2.0F);
  for (int i = 0; i < 5; ++i) {
    living.engine.y += 10.0F;
    EXPECT_TRUE(living.isQuiet());
  }
  living.engine.x = 1.61F;
  EXPECT_FALSE(living.isQuiet());
  EXPECT_FALSE(living.isQuiet()) << "until it has been looked at";
}

TEST(PairStep, MovesContactsAlongWithinTheTolerance) {
  ThreeLevelPair living;
  living.steps.recycling = 0.001F;
  living.step(3.0F);
  EXPECT_GT(living.step(1.59F).work.counts.detectorRuns, 0);
  EXPECT_GT(living.step(1.59F).work.counts.detectorRuns, 0) << "until no more are found";

  PairOutcome outcome = living.step(1.5895F);
  EXPECT_EQ(outcome.work.counts.detectorRuns, 0);
  EXPECT_EQ(outcome.work.counts.recycled, outcome.work.manifolds);
  EXPECT_TRUE(outcome.touching);
  EXPECT_NEAR(living.press(), 0.0105F, 1e-4F);
  EXPECT_EQ(living.pair.origin, ContactOrigin::kRecycled);

  outcome = living.step(1.588F);
  EXPECT_GT(outcome.work.counts.detectorRuns, 0) << "too far from where they were found";
  EXPECT_NEAR(living.press(), 0.012F, 1e-4F);

  outcome = living.step(1.65F);
  EXPECT_FALSE(outcome.touching);
  EXPECT_EQ(living.engine.manifolds(), 0);
}

TEST(PairStep, AuditsLateWhereThereIsRoomForLateOnesAlone) {
  ThreeLevelPair living;
  ASSERT_TRUE(living.meetAndGoTo(2).credited);
  living.plan.auditsFrom = lod::lateness::kLate;
  EXPECT_FALSE(living.step(1.585F).audited) << "due, but not late";
  EXPECT_FALSE(living.step(1.54F).audited);
  const PairOutcome outcome = living.step(1.52F);
  EXPECT_TRUE(outcome.audited);
  EXPECT_LE(outcome.late, 0.0F);
  EXPECT_NEAR(living.pair.credit.gap, -0.08F, 1e-4F);
  for (const ChildPair& child : living.pair.parts.children())
    EXPECT_EQ(child.contact, nullptr) << "its coarser shapes do not collide in the place of the finest ones";
}

TEST(PairStep, CollidesItsCoarserShapesWhereNoAuditIsMade) {
  ThreeLevelPair living;
  ASSERT_TRUE(living.meetAndGoTo(2).credited);
  living.plan.auditsFrom = lod::lateness::kNever;
  EXPECT_LT(living.step(1.54F).late, lod::lateness::kLate);
  const PairOutcome outcome = living.step(1.52F);
  EXPECT_FALSE(outcome.audited);
  EXPECT_GE(outcome.late, lod::lateness::kLate);
  const PartPair::Children& children = living.pair.parts.children();
  EXPECT_TRUE(std::ranges::any_of(children, [](const ChildPair& child) { return child.contact != nullptr; }));
}

TEST(PairStep, WaitsForThoseThatHaveWaitedLonger) {
  ThreeLevelPair living;
  ASSERT_TRUE(living.meetAndGoTo(2).credited);
  living.plan.auditsFrom = 2.0F;
  const PairOutcome late = living.step(1.52F);
  EXPECT_FALSE(late.audited);
  EXPECT_GE(late.late, lod::lateness::kLate);
  EXPECT_LT(late.late, 2.0F);
  const PairOutcome outcome = living.step(1.45F);
  EXPECT_TRUE(outcome.audited);
  EXPECT_LE(outcome.late, 0.0F);
}

TEST(PairStep, RecyclesNothingOnCredit) {
  ThreeLevelPair living;
  living.steps.recycling = 0.001F;
  EXPECT_TRUE(living.meetAndGoTo(1).credited);
  for (int i = 0; i < 5; ++i) {
    living.plan.target = 2;
    EXPECT_EQ(living.step(1.59F - 0.0001F * static_cast<float>(i)).work.counts.recycled, 0);
  }
}

TEST(PairStep, StaysWhereASwitchIsNotSafe) {
  ThreeLevelPair living;
  living.plan.rules.credit = false;
  const PairOutcome outcome = living.meetAndGoTo(1);
  EXPECT_EQ(outcome.choice.kind, SwitchKind::kBlocked);
  EXPECT_EQ(outcome.choiceQueries, 2);
  EXPECT_EQ(living.plan.view.level, kFinest);
  EXPECT_TRUE(outcome.touching);
}

TEST(PairStep, KeepsItsContactsUntilItHasMovedTooFar) {
  ThreeLevelPair living;
  living.step(3.0F);
  const int looked = living.step(1.59F).work.counts.detectorRuns;
  EXPECT_GT(looked, 0);
  living.plan.keepsFrom = 0;
  const PairOutcome kept = living.step(1.58F);
  EXPECT_TRUE(kept.work.reuses);
  EXPECT_EQ(kept.work.counts.detectorRuns, 0);
  EXPECT_TRUE(kept.touching);
  EXPECT_NEAR(living.press(), 0.02F, 1e-4F) << "where the bodies are now";
  // As far as between two audits, from where it was looked at.
  living.plan.auditDistance = 0.02F;
  EXPECT_TRUE(living.step(1.575F).work.reuses);
  EXPECT_FALSE(living.step(1.569F).work.reuses);
  EXPECT_TRUE(living.step(1.56F).work.reuses);
  EXPECT_FALSE(living.step(1.5F).work.reuses);
}

TEST(PairStep, PressesAtItsFinestLevelWhatPressedBefore) {
  ThreeLevelPair living;
  living.meetAndGoTo(2);
  EXPECT_NEAR(living.press(), 0.01F, 1e-4F) << "the contacts that it holds";
  living.plan.target = kFinest;
  PairOutcome outcome = living.step(1.59F);
  EXPECT_EQ(outcome.choice.kind, SwitchKind::kOnCredit);
  EXPECT_FALSE(outcome.isUnsafe);
  EXPECT_NEAR(living.press(), 0.01F, 1e-4F);
}

// Bodies that began deep in each other: at a coarser level only the contacts that are held drive them apart.
TEST(PairStep, ComesBackHoweverDeepWhatItHoldsPresses) {
  ThreeLevelPair living;
  constexpr float kDeep = 1.35F;
  living.step(3.0F);
  living.step(kDeep);
  const float pressed = living.press();
  ASSERT_GT(pressed, 0.2F);
  living.plan.target = 2;
  ASSERT_EQ(living.step(kDeep).choice.kind, SwitchKind::kOnCredit);
  living.plan.target = kFinest;
  const PairOutcome outcome = living.step(kDeep);
  EXPECT_EQ(outcome.choice.kind, SwitchKind::kOnCredit);
  EXPECT_FALSE(outcome.isUnsafe);
  EXPECT_NEAR(living.press(), pressed, 1e-3F);
  living.step(kDeep + 0.01F);
  EXPECT_NEAR(living.press(), pressed - 0.01F, 1e-3F) << "it goes on coming apart";
}

TEST(PairStep, WaitsWhereMoreOverlapsThanIsPressed) {
  ThreeLevelPair living;
  ASSERT_TRUE(living.meetAndGoTo(2).credited);
  living.plan.auditsFrom = lod::lateness::kNever;
  living.step(1.56F);
  living.pair.held.release(living.engine);
  living.plan.target = kFinest;
  EXPECT_EQ(living.step(1.56F).choice.kind, SwitchKind::kBlocked);
  EXPECT_EQ(living.step(1.585F).choice.kind, SwitchKind::kOnCredit) << "a little";
}

TEST(PairStep, PressesWhatSinksOnceItHasSettled) {
  ThreeLevelPair living;
  living.step(3.0F);
  living.plan.target = 2;
  living.plan.rules.safe = false;
  living.step(1.7F);
  living.plan.rules.safe = true;
  // Nothing is held, and the finest shapes overlap: all of it is credit.
  living.plan.target = kFinest;
  const PairOutcome outcome = living.step(1.59F);
  ASSERT_EQ(outcome.choice.kind, SwitchKind::kOnCredit);
  EXPECT_EQ(living.press(), 0.0F);
  for (int i = 0; i < 5; ++i) living.step(1.588F);
  EXPECT_EQ(living.press(), 0.0F) << "it settles";
  for (int i = 0; i < 10; ++i) living.step(1.588F);
  EXPECT_NEAR(living.press(), 0.002F, 1e-4F);
}

TEST(PairStep, KeepsItsFinestContactsOnCreditWithTheirCredit) {
  ThreeLevelPair living;
  living.step(3.0F);
  living.plan.target = 2;
  living.plan.rules.safe = false;
  living.step(1.7F);
  living.plan.rules.safe = true;
  living.plan.target = kFinest;
  ASSERT_TRUE(living.step(1.59F).credited);
  living.plan.keepsFrom = 0;
  PairOutcome outcome = living.step(1.591F);
  EXPECT_TRUE(outcome.work.reuses);
  EXPECT_TRUE(outcome.credited);
  EXPECT_EQ(living.press(), 0.0F);
  // Credit shrinks with the overlap, and what sinks in again once it has settled is pressed.
  for (int i = 0; i < 15; ++i) outcome = living.step(1.588F);
  EXPECT_TRUE(outcome.work.reuses);
  EXPECT_NEAR(living.press(), 0.003F, 1e-4F);
}

TEST(PairStep, LeavesShapesThatAreNoPartListsToTheEngine) {
  ThreeLevelPair living;
  living.step(3.0F);
  living.step(1.59F);
  EXPECT_GT(living.engine.manifolds(), 0);
  living.engine.refuses = true;
  living.step(1.59F);
  EXPECT_EQ(living.engine.fallbacks, 1);
  EXPECT_EQ(living.engine.manifolds(), 0);
  EXPECT_FALSE(living.isQuiet());
  living.engine.refuses = false;
  EXPECT_TRUE(living.step(1.59F).touching);
  EXPECT_TRUE(living.pair.restarted);
}

TEST(PairStep, BeginsAnewWithNewParts) {
  ThreeLevelPair living;
  living.step(3.0F);
  living.step(1.59F);
  living.step(1.59F);
  EXPECT_FALSE(living.pair.restarted);
  ++living.engine.version;
  EXPECT_TRUE(living.step(1.59F).touching);
  EXPECT_TRUE(living.pair.restarted);
}

// What is on credit, and held, is of parts that may be gone.
TEST(PairStep, GivesCreditAnewToNewParts) {
  ThreeLevelPair living;
  ASSERT_TRUE(living.meetAndGoTo(2).credited);
  constexpr std::uint16_t kGone = 999;
  living.pair.credit.account.grant(kGone, kGone, 0.1F, 0.0F);
  ++living.engine.version;
  const PairOutcome outcome = living.step(1.59F);
  EXPECT_TRUE(living.pair.restarted);
  EXPECT_TRUE(outcome.credited);
  EXPECT_FALSE(outcome.isUnsafe);
  EXPECT_EQ(living.pair.credit.account.of(kGone, kGone), 0.0F);
  EXPECT_NEAR(living.press(), 0.01F, 1e-4F) << "what the finest shapes have is found anew";
}

TEST(PairStep, HasNoCreditForNewPartsAtItsFinestLevel) {
  ThreeLevelPair living;
  ASSERT_TRUE(living.meetAndGoTo(2).credited);
  living.step(1.58F);
  living.plan.target = kFinest;
  living.step(1.58F);
  ASSERT_EQ(living.pair.credit.kind, CreditKind::kFinest);
  ++living.engine.version;
  living.step(1.58F);
  EXPECT_EQ(living.pair.credit.kind, CreditKind::kNone);
  EXPECT_TRUE(living.pair.credit.account.empty());
}

TEST(PairStep, CountsItsOwnWorkOnly) {
  ThreeLevelPair living;
  living.step(3.0F);
  const PairWork before = living.work;
  const PairOutcome outcome = living.step(1.59F);
  const PairWork own = living.work - before;
  EXPECT_EQ(own.detectorRuns, outcome.work.counts.detectorRuns);
  EXPECT_EQ(own.childPairs, outcome.work.counts.childPairs);
  EXPECT_EQ(own.pairs, 1);
}

// The law that switching stands on, on random walks in and out of each other at random wishes.
TEST(PairStep, NeverPressesByASwitch) {
  testing::Random random(7);
  for (int trial = 0; trial < 200; ++trial) {
    ThreeLevelPair living;
    living.steps.recycling = trial % 2 == 0 ? 0.0F : 0.001F;
    float x = random.uniform(1.7F, 2.5F);
    for (int step = 0; step < 120; ++step) {
      // Solvers keep bodies from sinking into each other.
      x = std::max(x + random.uniform(-0.02F, 0.018F), 1.57F);
      if (step % 5 == 0) living.plan.target = 1 + static_cast<int>(random.uniform(0.0F, 2.999F));
      constexpr float kFrom[] = {lod::lateness::kDue, lod::lateness::kLate, 2.0F, lod::lateness::kNever};
      living.plan.auditsFrom = kFrom[static_cast<int>(random.uniform(0.0F, 3.999F))];
      const PairOutcome outcome = living.step(x);
      EXPECT_FALSE(outcome.isUnsafe) << "trial " << trial << ", step " << step;
      EXPECT_EQ(outcome.credited, !living.pair.credit.account.empty());
    }
  }
}

}  // namespace
}  // namespace scatter::pairs
