#include "collision/part_pair.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

#include "collision/geometry.h"
#include "collision/reference_distance.h"

namespace scatter {
namespace {

using testing::boxPart;
using testing::capsulePart;
using testing::enclosedPart;
using testing::frameOf;
using testing::hullPart;
using testing::placed;
using testing::Random;
using testing::randomCore;
using testing::randomFrame;
using testing::randomParts;
using testing::referenceDistance;
using testing::spherePart;

constexpr float kThreshold = 0.02F;
const Mat3 kUpright(1.0F);

static_assert(sizeof(void*) != 8 || sizeof(ChildPair) == 56, "memory per child pair is a promise");

/// Two bodies and what they know of each other. A is at the world's origin unless it is moved.
struct TwoBodies {
  TwoBodies(const PartList& listA, const PartList& listB) : a(listA), b(listB) {
    pair.reset(kThreshold);
    a.moveTo(Frame{});
  }

  bool advance(const Frame& frameB) {
    b.moveTo(frameB);
    return pair.advance(a, b, steps, scratch, work);
  }
  bool advance(const Vec3& originB) { return advance(frameOf(kNoRotation, originB)); }

  ChildVerdict judge(ChildPair& child) { return pair.judge(child, a, b, steps, contact, work); }
  void settle() { pair.settle(a, b, steps); }

  PartBody a;
  PartBody b;
  PartPair pair;
  PairSteps steps;
  PairWork work;
  PairScratch scratch;
  PartContact contact;
};

PartList only(const PartDef& part) {
  return PartList(std::vector{part});
}

/// What is judged of two parts, the second so far to the right.
ChildVerdict verdictAt(const PartDef& a, const PartDef& b, float right, TwoBodies* keep = nullptr) {
  const PartList listA = only(a);
  const PartList listB = only(b);
  TwoBodies bodies(listA, listB);
  // The axes of the boxes would settle it before GJK is asked.
  bodies.steps.cachedAxis = false;
  if (!bodies.advance(Vec3(right, 0.0F, 0.0F))) return ChildVerdict::kApart;
  const ChildVerdict verdict = bodies.judge(bodies.pair.children()[0]);
  if (keep != nullptr) keep->contact = bodies.contact;
  return verdict;
}

TEST(PartPair, JudgesHullsByTheirDistance) {
  Random random(91);
  int contacts = 0;
  for (int round = 0; round < 2000; ++round) {
    const float marginA = random.uniform(0.0F, 0.1F);
    const float marginB = random.uniform(0.0F, 0.1F);
    const PartList listA = only(hullPart(randomCore(random, 30, 1.0F), marginA));
    const PartList listB = only(hullPart(randomCore(random, 30, 1.0F), marginB));
    TwoBodies bodies(listA, listB);
    Frame frameB = frameOf(random.rotation(), random.direction() * 5.0F);
    const auto outlines = [&] {
      return referenceDistance(placed(Frame{}, listA.part(0).core), placed(frameB, listB.part(0).core));
    };
    // Moved against the axis, they come nearer by just as much.
    const auto far = outlines();
    const float gap = random.uniform(0.2F, 1.1F) * (marginA + marginB + kThreshold);
    frameB.origin -= Vec3(far.axis * (far.upper - static_cast<double>(gap)));
    const auto truth = outlines();
    const double distance = truth.upper - static_cast<double>(marginA + marginB);
    const bool isAwake = bodies.advance(frameB);
    ASSERT_TRUE(isAwake || distance >= static_cast<double>(kThreshold)) << "round " << round;
    if (!isAwake || truth.lower < 1e-3) continue;
    const ChildVerdict verdict = bodies.judge(bodies.pair.children()[0]);
    if (distance > static_cast<double>(kThreshold) + 1e-3) {
      EXPECT_EQ(verdict, ChildVerdict::kApart) << "round " << round;
    } else if (distance < static_cast<double>(kThreshold) - 1e-3) {
      ASSERT_EQ(verdict, ChildVerdict::kContact) << "round " << round << ", " << distance;
      ++contacts;
      EXPECT_NEAR(static_cast<double>(bodies.contact.distance), distance, 1e-3) << "round " << round;
      EXPECT_NEAR(glm::length(bodies.contact.axis), 1.0F, 1e-5F);
      // The point is so far from B's core as the margin, and the distance further from A's surface.
      const auto toB =
          referenceDistance({glm::dvec3(bodies.contact.pointB)}, placed(frameB, listB.part(0).core));
      EXPECT_NEAR(toB.upper, static_cast<double>(marginB), 1e-3) << "round " << round;
      if (truth.lower < static_cast<double>(marginB)) continue;  // the point is in A's core
      const auto toA =
          referenceDistance({glm::dvec3(bodies.contact.pointB)}, placed(Frame{}, listA.part(0).core));
      EXPECT_NEAR(toA.upper - static_cast<double>(marginA), distance, 1e-3) << "round " << round;
    }
  }
  EXPECT_GT(contacts, 500);
}

TEST(PartPair, HasContactsWhetherCoresOverlapOrNot) {
  const PartDef cube = hullPart(testing::boxCorners(Vec3(1.0F)), 0.04F);
  const PartList list = only(cube);
  TwoBodies bodies(list, list);
  for (const float right : {0.5F, 1.9F, 2.05F, 2.09F}) {
    ASSERT_EQ(verdictAt(cube, cube, right, &bodies), ChildVerdict::kContact) << right;
    EXPECT_NEAR(bodies.contact.distance, right - 2.08F, 1e-4F);
    EXPECT_NEAR(bodies.contact.axis.x, 1.0F, 1e-4F);
    EXPECT_NEAR(bodies.contact.pointB.x, right - 1.04F, 1e-4F);
  }
  EXPECT_EQ(verdictAt(cube, cube, 2.11F), ChildVerdict::kApart) << "apart by 0.03";
}

TEST(PartPair, BoxesMeetAtTheirSharpEdges) {
  const PartDef box = boxPart(Vec3(0.0F), Vec3(1.0F), kUpright, 0.04F);
  EXPECT_EQ(verdictAt(box, box, 1.99F), ChildVerdict::kAskEngine);
  EXPECT_EQ(verdictAt(box, box, 2.01F), ChildVerdict::kApart) << "within the threshold, but not overlapping";
  const PartDef cube = hullPart(testing::boxCorners(Vec3(1.0F)), 0.0F);
  EXPECT_EQ(verdictAt(box, cube, 2.01F), ChildVerdict::kContact) << "of a box and a hull";
  EXPECT_EQ(verdictAt(cube, box, 2.01F), ChildVerdict::kContact);
  EXPECT_EQ(verdictAt(box, cube, 2.03F), ChildVerdict::kApart);
}

TEST(PartPair, SpheresAndCapsulesHaveContactsOfTheEnginesKind) {
  const PartDef ball = spherePart(Vec3(0.0F), 0.5F);
  EXPECT_EQ(verdictAt(ball, ball, 0.99F), ChildVerdict::kAskEngine);
  EXPECT_EQ(verdictAt(ball, ball, 1.01F), ChildVerdict::kApart) << "two spheres only when they overlap";
  const PartDef pill = capsulePart(Vec3(0, -1, 0), Vec3(0, 1, 0), 0.5F);
  EXPECT_EQ(verdictAt(pill, ball, 1.01F), ChildVerdict::kAskEngine);
  EXPECT_EQ(verdictAt(pill, pill, 1.01F), ChildVerdict::kAskEngine);
  EXPECT_EQ(verdictAt(pill, pill, 1.03F), ChildVerdict::kApart);
  const PartDef cube = hullPart(testing::boxCorners(Vec3(1.0F)), 0.0F);
  EXPECT_EQ(verdictAt(cube, ball, 1.51F), ChildVerdict::kContact);
  EXPECT_EQ(verdictAt(pill, cube, 1.51F), ChildVerdict::kContact);
  EXPECT_EQ(verdictAt(cube, ball, 1.53F), ChildVerdict::kApart);
}

TEST(PartPair, AContactOfAHullAndASphereIsExact) {
  const PartList unused = only(spherePart(Vec3(0.0F), 1.0F));
  TwoBodies keep(unused, unused);
  const PartDef cube = hullPart(testing::boxCorners(Vec3(1.0F)), 0.0F);
  ASSERT_EQ(verdictAt(cube, spherePart(Vec3(0.0F), 0.5F), 1.45F, &keep), ChildVerdict::kContact);
  EXPECT_NEAR(keep.contact.distance, -0.05F, 1e-4F);
  EXPECT_NEAR(keep.contact.axis.x, 1.0F, 1e-4F);
  EXPECT_NEAR(keep.contact.pointB.x, 0.95F, 1e-4F);
}

TEST(PartPair, AsksTheEngineAboutWhatIsOnlyEnclosed) {
  const PartDef rough = enclosedPart(testing::boxCorners(Vec3(1.0F)), 0.04F);
  const PartDef cube = hullPart(testing::boxCorners(Vec3(1.0F)), 0.0F);
  const PartDef box = boxPart(Vec3(0.0F), Vec3(1.0F), kUpright, 0.04F);
  for (const PartDef& other : {rough, cube, box}) {
    const float margins = other.kind == PartKind::kEnclosed ? 0.08F : 0.04F;
    for (const float gap : {-0.5F, 0.01F, 0.03F}) {
      const ChildVerdict expected = gap < kThreshold ? ChildVerdict::kAskEngine : ChildVerdict::kApart;
      EXPECT_EQ(verdictAt(rough, other, 2.0F + margins + gap), expected);
      EXPECT_EQ(verdictAt(other, rough, 2.0F + margins + gap), expected);
    }
  }
}

TEST(PartPair, LetsTheEngineRefreshItsOwnContacts) {
  const PartList ball = only(spherePart(Vec3(0.0F), 0.5F));
  TwoBodies bodies(ball, ball);
  ASSERT_TRUE(bodies.advance(Vec3(1.01F, 0.0F, 0.0F)));
  ChildPair& child = bodies.pair.children()[0];
  child.touching = true;
  EXPECT_FALSE(bodies.pair.isAsleep(child));
  EXPECT_EQ(bodies.judge(child), ChildVerdict::kAskEngine);
  child.touching = false;
  EXPECT_EQ(bodies.judge(child), ChildVerdict::kApart);
}

TEST(PartPair, WithoutItsOwnGjkAsksTheEngineUnlessAnAxisTells) {
  const PartList cube = only(hullPart(testing::boxCorners(Vec3(1.0F)), 0.0F));
  TwoBodies bodies(cube, cube);
  bodies.steps.ownGjk = false;
  bodies.steps.motionBound = false;
  const Frame turned = frameOf(glm::angleAxis(0.785398163F, Vec3(0, 0, 1)), Vec3(2.4382F, 0.0F, 0.0F));
  ASSERT_TRUE(bodies.advance(turned) || bodies.pair.children().empty());
  // Its edge reaches to 2.4382 - sqrt(2), which is 0.024 from A's face.
  ASSERT_EQ(bodies.pair.children().size(), 1U) << "the list has a skin";
  ChildPair& child = bodies.pair.children()[0];
  child.hasAxis = false;
  EXPECT_EQ(bodies.judge(child), ChildVerdict::kAskEngine);
  bodies.pair.learnAxis(child, bodies.a, bodies.b, Vec3(1.0F, 0.0F, 0.0F));
  EXPECT_EQ(bodies.judge(child), ChildVerdict::kApart);
  EXPECT_EQ(bodies.work.axisRejected, 1);
  bodies.steps.cachedAxis = false;
  EXPECT_EQ(bodies.judge(child), ChildVerdict::kAskEngine);
  EXPECT_EQ(bodies.work.gjkRuns, 0);
}

TEST(PartPair, ALearntAxisLetsTheChildPairSleep) {
  // Cubes that stand on an edge: their boxes overlap although their faces are apart.
  const Mat3 turned = glm::mat3_cast(glm::angleAxis(0.785398163F, Vec3(0, 0, 1)));
  std::vector<Vec3> corners = testing::boxCorners(Vec3(1.0F));
  for (Vec3& corner : corners) corner = turned * corner;
  const PartList cube = only(hullPart(corners, 0.0F));
  const Vec3 axis = turned * Vec3(1.0F, 0.0F, 0.0F);
  TwoBodies bodies(cube, cube);
  ASSERT_TRUE(bodies.advance(2.03F * axis));
  ChildPair& child = bodies.pair.children()[0];
  ASSERT_FALSE(bodies.pair.isAsleep(child));
  bodies.pair.learnAxis(child, bodies.a, bodies.b, axis);
  EXPECT_TRUE(bodies.pair.isAsleep(child)) << "0.01 more than the threshold is proven";
  bodies.settle();
  EXPECT_TRUE(!bodies.advance(2.025F * axis) || bodies.pair.isAsleep(bodies.pair.children()[0]));
  ASSERT_TRUE(bodies.advance(2.015F * axis));
  EXPECT_FALSE(bodies.pair.isAsleep(bodies.pair.children()[0]));
}

TEST(PartPair, LeavesBodiesAloneThatAreFarApart) {
  const PartList cube = only(hullPart(testing::boxCorners(Vec3(1.0F)), 0.0F));
  TwoBodies bodies(cube, cube);
  EXPECT_FALSE(bodies.advance(Vec3(10.0F, 0.0F, 0.0F)));
  EXPECT_EQ(bodies.work.pairsSkipped, 0) << "the first time it looks";
  for (int step = 1; step <= 7; ++step) {
    EXPECT_FALSE(bodies.advance(Vec3(10.0F - static_cast<float>(step), 0.0F, 0.0F)));
  }
  EXPECT_EQ(bodies.work.pairs, 8);
  EXPECT_EQ(bodies.work.pairsSkipped, 7) << "8 metres were proven";
  EXPECT_EQ(bodies.work.rebuilds, 1);
  EXPECT_TRUE(bodies.advance(Vec3(2.01F, 0.0F, 0.0F)));
}

TEST(PartPair, NeverLeavesATouchingPairAlone) {
  const PartList cube = only(hullPart(testing::boxCorners(Vec3(1.0F)), 0.0F));
  TwoBodies bodies(cube, cube);
  for (int step = 0; step < 5; ++step) {
    ASSERT_TRUE(bodies.advance(Vec3(2.01F, 0.0F, 0.0F)));
    ChildPair& child = bodies.pair.children()[0];
    ASSERT_FALSE(bodies.pair.isAsleep(child));
    EXPECT_EQ(bodies.judge(child), ChildVerdict::kContact);
    child.touching = true;
    bodies.settle();
  }
  EXPECT_EQ(bodies.work.pairsSkipped, 0);
}

TEST(PartPair, NeverLeavesAPairAloneThatStillTouchesThoughItIsApart) {
  const PartList cube = only(hullPart(testing::boxCorners(Vec3(1.0F)), 0.0F));
  TwoBodies bodies(cube, cube);
  ASSERT_TRUE(bodies.advance(Vec3(2.0255F, 0.0F, 0.0F)));
  ChildPair& child = bodies.pair.children()[0];
  ASSERT_TRUE(bodies.pair.isAsleep(child));
  child.touching = true;
  EXPECT_FALSE(bodies.pair.isAsleep(child));
  bodies.settle();
  EXPECT_TRUE(bodies.advance(Vec3(2.0255F, 0.0F, 0.0F))) << "the adapter has to let go of the contact first";
}

TEST(PartPair, WithoutTheMotionBoundNothingSleeps) {
  Random random(92);
  const PartList listA(randomParts(random, 12, 1.0F, 0.02F));
  const PartList listB(randomParts(random, 12, 1.0F, 0.02F));
  TwoBodies bodies(listA, listB);
  bodies.steps.motionBound = false;
  std::size_t seen = 0;
  for (int step = 0; step < 30; ++step) {
    if (!bodies.advance(randomFrame(random, 0.7F))) continue;
    for (ChildPair& child : bodies.pair.children()) {
      EXPECT_FALSE(bodies.pair.isAsleep(child));
      bodies.judge(child);
      EXPECT_FALSE(bodies.pair.isAsleep(child));
      ++seen;
    }
    bodies.settle();
  }
  EXPECT_GT(seen, 200U);
}

using ChildKey = std::pair<int, int>;

TEST(PartPair, DropsExactlyTheContactsOfChildrenThatLeft) {
  Random random(93);
  const PartList listA(randomParts(random, 15, 1.0F, 0.02F));
  const PartList listB(randomParts(random, 15, 1.0F, 0.02F));
  for (const PairMidphase midphase :
       {PairMidphase::kWorldBoxes, PairMidphase::kPartBoxes, PairMidphase::kNeighbourList}) {
    TwoBodies bodies(listA, listB);
    bodies.steps.midphase = midphase;
    std::vector<char> records(4096);
    std::size_t used = 0;
    std::size_t dropped = 0;
    std::map<ChildKey, void*> before;
    for (int step = 0; step < 200; ++step) {
      (void)bodies.advance(randomFrame(random, random.uniform(0.2F, 2.5F)));
      std::map<ChildKey, void*> after;
      for (ChildPair& child : bodies.pair.children()) {
        const ChildKey key(child.a, child.b);
        EXPECT_TRUE(after.empty() || after.rbegin()->first < key) << "ascending";
        EXPECT_EQ(child.contact, before.contains(key) ? before[key] : nullptr) << "step " << step;
        if (child.contact == nullptr && used < records.size() && random.uniform(0.0F, 1.0F) < 0.3F) {
          child.contact = &records[used++];
          child.touching = random.uniform(0.0F, 1.0F) < 0.5F;
        }
        after[key] = child.contact;
      }
      std::vector<void*> expected;
      for (const auto& [key, contact] : before) {
        if (contact != nullptr && !after.contains(key)) expected.push_back(contact);
      }
      EXPECT_EQ(bodies.scratch.dropped, expected) << "step " << step;
      dropped += expected.size();
      before = after;
    }
    EXPECT_GT(dropped, 100U);
  }
}

TEST(PartPair, ResetForgetsEverything) {
  const PartList cube = only(hullPart(testing::boxCorners(Vec3(1.0F)), 0.0F));
  TwoBodies bodies(cube, cube);
  EXPECT_FALSE(bodies.advance(Vec3(2.05F, 0.0F, 0.0F)));
  EXPECT_FALSE(bodies.advance(Vec3(2.05F, 0.0F, 0.0F)));
  EXPECT_EQ(bodies.work.pairsSkipped, 1);
  bodies.pair.reset(0.1F);
  EXPECT_EQ(bodies.pair.threshold(), 0.1F);
  EXPECT_TRUE(bodies.pair.children().empty());
  EXPECT_TRUE(bodies.scratch.dropped.empty());
  EXPECT_TRUE(bodies.advance(Vec3(2.05F, 0.0F, 0.0F))) << "in contact by the new threshold";
  ChildPair& child = bodies.pair.children()[0];
  EXPECT_FALSE(bodies.pair.isAsleep(child));
  EXPECT_EQ(bodies.judge(child), ChildVerdict::kContact);
  child.contact = &bodies;
  bodies.pair.reset(0.1F);
  ASSERT_TRUE(bodies.advance(Vec3(2.05F, 0.0F, 0.0F)));
  EXPECT_EQ(bodies.pair.children()[0].contact, nullptr);
  EXPECT_TRUE(bodies.scratch.dropped.empty());
}

TEST(PartPair, ComesBackFromAPlaceThatIsNoNumber) {
  const PartList cube = only(hullPart(testing::boxCorners(Vec3(1.0F)), 0.0F));
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  for (const float wrong : {kNan, kInfinite, -kInfinite}) {
    for (const float start : {2.01F, 10.0F}) {
      TwoBodies bodies(cube, cube);
      (void)bodies.advance(Vec3(start, 0.0F, 0.0F));
      bodies.settle();
      for (int step = 0; step < 3; ++step) {
        if (bodies.advance(Vec3(wrong, 0.0F, 0.0F))) bodies.settle();
      }
      ASSERT_TRUE(bodies.advance(Vec3(2.01F, 0.0F, 0.0F)));
      ChildPair& child = bodies.pair.children()[0];
      EXPECT_FALSE(bodies.pair.isAsleep(child));
      EXPECT_EQ(bodies.judge(child), ChildVerdict::kContact);
    }
  }
}

TEST(PartPair, ComesBackFromVeryFarAway) {
  const PartList cube = only(hullPart(testing::boxCorners(Vec3(1.0F)), 0.0F));
  for (const float far : {1e6F, 1e9F, 1e12F, 1e15F, 1e17F, 1e19F}) {
    TwoBodies bodies(cube, cube);
    (void)bodies.advance(Vec3(3.0F, 0.0F, 0.0F));
    (void)bodies.advance(Vec3(far, 0.0F, 0.0F));
    bool isAwake = bodies.advance(Vec3(3.0F, 0.0F, 0.0F));
    // Back again, it comes nearer slowly.
    for (int step = 0; step <= 1000; ++step) {
      if (isAwake) {
        for (ChildPair& child : bodies.pair.children()) {
          if (!bodies.pair.isAsleep(child)) bodies.judge(child);
        }
        bodies.settle();
      }
      isAwake = bodies.advance(Vec3(3.0F - 0.00099F * static_cast<float>(step), 0.0F, 0.0F));
    }
    ASSERT_TRUE(isAwake) << "from " << far;
    EXPECT_FALSE(bodies.pair.isAsleep(bodies.pair.children()[0])) << "from " << far;
  }
}

TEST(PartPair, TellsTheMemoryOfItsChildren) {
  Random random(94);
  const PartList list(randomParts(random, 20, 1.0F, 0.0F));
  TwoBodies bodies(list, list);
  EXPECT_EQ(bodies.pair.childBytes(), 0U);
  ASSERT_TRUE(bodies.advance(Vec3(0.1F)));
  EXPECT_GE(bodies.pair.childBytes(), sizeof(ChildPair) * bodies.pair.children().size());
}

}  // namespace
}  // namespace scatter
