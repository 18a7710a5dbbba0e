#include "collision/gjk.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "collision/geometry.h"
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

const Vec3 kAlongX(1.0F, 0.0F, 0.0F);

GjkResult coldGjk(const PolytopeView& a, const PolytopeView& b, const Frame& frameB, const Vec3& axis,
                  float enough) {
  WarmSimplex cold;
  return gjkDistance(a, b, frameB, axis, enough, 1e9F, cold);
}

/// Two polytopes with a gap along a direction that is about their distance, or less than none.
struct Pose {
  OwnedPolytope a;
  OwnedPolytope b;
  Frame frameB;
  float size;  ///< The largest coordinate there is, about.

  [[nodiscard]] DistanceBounds truth() const {
    return referenceDistance(placed(Frame{}, a.view()), placed(frameB, b.view()));
  }
};

Pose randomPose(Random& random) {
  const float sizeA = anySize(random, -3.0F, 3.0F);
  const float sizeB = anyInt(random, 0, 3) == 0 ? anySize(random, -3.0F, 3.0F) : sizeA;
  Pose pose{OwnedPolytope(randomCore(random, 40, sizeA)), OwnedPolytope(randomCore(random, 40, sizeB)),
            frameOf(random.rotation(), Vec3(0.0F)), 0.0F};
  const Vec3 apart = random.direction();
  const float reaches = reach(pose.a.view(), apart) + reach(pose.b.view(), pose.frameB.rotateBack(-apart));
  const float larger = std::max(sizeA, sizeB);
  float gap = larger * anySize(random, -7.0F, 1.0F);
  const int kind = anyInt(random, 0, 5);
  if (kind == 0) gap = -std::min(sizeA, sizeB) * random.uniform(0.0F, 1.0F);
  if (kind == 1) gap = 0.0F;
  pose.frameB.origin = apart * (reaches + gap);
  pose.size = larger + std::max(gap, 0.0F);
  return pose;
}

TEST(GjkReference, ProvesItsAnswers) {
  Random random(31);
  int loose = 0;
  for (int round = 0; round < test::trials(3000); ++round) {
    const Pose pose = randomPose(random);
    const DistanceBounds truth = pose.truth();
    if (truth.upper - truth.lower > 1e-9 * static_cast<double>(pose.size)) ++loose;
  }
  EXPECT_EQ(loose, 0);
}

TEST(Gjk, DistanceOfBoxesAcrossFacesEdgesAndCorners) {
  const OwnedPolytope box(testing::boxCorners(Vec3(1.0F)));
  struct Case {
    Vec3 origin;
    float distance;
  };
  // The gaps of the boxes along the axes are the sides of a right triangle or a cuboid.
  for (const Case& at : {Case{{5, 0, 0}, 3.0F}, Case{{5, 6, 0}, 5.0F}, Case{{4, 5, 8}, 7.0F}}) {
    const GjkResult found =
        coldGjk(box.view(), box.view(), frameOf(kNoRotation, at.origin), glm::normalize(at.origin), kNever);
    EXPECT_EQ(found.state, State::kConverged);
    EXPECT_NEAR(found.distance, at.distance, 1e-3F);
    EXPECT_NEAR(glm::length(found.pointB - found.pointA), at.distance, 1e-3F);
    EXPECT_NEAR(glm::length(found.axis), 1.0F, 1e-5F);
  }
}

TEST(Gjk, DistanceOfCrossingSegments) {
  const OwnedPolytope alongX({Vec3(-1, 0, 0), Vec3(1, 0, 0)});
  const OwnedPolytope alongY({Vec3(0, -1, 0), Vec3(0, 1, 0)});
  const GjkResult found =
      coldGjk(alongX.view(), alongY.view(), frameOf(kNoRotation, Vec3(0.5F, 0.25F, 2)), kAlongX, kNever);
  ASSERT_EQ(found.state, State::kConverged);
  EXPECT_NEAR(found.distance, 2.0F, 1e-3F);
  EXPECT_NEAR(found.pointA.x, 0.5F, 1e-3F);
  EXPECT_NEAR(found.pointB.x, 0.5F, 1e-3F);
  EXPECT_NEAR(found.axis.z, 1.0F, 1e-3F);
}

TEST(Gjk, DistanceOfTwoPoints) {
  const OwnedPolytope point({Vec3(1, 2, 3)});
  const GjkResult found =
      coldGjk(point.view(), point.view(), frameOf(kNoRotation, Vec3(0, 3, 4)), kAlongX, kNever);
  ASSERT_EQ(found.state, State::kConverged);
  EXPECT_NEAR(found.distance, 5.0F, 1e-4F);
  EXPECT_EQ(found.pointA, Vec3(1, 2, 3));
  EXPECT_EQ(found.pointB, Vec3(1, 5, 7));
}

TEST(Gjk, AgreesWithTheReference) {
  Random random(32);
  int undecided = 0;
  constexpr int kRounds = test::trials(12000);
  for (int round = 0; round < kRounds; ++round) {
    const Pose pose = randomPose(random);
    const DistanceBounds truth = pose.truth();
    const GjkResult found = coldGjk(pose.a.view(), pose.b.view(), pose.frameB, random.direction(), kNever);
    const double rounding = 1e-5 * static_cast<double>(pose.size);
    const auto tell = [&] {
      return ::testing::Message() << "round " << round << ", size " << pose.size << ", true " << truth.upper
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
      EXPECT_NEAR(glm::length(found.pointB - found.pointA), found.distance,
                  1e-5F * found.distance + static_cast<float>(rounding))
          << tell();
    }
    if (found.state == State::kUndecided) ++undecided;
    EXPECT_NE(found.state, State::kApart) << tell();
    EXPECT_LE(found.iterations, 41) << tell();
  }
  EXPECT_LE(undecided, kRounds / 200);
}

TEST(Gjk, NearlyAlwaysWithinAThousandth) {
  Random random(33);
  int apart = 0;
  int coarse = 0;
  for (int round = 0; round < test::trials(4000); ++round) {
    const Pose pose = randomPose(random);
    const DistanceBounds truth = pose.truth();
    if (truth.lower < 1e-3 * static_cast<double>(pose.size)) continue;
    ++apart;
    const GjkResult found = coldGjk(pose.a.view(), pose.b.view(), pose.frameB, kAlongX, kNever);
    const double error = std::abs(static_cast<double>(found.distance) - truth.upper);
    if (found.state != State::kConverged || error > 1e-3 * truth.upper) ++coarse;
  }
  EXPECT_GT(apart, test::trials(1000));
  EXPECT_LE(coarse, apart / 200);
}

TEST(Gjk, ProvenDistanceIsThatOfAPlaneAcrossItsAxis) {
  Random random(34);
  for (int round = 0; round < 2000; ++round) {
    const Pose pose = randomPose(random);
    const GjkResult found = coldGjk(pose.a.view(), pose.b.view(), pose.frameB, kAlongX, kNever);
    if (found.provenDistance < 0.0F) continue;
    double highestA = std::numeric_limits<double>::lowest();
    double lowestB = std::numeric_limits<double>::max();
    const glm::dvec3 axis(found.provenAxis);
    for (const auto& p : placed(Frame{}, pose.a.view())) highestA = std::max(highestA, glm::dot(p, axis));
    for (const auto& p : placed(pose.frameB, pose.b.view())) lowestB = std::min(lowestB, glm::dot(p, axis));
    EXPECT_LE(static_cast<double>(found.provenDistance), lowestB - highestA) << "round " << round;
    EXPECT_NEAR(glm::length(axis), 1.0, 1e-6);
  }
}

TEST(Gjk, StopsOnceEnoughIsProven) {
  Random random(35);
  int apart = 0;
  int iterations = 0;
  int allIterations = 0;
  for (int round = 0; round < 3000; ++round) {
    const Pose pose = randomPose(random);
    const DistanceBounds truth = pose.truth();
    const auto enough = static_cast<float>(0.6 * truth.lower);
    if (truth.lower < 1e-2 * static_cast<double>(pose.size)) continue;
    const GjkResult found = coldGjk(pose.a.view(), pose.b.view(), pose.frameB, kAlongX, enough);
    EXPECT_EQ(found.state, State::kApart) << "round " << round;
    EXPECT_GT(found.provenDistance, enough);
    EXPECT_LE(static_cast<double>(found.provenDistance), truth.upper);
    ++apart;
    iterations += found.iterations;
    allIterations += coldGjk(pose.a.view(), pose.b.view(), pose.frameB, kAlongX, kNever).iterations;
  }
  EXPECT_GT(apart, 500);
  EXPECT_LT(iterations, allIterations * 3 / 4);
}

TEST(Gjk, DeepOverlapIsOverlap) {
  Random random(36);
  for (int round = 0; round < 500; ++round) {
    const float size = anySize(random, -3.0F, 3.0F);
    const OwnedPolytope box(testing::boxCorners(Vec3(size)));
    const Frame frameB = frameOf(random.rotation(), random.inBox(Vec3(0.7F * size)));
    const GjkResult found = coldGjk(box.view(), box.view(), frameB, random.direction(), kNever);
    EXPECT_EQ(found.state, State::kOverlap) << "round " << round;
    EXPECT_LE(found.provenDistance, 0.0F);
  }
}

TEST(Gjk, EndsOnWhatIsNoNumber) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  const OwnedPolytope box(testing::boxCorners(Vec3(1.0F)));
  for (const float wrong : {kNan, kInfinite, -kInfinite}) {
    const OwnedPolytope broken({Vec3(wrong), Vec3(1.0F, wrong, 0.0F), Vec3(1.0F), Vec3(2.0F)});
    Frame nowhere;
    nowhere.origin = Vec3(wrong, 0.0F, 0.0F);
    Frame twisted;
    twisted.row[1] = Vec3(wrong);
    const Frame away = frameOf(kNoRotation, Vec3(5.0F, 0.0F, 0.0F));
    WarmSimplex warm;
    for (const GjkResult& found : {coldGjk(broken.view(), box.view(), away, kAlongX, 1.0F),
                                   coldGjk(box.view(), broken.view(), away, kAlongX, 1.0F),
                                   coldGjk(box.view(), box.view(), nowhere, kAlongX, 1.0F),
                                   coldGjk(box.view(), box.view(), twisted, kAlongX, 1.0F),
                                   gjkDistance(box.view(), box.view(), away, Vec3(wrong), 1.0F, 1e9F, warm),
                                   gjkDistance(box.view(), box.view(), nowhere, kAlongX, 1.0F, 1e9F, warm)}) {
      EXPECT_LE(found.iterations, 41);
      EXPECT_FALSE(found.state == State::kConverged && !std::isfinite(found.distance));
    }
    EXPECT_LE(warm.count, 3);
  }
}

}  // namespace
}  // namespace scatter
