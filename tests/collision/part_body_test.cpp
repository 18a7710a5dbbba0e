#include "collision/part_body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "collision/geometry.h"
#include "collision/reference_distance.h"

namespace scatter {
namespace {

using testing::anySize;
using testing::frameOf;
using testing::placed;
using testing::Random;
using testing::randomFrame;

PartList randomList(Random& random, int count) {
  return PartList(testing::randomParts(random, count, 1.0F, 0.0F));
}

TEST(PartBody, TravelsAtLeastAsFarAsAnyOfItsPoints) {
  Random random(61);
  for (int round = 0; round < 20; ++round) {
    const PartList parts = randomList(random, 1 + round % 9);
    PartBody body(parts);
    Frame frame = randomFrame(random, anySize(random, -1.0F, 4.0F));
    Quat turned = random.rotation();
    body.moveTo(frame);
    for (int step = 0; step < 100; ++step) {
      const double before = body.travel();
      const Frame last = frame;
      turned = glm::normalize(glm::angleAxis(anySize(random, -6.0F, 0.5F), random.direction()) * turned);
      frame = frameOf(turned, frame.origin + random.direction() * anySize(random, -6.0F, 1.0F));
      // The first step also changes to this rotation.
      body.moveTo(frame);
      double furthest = 0.0;
      for (int i = 0; i < parts.count(); ++i) {
        const auto from = placed(last, parts.part(i).core);
        const auto to = placed(frame, parts.part(i).core);
        for (std::size_t k = 0; k < to.size(); ++k)
          furthest = std::max(furthest, glm::length(to[k] - from[k]));
      }
      ASSERT_GE(body.travel() - before, furthest * (1.0 - 1e-12)) << "round " << round << ", step " << step;
    }
    EXPECT_EQ(body.jumps(), 0);
  }
}

TEST(PartBody, ComingToItsFirstPlaceIsNoTravel) {
  Random random(62);
  const PartList parts = randomList(random, 3);
  PartBody body(parts);
  body.moveTo(randomFrame(random, 50.0F));
  EXPECT_EQ(body.travel(), 0.0);
  EXPECT_EQ(body.jumps(), 0);
}

TEST(PartBody, MovingToWhereItIsIsNothing) {
  Random random(63);
  const PartList parts = randomList(random, 3);
  PartBody body(parts);
  const Frame frame = randomFrame(random, 50.0F);
  body.moveTo(frame);
  body.moveTo(randomFrame(random, 50.0F));
  const double travel = body.travel();
  EXPECT_GT(travel, 0.0);
  for (int i = 0; i < 10; ++i) body.moveTo(Frame(body.frame()));
  EXPECT_EQ(body.travel(), travel);
}

TEST(PartBody, CountsMovesFromAndToWhatIsNoNumber) {
  Random random(64);
  const PartList parts = randomList(random, 3);
  for (const float wrong : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()}) {
    PartBody body(parts);
    const Frame frame = randomFrame(random, 1.0F);
    body.moveTo(frame);
    Frame nowhere = frame;
    nowhere.origin.y = wrong;
    body.moveTo(nowhere);
    EXPECT_EQ(body.jumps(), 1);
    body.moveTo(frame);
    EXPECT_EQ(body.jumps(), 2);
    Frame twisted = frame;
    twisted.row[2].x = wrong;
    body.moveTo(twisted);
    body.moveTo(frame);
    EXPECT_EQ(body.jumps(), 4);
    EXPECT_TRUE(std::isfinite(body.travel()));
    body.moveTo(randomFrame(random, 1.0F));
    EXPECT_EQ(body.jumps(), 4);
  }
}

TEST(PartBody, WorldBoundsFollowItAndItsParts) {
  Random random(65);
  const PartList first = randomList(random, 5);
  const PartList second = randomList(random, 20);
  PartBody body(first);
  std::vector<float> expected;
  for (int step = 0; step < 10; ++step) {
    body.moveTo(randomFrame(random, 3.0F));
    body.parts().worldBounds(body.frame(), expected);
    EXPECT_EQ(body.worldBounds(), expected);
    EXPECT_EQ(body.worldBounds(), expected) << "the second time";
    if (step == 5) body.setParts(second);
  }
  EXPECT_EQ(&body.parts(), &second);
}

TEST(PartBody, ReplacingThePartsIsNoTravel) {
  Random random(66);
  const PartList first = randomList(random, 5);
  const PartList second = randomList(random, 2);
  PartBody body(first);
  body.moveTo(randomFrame(random, 3.0F));
  body.setParts(second);
  body.moveTo(randomFrame(random, 3.0F));
  EXPECT_EQ(body.travel(), 0.0);
}

TEST(BoundsTest, ToldFromTheWorldBounds) {
  Random random(67);
  const PartList listA = randomList(random, 18);
  const PartList listB = randomList(random, 33);
  PartBody a(listA);
  PartBody b(listB);
  a.moveTo(randomFrame(random, 1.0F));
  b.moveTo(randomFrame(random, 1.0F));
  BoundsTest test(a, b);
  int overlapping = 0;
  for (int i = 0; i < listA.count(); ++i) {
    for (int j = 0; j < listB.count(); ++j) {
      const auto bound = [](PartBody& body, int which, int part) {
        return body.worldBounds()[static_cast<std::size_t>(which * body.parts().paddedCount() + part)];
      };
      bool expected = true;
      for (int axis = 0; axis < 3; ++axis) {
        expected = expected && bound(a, axis, i) <= bound(b, axis + 3, j);
        expected = expected && bound(b, axis, j) <= bound(a, axis + 3, i);
      }
      EXPECT_EQ(test.overlap(i, j), expected) << i << " and " << j;
      overlapping += expected ? 1 : 0;
    }
  }
  EXPECT_GT(overlapping, 10);
  EXPECT_LT(overlapping, listA.count() * listB.count() - 10);
}

}  // namespace
}  // namespace scatter
