#include "pairs/ground_step.h"

#include <gtest/gtest.h>

#include <memory>

#include "collision/geometry.h"
#include "pairs/contact_credit.h"
#include "pairs/fake_ground_engine.h"

namespace scatter::pairs {
namespace {

using lod::SwitchKind;
using testing::boxPart;
using testing::FakeGroundEngine;

constexpr int kFinestLevel = 3;

// Each level within the one before: the lowest points are 1, 0.9 and 0.8 m under the middle.
std::vector<std::vector<PartDef>> threeLevelsOverGround() {
  const Mat3 upright(1.0F);
  const auto box = [&upright](float x, float y, float z, float half) {
    return boxPart(Vec3(x, y, z), Vec3(half), upright, 0.01F);
  };
  std::vector<std::vector<PartDef>> levels(3);
  levels[0] = {box(0.0F, 0.0F, 0.0F, 1.0F)};
  for (const float x : {-0.45F, 0.45F}) {
    for (const float z : {-0.45F, 0.45F}) levels[1].push_back(box(x, -0.45F, z, 0.45F));
    for (const float z : {-0.6F, -0.2F, 0.2F, 0.6F}) levels[2].push_back(box(x, -0.6F, z, 0.2F));
  }
  return levels;
}

/// A body over a ground, and what its planner knows of it.
struct LivingGround {
  explicit LivingGround(bool isNet, const std::vector<std::vector<PartDef>>& levels = threeLevelsOverGround())
      : engine(levels, isNet) {
    plan.view.finest = kFinestLevel;
    plan.target = kFinestLevel;
  }
  LivingGround(const LivingGround&) = delete;
  LivingGround& operator=(const LivingGround&) = delete;
  ~LivingGround() { pair.restart(0.0F, engine); }

  PairOutcome step(const Vec3& position) {
    engine.position = position;
    plan.tries = plan.target != plan.view.level;
    work = {};
    const PairOutcome outcome = stepGround(pair, plan, steps, engine, scratch, work);
    if (outcome.tried) plan.view.level = static_cast<std::uint8_t>(outcome.choice.level);
    plan.view.touching = outcome.touching;
    return outcome;
  }
  PairOutcome stepAt(float y) { return step(Vec3(0.0F, y, 0.0F)); }

  [[nodiscard]] float press() const {
    float most = 0.0F;
    for (const GroundContact& contact : pair.contacts)
      most = std::max(most, -engine.point(contact.manifold, 0).distance);
    return most;
  }
  [[nodiscard]] bool isQuiet() {
    PlacedBody placed;
    EXPECT_TRUE(engine.place(pair.level, placed));
    return staysQuiet(pair, placed, engine.groundFrame(), engine.groundVersion(), glm::length(engine.ahead));
  }

  FakeGroundEngine engine;
  GroundPair pair;
  StepScratch scratch;
  PairSteps steps;
  PairWork work;
  PairPlan plan;
};

class GroundStep : public ::testing::TestWithParam<bool> {
 protected:
  LivingGround body{GetParam()};
};

TEST_P(GroundStep, TouchesWithThePartsThatAreNear) {
  body.stepAt(1.0F);
  EXPECT_TRUE(body.pair.contacts.empty());
  body.stepAt(0.815F);
  EXPECT_EQ(body.pair.contacts.size(), 8U);
  body.stepAt(0.83F);
  EXPECT_TRUE(body.pair.contacts.empty());
}

TEST_P(GroundStep, IsQuietAsLongAsNothingCanTouch) {
  body.stepAt(1.5F);
  for (float y = 1.45F; y > 0.8F; y -= 0.01F) {
    body.engine.position.y = y;
    if (!body.isQuiet()) body.step(body.engine.position);
    EXPECT_EQ(body.pair.contacts.empty(), y > 0.82F) << y;
  }
  EXPECT_FALSE(body.isQuiet()) << "it touches";
}

// The memory of a pair that has ended is another one's.
TEST(GroundPair, ForgetsThePiecesOfTheOneBefore) {
  LivingGround body(true);
  body.stepAt(0.8F);
  EXPECT_FALSE(body.pair.region.empty());
  body.pair.restart(0.0F, body.engine);
  body.pair.renew();
  EXPECT_TRUE(body.pair.region.empty());
}

// A random walk, in which every part is compared with the truth in every step.
TEST_P(GroundStep, MissesNothingOnTheWay) {
  testing::Random random(7);
  Vec3 position(0.0F, 0.9F, 0.0F);
  long touching = 0;
  for (int i = 0; i < 3000; ++i) {
    position += Vec3(random.uniform(-0.2F, 0.2F), random.uniform(-0.02F, 0.02F), random.uniform(-0.2F, 0.2F));
    position.y = std::clamp(position.y, 0.75F, 1.1F);
    body.engine.position = position;
    if (i == 0 || !body.isQuiet()) body.step(position);
    std::size_t near = 0;
    for (int part = 0; part < body.engine.countParts(); ++part)
      near += body.engine.heightOf(part) < 0.0199F ? 1 : 0;
    ASSERT_GE(body.pair.contacts.size(), near) << "step " << i;
    touching += static_cast<long>(near);
  }
  EXPECT_GT(touching, 1000);
}

TEST_P(GroundStep, KeepsItsContactsUntilTheBodyHasMovedTooFar) {
  body.plan.auditDistance = 0.02F;
  body.stepAt(0.79F);
  body.stepAt(0.79F);
  const std::size_t contacts = body.pair.contacts.size();
  ASSERT_GT(contacts, 0U);
  body.plan.keepsFrom = 0;
  const PairOutcome kept = body.stepAt(0.78F);
  EXPECT_TRUE(kept.work.reuses);
  EXPECT_EQ(body.pair.contacts.size(), contacts);
  EXPECT_TRUE(kept.touching);
  EXPECT_TRUE(body.stepAt(0.775F).work.reuses);
  // 2.5 cm from where it was looked at.
  EXPECT_FALSE(body.stepAt(0.765F).work.reuses);
  EXPECT_TRUE(body.stepAt(0.764F).work.reuses);
  body.plan.keepsFrom = PairPlan::kNever;
  EXPECT_FALSE(body.stepAt(0.764F).work.reuses);
}

TEST(GroundRegion, IsLookedUpOncePerSkin) {
  LivingGround body(true);
  for (int i = 0; i < 100; ++i) body.step(Vec3(0.01F * static_cast<float>(i), 0.81F, 0.0F));
  // A quarter of the radius of about 1.1 m is used up four times a metre.
  EXPECT_LE(body.engine.lookups, 6);
  EXPECT_GE(body.engine.lookups, 2);
}

TEST(GroundRegion, IsNotLookedUpAnewForAFinerLevel) {
  LivingGround body(true);
  body.plan.target = 1;
  for (int i = 0; i < 3; ++i) body.stepAt(1.0F);
  ASSERT_EQ(body.plan.view.level, 1);
  const int before = body.engine.lookups;
  body.plan.target = kFinestLevel;
  for (int i = 0; i < 3; ++i) body.stepAt(0.81F);
  EXPECT_EQ(body.plan.view.level, kFinestLevel);
  EXPECT_FALSE(body.pair.contacts.empty());
  EXPECT_EQ(body.engine.lookups, before);
  ++body.engine.version;
  body.stepAt(0.81F);
  EXPECT_GT(body.engine.lookups, before) << "another ground";
}

// Not even where it ends: on an endless net a body looks up what is near, again and again.
TEST(GroundRegion, OfASmallGroundIsShared) {
  LivingGround onEndlessNet(true);
  LivingGround bodies[]{LivingGround(true), LivingGround(true)};
  GroundPieces net;
  onEndlessNet.engine.end = 4;
  ASSERT_TRUE(onEndlessNet.engine.collect(Vec3(-4.0F), Vec3(4.0F), net));
  onEndlessNet.engine.end = 1000;
  const auto whole = std::make_shared<const WholeGround>(net);
  for (LivingGround& body : bodies) {
    body.pair.region.share(whole, &body == bodies);
    body.pair.versions[1] = body.engine.version;
  }
  int lookedUp[2]{};
  for (int i = 0; i < 160; ++i) {
    const Vec3 position(0.01F * static_cast<float>(i) - 0.8F, 0.79F, 0.005F * static_cast<float>(i) - 0.4F);
    onEndlessNet.step(position);
    for (const std::size_t k : {0U, 1U}) {
      bodies[k].step(position);
      lookedUp[k] += bodies[k].work.pieces;
      ASSERT_EQ(bodies[k].pair.contacts.size(), onEndlessNet.pair.contacts.size()) << i;
      EXPECT_FLOAT_EQ(bodies[k].press(), onEndlessNet.press());
    }
  }
  EXPECT_FALSE(onEndlessNet.pair.contacts.empty());
  EXPECT_GT(onEndlessNet.engine.lookups, 2);
  EXPECT_EQ(bodies[0].engine.lookups + bodies[1].engine.lookups, 0);
  EXPECT_EQ(lookedUp[0], 128) << "once, for the first of them";
  EXPECT_EQ(lookedUp[1], 0);
  ++bodies[0].engine.version;
  bodies[0].step(Vec3(0.0F, 0.79F, 0.0F));
  EXPECT_EQ(bodies[0].engine.lookups, 1) << "another ground";
  EXPECT_FALSE(bodies[0].pair.contacts.empty());
}

/// Two plates of 4 cm, one beside the other, that go 60 cm a step.
struct FastPlates : LivingGround {
  explicit FastPlates(bool holds) : LivingGround(true, plates()) {
    steps.passages = holds;
    engine.ahead = Vec3(0.0F, -0.6F, 0.0F);
    for (const float y : {2.5F, 1.9F, 1.3F, 0.7F}) stepAt(y);
  }

  static std::vector<std::vector<PartDef>> plates() {
    std::vector<std::vector<PartDef>> levels(3);
    for (auto& level : levels) {
      for (const float x : {-0.3F, 0.3F})
        level.push_back(boxPart(Vec3(x, 0.0F, 0.0F), Vec3(0.3F, 0.02F, 0.3F), Mat3(1.0F), 0.01F));
    }
    return levels;
  }
};

// In the step before they would be through, they may come as far as the ground.
TEST(GroundStep, HoldsWhatIsAboutToPassThroughItsTriangles) {
  FastPlates plates(true);
  EXPECT_TRUE(plates.pair.contacts.empty());
  plates.stepAt(0.1F);
  ASSERT_EQ(plates.pair.contacts.size(), 2U);
  EXPECT_NEAR(plates.press(), 0.0F, 1e-4F);
  for (const GroundContact& contact : plates.pair.contacts)
    EXPECT_NEAR(plates.engine.point(contact.manifold, 0).distance, 0.08F, 1e-4F);
  EXPECT_FALSE(plates.isQuiet());
  // Nor does it stay quiet where it is apart now and would not be then.
  plates.engine.ahead = Vec3(0.0F);
  plates.stepAt(0.11F);
  plates.stepAt(0.11F);
  EXPECT_TRUE(plates.isQuiet());
  plates.engine.ahead = Vec3(0.0F, -0.6F, 0.0F);
  EXPECT_FALSE(plates.isQuiet());
}

TEST(GroundStep, HoldsWhatHasPassedThroughItsTriangles) {
  for (const bool holds : {true, false}) {
    FastPlates plates(holds);
    plates.stepAt(0.1F);
    plates.stepAt(-0.5F);
    EXPECT_EQ(plates.pair.contacts.size(), holds ? 2U : 0U);
    if (!holds) continue;
    // No deeper than a body that is half through, for as long as its middle is below.
    EXPECT_NEAR(plates.press(), 0.02F, 1e-4F);
    EXPECT_FALSE(plates.isQuiet());
    plates.engine.ahead = Vec3(0.0F, 0.1F, 0.0F);
    plates.stepAt(-0.01F);
    EXPECT_NEAR(plates.press(), 0.02F, 1e-4F);
    plates.stepAt(0.01F);
    EXPECT_FALSE(plates.pair.passage.open());
    plates.stepAt(0.1F);
    EXPECT_TRUE(plates.pair.contacts.empty());
  }
}

// A program may turn it off, and the piece that holds the body is not known any more once others are looked
// up.
TEST(GroundStep, HoldsNothingOnceItIsNotToAnyMore) {
  FastPlates plates(true);
  plates.stepAt(0.1F);
  plates.stepAt(-0.5F);
  ASSERT_TRUE(plates.pair.passage.open());
  plates.steps.passages = false;
  plates.stepAt(-0.5F);
  EXPECT_FALSE(plates.pair.passage.holds());
}

TEST(GroundRegion, OfTooManyPiecesIsTheEnginesWhileItHasContacts) {
  LivingGround body(true);
  body.engine.isTooFine = true;
  for (int i = 0; i < 5; ++i) body.stepAt(0.8F);
  EXPECT_EQ(body.engine.fallbacks, 5);
  EXPECT_EQ(body.engine.lookups, 1);
  body.engine.isTooFine = false;
  body.stepAt(1.2F);
  body.stepAt(0.81F);
  EXPECT_EQ(body.engine.fallbacks, 6);
  EXPECT_EQ(body.pair.contacts.size(), 8U);
}

TEST_P(GroundStep, SwitchesOnCreditWithoutPressing) {
  body.stepAt(0.815F);
  body.stepAt(0.795F);
  const float before = body.press();
  body.plan.target = 2;
  const PairOutcome outcome = body.stepAt(0.795F);
  EXPECT_EQ(outcome.choice.level, 2);
  EXPECT_EQ(outcome.choice.kind, SwitchKind::kOnCredit);
  EXPECT_TRUE(outcome.credited);
  EXPECT_FALSE(outcome.isUnsafe);
  EXPECT_NEAR(body.press(), before, 1e-4F);
  // It bears the body where the finest shapes did.
  body.stepAt(0.79F);
  EXPECT_NEAR(body.press(), before + 0.005F, 1e-4F);
  // What has come apart touches as usual from then on.
  body.stepAt(1.0F);
  body.stepAt(0.89F);
  EXPECT_NEAR(body.press(), 0.01F, 1e-3F);
}

TEST_P(GroundStep, KeepsItsCreditWhenItsPointsAreLost) {
  body.stepAt(0.8F);
  body.plan.target = 2;
  body.stepAt(0.8F);
  body.engine.losesPoints = true;
  for (int i = 1; i <= 10; ++i) {
    const PairOutcome outcome = body.step(Vec3(0.1F * static_cast<float>(i), 0.8F, 0.0F));
    EXPECT_TRUE(outcome.credited) << i;
    EXPECT_NEAR(body.press(), 0.0F, 1e-4F) << i;
  }
  // Without an overlap there is nothing to give credit for.
  body.stepAt(1.5F);
  EXPECT_TRUE(body.pair.contacts.empty());
}

TEST_P(GroundStep, PressesAfterASwitchOnlyWhereItPressedBefore) {
  std::vector<std::vector<PartDef>> levels = threeLevelsOverGround();
  levels[2][0] = boxPart(Vec3(-0.6F, -0.61F, -0.6F), Vec3(0.2F), Mat3(1.0F), 0.01F);
  LivingGround leaning(GetParam(), levels);
  leaning.stepAt(0.803F);
  ASSERT_NEAR(leaning.press(), 0.007F, 1e-4F);
  leaning.plan.target = 2;
  leaning.stepAt(0.803F);
  int pressing = 0;
  for (const GroundContact& contact : leaning.pair.contacts) {
    const float depth = -leaning.engine.point(contact.manifold, 0).distance;
    EXPECT_LE(depth, 0.007F + 1e-4F);
    pressing += depth > 0.001F ? 1 : 0;
  }
  EXPECT_EQ(leaning.pair.contacts.size(), 4U);
  EXPECT_EQ(pressing, 1);
}

// From the middle level, a tenth of a metre above where the finest shapes touch, it falls in one step.
TEST_P(GroundStep, LandsWithoutBeingDrivenOutAfterItWentFiner) {
  body.plan.target = 2;
  body.stepAt(1.0F);
  ASSERT_EQ(body.plan.view.level, 2);
  body.stepAt(0.9F);
  body.plan.target = kFinestLevel;
  ASSERT_EQ(body.stepAt(0.895F).choice.level, kFinestLevel);
  const PairOutcome landed = body.stepAt(0.79F);
  EXPECT_EQ(body.pair.contacts.size(), 8U);
  EXPECT_NEAR(body.press(), 0.0F, 1e-4F);
  EXPECT_TRUE(landed.credited);
  // It bears the body there, and what sinks deeper is pressed as usual.
  body.stepAt(0.785F);
  EXPECT_NEAR(body.press(), 0.005F, 1e-4F);
}

TEST_P(GroundStep, IsPressedAsUsualOnceItHasLanded) {
  body.plan.target = 2;
  body.stepAt(1.0F);
  body.plan.target = kFinestLevel;
  body.stepAt(0.95F);
  for (int i = 0; i < 20; ++i) body.stepAt(0.799F);
  body.stepAt(1.2F);
  body.stepAt(0.79F);
  EXPECT_NEAR(body.press(), 0.01F, 1e-4F);
}

TEST_P(GroundStep, NeverPressesByASwitch) {
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    LivingGround walker(GetParam());
    testing::Random random(seed);
    float y = random.uniform(0.78F, 1.05F);
    for (int i = 0; i < 60; ++i) {
      y = std::clamp(y + random.uniform(-0.02F, 0.02F), 0.75F, 1.1F);
      const float stays = walker.press();
      const float moved = walker.engine.position.y - y;
      const bool wasTouching = i > 0 && !walker.pair.contacts.empty();
      walker.plan.target =
          i % 7 == 3 ? 2 + static_cast<int>(random.uniform(0.0F, 1.999F)) : walker.plan.view.level;
      if (i == 0) walker.plan.target = 2;
      const int before = walker.plan.view.level;
      const PairOutcome outcome = walker.stepAt(y);
      EXPECT_FALSE(outcome.isUnsafe) << "seed " << seed << ", step " << i;
      if (walker.plan.view.level == before || before == 0) continue;
      const float allowed = wasTouching ? std::max(stays + moved, 0.0F) : 0.0F;
      EXPECT_LE(walker.press(), allowed + kTolerance) << "seed " << seed << ", step " << i;
    }
  }
}

TEST_P(GroundStep, BeginsAtACoarseLevelOnlyWhereItIsApart) {
  body.plan.target = 2;
  EXPECT_EQ(body.stepAt(0.85F).choice.level, kFinestLevel);
  LivingGround apart(GetParam());
  apart.plan.target = 2;
  EXPECT_EQ(apart.stepAt(0.95F).choice.level, 2);
}

TEST_P(GroundStep, WithoutCreditStaysWhereItIs) {
  body.stepAt(0.81F);
  body.plan.rules.credit = false;
  body.plan.target = 2;
  const PairOutcome outcome = body.stepAt(0.81F);
  EXPECT_EQ(outcome.choice.kind, SwitchKind::kBlocked);
  EXPECT_EQ(body.plan.view.level, kFinestLevel);
  EXPECT_EQ(body.pair.contacts.size(), 8U);
  EXPECT_EQ(body.stepAt(1.2F).choice.kind, SwitchKind::kFree);
}

TEST_P(GroundStep, LeavesWhatItDoesNotKnowToTheEngine) {
  body.stepAt(0.81F);
  body.engine.refuses = true;
  body.stepAt(0.81F);
  EXPECT_EQ(body.engine.fallbacks, 1);
  EXPECT_TRUE(body.pair.contacts.empty());
  body.engine.refuses = false;
  body.stepAt(0.81F);
  EXPECT_EQ(body.engine.fallbacks, 1);
  EXPECT_EQ(body.pair.contacts.size(), 8U);
}

TEST_P(GroundStep, StartsAnewWhenTheGroundChanges) {
  body.stepAt(0.81F);
  EXPECT_TRUE(body.pair.restarted);
  body.stepAt(0.81F);
  EXPECT_FALSE(body.pair.restarted);
  ++body.engine.version;
  body.stepAt(0.81F);
  EXPECT_TRUE(body.pair.restarted);
  EXPECT_EQ(body.pair.contacts.size(), 8U);
}

TEST_P(GroundStep, LetsContactsMoveAlongWithABodyThatHardlyMoves) {
  body.steps.recycling = 0.001F;
  body.stepAt(0.79F);
  body.stepAt(0.79F);
  EXPECT_EQ(body.work.recycled, 0) << "a look must have found nothing new";
  body.stepAt(0.7895F);
  EXPECT_EQ(body.work.recycled, 8);
  EXPECT_EQ(body.work.detectorRuns + body.work.halfSpaceRuns + body.work.gjkRuns, 0);
  EXPECT_TRUE(body.pair.hasRecycled);
  EXPECT_NEAR(body.press(), 0.0105F, 1e-5F);
  body.stepAt(0.7885F);
  EXPECT_EQ(body.work.recycled, 0) << "further than the tolerance from the last look";
  EXPECT_NEAR(body.press(), 0.0115F, 1e-5F);
  body.stepAt(0.83F);
  EXPECT_TRUE(body.pair.contacts.empty());
}

TEST_P(GroundStep, RecyclesNothingWithoutBeingAsked) {
  for (int i = 0; i < 5; ++i) body.stepAt(0.81F);
  EXPECT_EQ(body.work.recycled, 0);
  EXPECT_FALSE(body.pair.hasRecycled);
}

TEST_P(GroundStep, RecyclesNothingOnCredit) {
  body.steps.recycling = 0.001F;
  body.stepAt(0.8F);
  body.plan.target = 2;
  for (int i = 0; i < 5; ++i) {
    EXPECT_TRUE(body.stepAt(0.8F).credited);
    EXPECT_EQ(body.work.recycled, 0);
  }
}

TEST_P(GroundStep, RecyclesNothingOnAGroundThatHasChanged) {
  body.steps.recycling = 0.001F;
  for (int i = 0; i < 3; ++i) body.stepAt(0.81F);
  EXPECT_EQ(body.work.recycled, 8);
  ++body.engine.version;
  body.stepAt(0.81F);
  EXPECT_EQ(body.work.recycled, 0);
}

// A random walk: what begins is found a quarter of the threshold or a millimetre late, whichever is less.
TEST_P(GroundStep, FindsWhatBeginsHardlyLaterWhenItRecycles) {
  constexpr float kLate = 0.001F;
  body.steps.recycling = kLate;
  testing::Random random(11);
  Vec3 position(0.0F, 0.9F, 0.0F);
  int recycled = 0;
  for (int i = 0; i < 3000; ++i) {
    const float stride = i % 3 == 0 ? 0.02F : 0.0004F;
    for (int axis = 0; axis < 3; ++axis) position[axis] += random.uniform(-stride, stride);
    position.y = std::clamp(position.y, 0.75F, 0.85F);
    body.step(position);
    recycled += body.work.recycled;
    std::size_t near = 0;
    for (int part = 0; part < body.engine.countParts(); ++part)
      near += body.engine.heightOf(part) < 0.0199F - kLate ? 1 : 0;
    ASSERT_GE(body.pair.contacts.size(), near) << "step " << i;
  }
  EXPECT_GT(recycled, 1000);
}

INSTANTIATE_TEST_SUITE_P(Grounds, GroundStep, ::testing::Bool(),
                         [](const auto& kind) { return kind.param ? "Net" : "HalfSpace"; });

TEST(CoarsestOnGround, IsTheMiddleLevel) {
  EXPECT_EQ(coarsestOnGround(1), 1);
  EXPECT_EQ(coarsestOnGround(2), 2);
  EXPECT_EQ(coarsestOnGround(3), 2);
  EXPECT_EQ(coarsestOnGround(5), 3);
}

}  // namespace
}  // namespace scatter::pairs
