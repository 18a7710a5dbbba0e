#include "collision/box_separation.h"

#include <gtest/gtest.h>

#include <limits>

#include "collision/geometry.h"
#include "collision/reference_distance.h"
#include "trials.h"

namespace scatter {
namespace {

using testing::anySize;
using testing::DistanceBounds;
using testing::frameOf;
using testing::kNever;
using testing::placed;
using testing::Points;
using testing::Random;
using testing::referenceDistance;

struct BoxPair {
  Vec3 centerA;
  Vec3 halfA;
  Vec3 centerB;
  Vec3 halfB;
  Frame frameB;
  float size;

  [[nodiscard]] float separation(float enough) const {
    return boxSeparation(centerA, halfA, centerB, halfB, frameB, enough);
  }
  [[nodiscard]] DistanceBounds truth() const {
    Points a;
    Points b;
    for (const Vec3& corner : testing::boxCorners(Vec3(1.0F))) {
      a.push_back(glm::dvec3(centerA) + glm::dvec3(corner) * glm::dvec3(halfA));
      const glm::dvec3 local = glm::dvec3(centerB) + glm::dvec3(corner) * glm::dvec3(halfB);
      const auto row = [&](int i) { return glm::dot(glm::dvec3(frameB.row[i]), local); };
      b.push_back(glm::dvec3(row(0), row(1), row(2)) + glm::dvec3(frameB.origin));
    }
    return referenceDistance(a, b);
  }
};

BoxPair randomBoxes(Random& random) {
  const float size = anySize(random, -3.0F, 3.0F);
  const auto half = [&] {
    return size * Vec3(random.uniform(0.0F, 1.0F), random.uniform(0.0F, 1.0F), random.uniform(0.0F, 1.0F));
  };
  BoxPair boxes{random.inBox(Vec3(size)),
                half(),
                random.inBox(Vec3(size)),
                half(),
                testing::randomFrame(random, size * random.uniform(0.0F, 4.0F)),
                6.0F * size};
  return boxes;
}

TEST(BoxSeparation, IsNeverMoreThanTheDistance) {
  Random random(51);
  int apart = 0;
  for (int round = 0; round < test::trials(10000); ++round) {
    const BoxPair boxes = randomBoxes(random);
    const float separation = boxes.separation(kNever);
    const double rounding = 1e-6 * static_cast<double>(boxes.size);
    const DistanceBounds truth = boxes.truth();
    EXPECT_LE(static_cast<double>(separation), truth.upper + rounding) << "round " << round;
    // The separating axis theorem: one of the fifteen axes tells whether boxes are apart at all.
    if (truth.lower > 100.0 * rounding) {
      EXPECT_GT(separation, 0.0F) << "round " << round;
      ++apart;
    }
  }
  EXPECT_GT(apart, test::trials(3000));
}

TEST(BoxSeparation, IsTheDistanceOfBoxesThatFaceEachOther) {
  Random random(52);
  for (int round = 0; round < 1000; ++round) {
    // A corner of the turned B above the middle of A's upper face.
    BoxPair boxes{Vec3(1, 2, 3), Vec3(5, 5, 1), Vec3(-1, 0, 2), Vec3(1, 0.7F, 0.4F), Frame{}, 10.0F};
    boxes.frameB = frameOf(random.rotation(), Vec3(0.0F));
    Vec3 lift(0.0F);
    lift.z = 1.0F + 1.3F + random.uniform(0.01F, 3.0F);
    boxes.frameB.origin = boxes.centerA + lift - boxes.frameB.rotate(boxes.centerB);
    EXPECT_NEAR(static_cast<double>(boxes.separation(kNever)), boxes.truth().upper, 1e-5)
        << "round " << round;
  }
}

TEST(BoxSeparation, OfCrossedEdgesIsTheirDistance) {
  // Both turned by 45°, one about x, one about y: edge above edge, each sqrt(2) from its centre.
  const Quat aboutX = glm::angleAxis(0.785398163F, Vec3(1, 0, 0));
  const Quat aboutY = glm::angleAxis(0.785398163F, Vec3(0, 1, 0));
  const Frame a = frameOf(aboutX, Vec3(0.0F));
  const Frame b = frameOf(aboutY, Vec3(0, 0, 3));
  const float separation =
      boxSeparation(Vec3(0.0F), Vec3(1.0F), Vec3(0.0F), Vec3(1.0F), relativeFrame(a, b), kNever);
  EXPECT_NEAR(separation, 3.0F - 2.0F * 1.41421356F, 1e-5F);
}

TEST(BoxSeparation, OfSlantingEdgesIsTheirDistance) {
  // The same, B turned on by 30° about z: its edge crosses A's at 60°.
  const Quat aboutX = glm::angleAxis(0.785398163F, Vec3(1, 0, 0));
  const Quat aboutY = glm::angleAxis(0.785398163F, Vec3(0, 1, 0));
  const Quat aboutZ = glm::angleAxis(0.523598776F, Vec3(0, 0, 1));
  const Frame a = frameOf(aboutX, Vec3(0.0F));
  const Frame b = frameOf(aboutZ * aboutY, Vec3(0, 0, 3));
  const float separation =
      boxSeparation(Vec3(0.0F), Vec3(1.0F), Vec3(0.0F), Vec3(1.0F), relativeFrame(a, b), kNever);
  EXPECT_NEAR(separation, 3.0F - 2.0F * 1.41421356F, 1e-5F);
}

TEST(BoxSeparation, IsNegativeWhenTheyOverlap) {
  Random random(53);
  for (int round = 0; round < 3000; ++round) {
    BoxPair boxes = randomBoxes(random);
    boxes.halfA += 0.01F * boxes.size;
    // B's centre inside A.
    boxes.frameB.origin = boxes.centerA + random.inBox(boxes.halfA) - boxes.frameB.rotate(boxes.centerB);
    EXPECT_LE(boxes.separation(kNever), 1e-6F * boxes.size) << "round " << round;
  }
  const float inside = boxSeparation(Vec3(0.0F), Vec3(2.0F), Vec3(0.0F), Vec3(1.0F), Frame{}, kNever);
  EXPECT_EQ(inside, -3.0F);
}

TEST(BoxSeparation, StopsAtEnough) {
  Random random(54);
  int early = 0;
  for (int round = 0; round < 2000; ++round) {
    const BoxPair boxes = randomBoxes(random);
    const float full = boxes.separation(kNever);
    const float enough = 0.5F * full;
    const float some = boxes.separation(enough);
    EXPECT_LE(some, full) << "round " << round;
    EXPECT_TRUE(full <= 0.0F || some > enough) << "round " << round;
    if (some < full) ++early;
  }
  EXPECT_GT(early, 10);
}

}  // namespace
}  // namespace scatter
