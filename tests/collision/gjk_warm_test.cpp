#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "collision/geometry.h"
#include "collision/gjk.h"
#include "collision/reference_distance.h"
#include "trials.h"

namespace scatter {
namespace {

using testing::anyInt;
using testing::anySize;
using testing::DistanceBounds;
using testing::frameOf;
using testing::kNever;
using testing::OwnedPolytope;
using testing::placed;
using testing::Random;
using testing::randomCore;
using testing::referenceDistance;
using State = GjkResult::State;

/// Any vertices there are, the same ones twice included.
WarmSimplex staleSimplex(Random& random, const PolytopeView& a, const PolytopeView& b) {
  WarmSimplex stale;
  stale.count = static_cast<std::uint8_t>(anyInt(random, 0, 3));
  for (int i = 0; i < stale.count; ++i) {
    stale.a[i] = static_cast<std::uint16_t>(anyInt(random, 0, a.count - 1));
    stale.b[i] = static_cast<std::uint16_t>(anyInt(random, 0, b.count - 1));
  }
  return stale;
}

TEST(GjkWarm, StaleVerticesChangeNothing) {
  Random random(41);
  int undecided = 0;
  constexpr int kRounds = test::trials(8000);
  for (int round = 0; round < kRounds; ++round) {
    const float size = anySize(random, -3.0F, 3.0F);
    const OwnedPolytope a(randomCore(random, 40, size));
    const OwnedPolytope b(randomCore(random, 40, size));
    const float distance = size * random.uniform(0.5F, 4.0F);
    const Frame frameB = testing::randomFrame(random, distance);
    const DistanceBounds truth = referenceDistance(placed(Frame{}, a.view()), placed(frameB, b.view()));
    WarmSimplex stale = staleSimplex(random, a.view(), b.view());
    const GjkResult found =
        gjkDistance(a.view(), b.view(), frameB, random.direction(), kNever, kNever, stale);
    const double rounding = 1e-5 * static_cast<double>(size + distance);
    const auto tell = [&] {
      return ::testing::Message() << "round " << round << ", size " << size << ", true " << truth.upper
                                  << ", found " << found.distance << ", proven " << found.provenDistance
                                  << ", state " << static_cast<int>(found.state);
    };
    EXPECT_LE(static_cast<double>(found.provenDistance), truth.upper) << tell();
    if (found.state == State::kOverlap) {
      EXPECT_LE(truth.lower, 30.0 * rounding) << tell();
    } else {
      EXPECT_GE(static_cast<double>(found.distance), truth.lower * (1.0 - 1e-6) - 0.1 * rounding) << tell();
    }
    if (found.state == State::kConverged) {
      EXPECT_LE(static_cast<double>(found.distance), truth.upper * 1.011 + rounding) << tell();
    }
    if (found.state == State::kUndecided) ++undecided;
  }
  EXPECT_LE(undecided, kRounds / 200);
}

TEST(GjkWarm, OverASlowMotionIsAsGoodAsColdAndQuicker) {
  Random random(42);
  int warmIterations = 0;
  int coldIterations = 0;
  for (int round = 0; round < 20; ++round) {
    const OwnedPolytope a(randomCore(random, 40, 1.0F));
    const OwnedPolytope b(randomCore(random, 40, 1.0F));
    const Quat start = random.rotation();
    const Vec3 spin = random.direction();
    const Vec3 side = random.direction();
    const Vec3 drift = 0.3F * random.direction();
    WarmSimplex warm;
    for (int step = 0; step < 200; ++step) {
      const float time = static_cast<float>(step) / 200.0F;
      const Frame frameB = frameOf(glm::angleAxis(time, spin) * start, 2.3F * side + time * drift);
      WarmSimplex cold;
      const GjkResult again = gjkDistance(a.view(), b.view(), frameB, side, kNever, kNever, warm);
      const GjkResult fresh = gjkDistance(a.view(), b.view(), frameB, side, kNever, kNever, cold);
      ASSERT_EQ(again.state, State::kConverged) << "round " << round << ", step " << step;
      ASSERT_EQ(fresh.state, State::kConverged) << "round " << round << ", step " << step;
      EXPECT_NEAR(again.distance, fresh.distance, 2e-3F * fresh.distance) << "round " << round;
      EXPECT_NEAR(glm::dot(again.axis, fresh.axis), 1.0F, 1e-2F) << "round " << round;
      warmIterations += again.iterations;
      coldIterations += fresh.iterations;
    }
  }
  EXPECT_LT(3 * warmIterations, 2 * coldIterations);
}

TEST(GjkWarm, TheSameQuestionAgainTakesOneIteration) {
  const OwnedPolytope box(testing::boxCorners(Vec3(1.0F)));
  const Frame frameB = frameOf(kNoRotation, Vec3(0.5F, 4.0F, 0.3F));
  WarmSimplex warm;
  const GjkResult first = gjkDistance(box.view(), box.view(), frameB, Vec3(0, 1, 0), kNever, kNever, warm);
  const GjkResult second = gjkDistance(box.view(), box.view(), frameB, Vec3(0, 1, 0), kNever, kNever, warm);
  ASSERT_EQ(second.state, State::kConverged);
  EXPECT_LE(second.iterations, 2);
  EXPECT_LE(second.iterations, first.iterations);
  EXPECT_EQ(second.distance, first.distance);
}

TEST(GjkWarm, KeepsNothingOfAnOverlap) {
  const OwnedPolytope box(testing::boxCorners(Vec3(1.0F)));
  WarmSimplex warm;
  warm.count = 1;
  const GjkResult found = gjkDistance(box.view(), box.view(), frameOf(kNoRotation, Vec3(0.5F, 0.2F, 0.1F)),
                                      Vec3(1, 0, 0), kNever, kNever, warm);
  EXPECT_EQ(found.state, State::kOverlap);
  EXPECT_EQ(warm.count, 0);
}

// Parts of a body are often far from its frame's origin: the turned vertex has the rounding of both.
TEST(GjkWarm, ProvenDistanceHoldsForPartsFarFromTheirFramesOrigin) {
  Random random(43);
  for (int round = 0; round < 4000; ++round) {
    const float far = anySize(random, 0.0F, 3.0F);
    const Vec3 offset = random.direction() * far;
    std::vector<Vec3> shifted = randomCore(random, 30, 1.0F);
    for (Vec3& point : shifted) point += offset;
    const OwnedPolytope a(randomCore(random, 30, 1.0F));
    const OwnedPolytope b(shifted);
    Frame frameB = frameOf(random.rotation(), Vec3(0.0F));
    frameB.origin = random.direction() * random.uniform(1.0F, 4.0F) - frameB.rotate(offset);
    const DistanceBounds truth = referenceDistance(placed(Frame{}, a.view()), placed(frameB, b.view()));
    WarmSimplex stale = staleSimplex(random, a.view(), b.view());
    const GjkResult found =
        gjkDistance(a.view(), b.view(), frameB, random.direction(), kNever, kNever, stale);
    EXPECT_LE(static_cast<double>(found.provenDistance), truth.upper) << "round " << round << ", far " << far;
  }
}

}  // namespace
}  // namespace scatter
