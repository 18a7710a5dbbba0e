#include "collision/frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "collision/geometry.h"
#include "collision/reference_distance.h"

namespace scatter {
namespace {

using testing::anySize;
using testing::frameOf;
using testing::placed;
using testing::Random;
using testing::randomFrame;

TEST(Frame, PlacesAPointAndFindsItAgain) {
  // A quarter turn about z takes x to y.
  const Frame frame = frameOf(glm::angleAxis(1.57079633F, Vec3(0, 0, 1)), Vec3(10, 20, 30));
  const Vec3 point = frame(Vec3(1, 2, 3));
  EXPECT_NEAR(point.x, 8.0F, 1e-5F);
  EXPECT_NEAR(point.y, 21.0F, 1e-5F);
  EXPECT_NEAR(point.z, 33.0F, 1e-5F);
  EXPECT_NEAR(glm::length(frame.toLocal(point) - Vec3(1, 2, 3)), 0.0F, 1e-5F);
}

TEST(Frame, RelativeFrameLeadsFromBToA) {
  Random random(11);
  for (int round = 0; round < 1000; ++round) {
    const float far = anySize(random, -2.0F, 4.0F);
    const Frame a = randomFrame(random, far);
    const Frame b = randomFrame(random, far);
    const Vec3 local = random.inBox(Vec3(2.0F));
    const glm::dvec3 throughA = placed(a, relativeFrame(a, b)(local));
    EXPECT_LE(glm::length(throughA - placed(b, local)), 1e-6 * static_cast<double>(2.0F * far + 4.0F));
  }
}

TEST(Frame, RelativeFrameOfAFrameToItselfIsNoMotion) {
  Random random(12);
  const Frame a = randomFrame(random, 100.0F);
  const Frame same = relativeFrame(a, a);
  EXPECT_EQ(same.origin, Vec3(0.0F));
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(same.row[i][j], i == j ? 1.0F : 0.0F, 1e-6F);
  }
}

/// The largest displacement of points of the ball, most of them on its surface.
double largestDisplacement(Random& random, const Frame& before, const Frame& after, const Vec3& center,
                           float radius) {
  double largest = 0.0;
  for (int i = 0; i < 40; ++i) {
    const float depth = i % 4 == 0 ? random.uniform(0.0F, 1.0F) : 1.0F;
    const glm::dvec3 point = glm::dvec3(center) + static_cast<double>(depth * radius) *
                                                      glm::normalize(glm::dvec3(random.direction()));
    // In double precision: a point of the ball need not have coordinates that are floats.
    const auto at = [&](const Frame& frame) {
      const auto row = [&](int k) { return glm::dot(glm::dvec3(frame.row[k]), point); };
      return glm::dvec3(row(0), row(1), row(2)) + glm::dvec3(frame.origin);
    };
    largest = std::max(largest, glm::length(at(after) - at(before)));
  }
  return largest;
}

TEST(Frame, DisplacementBoundHoldsForEveryPointOfTheBall) {
  Random random(13);
  for (int round = 0; round < 6000; ++round) {
    const float far = anySize(random, -3.0F, 6.0F);
    const Vec3 center = random.direction() * anySize(random, -3.0F, 3.0F);
    const float radius = anySize(random, -3.0F, 3.0F);
    const Quat turned = random.rotation();
    Frame before = frameOf(turned, random.direction() * far);
    const Quat turn = glm::angleAxis(anySize(random, -8.0F, 0.5F), random.direction());
    const Vec3 shift = random.direction() * anySize(random, -8.0F, 6.0F);
    Frame after = frameOf(glm::normalize(turn * turned), before.origin + shift);
    // From far away to near by as well as the other way round.
    if (round % 2 == 0) std::swap(before, after);
    if (round % 5 == 0) after.origin *= 1e-6F;
    EXPECT_LE(largestDisplacement(random, before, after, center, radius),
              static_cast<double>(displacementBound(before, after, center, radius).length))
        << "round " << round;
  }
}

TEST(Frame, DisplacementBoundIsTightForAShift) {
  const Frame before;
  for (const float shift : {1e-3F, 1.0F, 1e3F}) {
    const Frame after = frameOf(kNoRotation, Vec3(0.0F, shift, 0.0F));
    const float bound = displacementBound(before, after, Vec3(0.5F, 0.0F, 0.0F), 2.0F).length;
    EXPECT_GE(bound, shift);
    EXPECT_LE(bound, shift * 1.01F);
  }
}

TEST(Frame, DisplacementBoundIsTightForATurnAboutTheCentre) {
  const Frame before;
  constexpr float kRadius = 2.0F;
  for (const float angle : {1e-3F, 0.1F, 1.0F, 3.0F}) {
    const Frame after = frameOf(glm::angleAxis(angle, Vec3(0, 0, 1)), Vec3(0.0F));
    // A point of the ball's equator moves along a chord.
    const float chord = 2.0F * std::sin(0.5F * angle) * kRadius;
    const float bound = displacementBound(before, after, Vec3(0.0F), kRadius).length;
    EXPECT_GE(bound, chord * 0.9999F);
    EXPECT_LE(bound, chord * 1.01F);
  }
}

TEST(Frame, DisplacementBoundOfRestIsOnlyRounding) {
  Random random(14);
  const Frame frame = randomFrame(random, 10.0F);
  EXPECT_LE(displacementBound(frame, frame, Vec3(1.0F), 3.0F).length, 2e-5F);
}

}  // namespace
}  // namespace scatter
