#include <gtest/gtest.h>
#include <scatter/levels/containment.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <limits>

#include "levels/meshes.h"
#include "levels/part_builders.h"

namespace scatter {
namespace {

using namespace testing;  // the part builders

std::optional<ContainmentGap> gapOf(const std::vector<ConvexPart>& finer,
                                    const std::vector<ConvexPart>& coarser, float margin = 0.0F) {
  const auto gap = findContainmentGap({finer}, {coarser}, margin);
  EXPECT_TRUE(gap.has_value()) << (gap ? "" : gap.error().message);
  return gap.value_or(std::nullopt);
}

bool isNested(const std::vector<ConvexPart>& finer, const std::vector<ConvexPart>& coarser,
              float margin = 0.0F) {
  const auto gap = gapOf(finer, coarser, margin);
  return !gap.has_value();
}

TEST(Containment, AShapeHoldsItself) {
  for (const ConvexPart& part : {box({1.0F, 2.0F, 3.0F}), sphere(1.0F), capsule(0.5F, 2.0F),
                                 cylinder(1.0F, 0.2F), boxHull({1.0F, 0.1F, 2.0F})}) {
    EXPECT_TRUE(isNested({part}, {part}, 0.02F)) << "shape " << part.shape.index();
  }
}

TEST(Containment, BoxInBoxToWithinTheTolerance) {
  EXPECT_TRUE(isNested({box(Vec3(0.9F))}, {box(Vec3(1.0F))}));
  EXPECT_TRUE(isNested({box(Vec3(1.00005F))}, {box(Vec3(1.0F))}));
  EXPECT_FALSE(isNested({box(Vec3(1.0002F))}, {box(Vec3(1.0F))}));
}

TEST(Containment, WorstPartIsReported) {
  const auto gap =
      gapOf({box(Vec3(0.5F)), box(Vec3(0.5F), {0.6F, 0.0F, 0.0F}), box(Vec3(0.5F), {0.0F, -0.75F, 0.0F})},
            {box(Vec3(1.0F))});
  ASSERT_TRUE(gap.has_value());
  EXPECT_EQ(gap->part, 2U);
  EXPECT_NEAR(gap->distance, 0.25F, 1e-3F);
  EXPECT_NEAR(gap->point.y, -1.25F, 1e-3F);
}

TEST(Containment, CornerDistanceIsEuclidean) {
  // The corner at (1.1, 1.2, 1.2) is (0.1, 0.2, 0.2) from the corner of the coarser box: 0.3.
  const auto gap = gapOf({box({0.1F, 0.2F, 0.2F}, Vec3(1.0F))}, {box(Vec3(1.0F))});
  ASSERT_TRUE(gap.has_value());
  EXPECT_NEAR(gap->distance, 0.3F, 1e-3F);
}

TEST(Containment, UnionOfTwoBoxesHoldsWhatSpansThem) {
  const ConvexPart finer = box({1.5F, 0.5F, 0.5F});
  const ConvexPart left = box(Vec3(1.0F), {-1.0F, 0.0F, 0.0F});
  EXPECT_TRUE(isNested({finer}, {left, box(Vec3(1.0F), {1.0F, 0.0F, 0.0F})}));
  EXPECT_TRUE(isNested({finer}, {left, box(Vec3(1.0F), {0.7F, 0.0F, 0.0F})}));
  EXPECT_FALSE(isNested({finer}, {left}));
}

TEST(Containment, GapBetweenTwoBoxes) {
  // 0.2 apart: the middle of the gap is 0.1 from either.
  const auto gap = gapOf({box({1.5F, 0.5F, 0.5F})},
                         {box(Vec3(1.0F), {-1.1F, 0.0F, 0.0F}), box(Vec3(1.0F), {1.1F, 0.0F, 0.0F})});
  ASSERT_TRUE(gap.has_value());
  EXPECT_NEAR(gap->distance, 0.1F, 1e-3F);
  EXPECT_NEAR(gap->point.x, 0.0F, 1e-3F);
}

TEST(Containment, HoleInARingOfBoxes) {
  // Four boxes around a hole of 0.2 × 0.2: only its middle line is 0.1 from all of them.
  const std::vector<ConvexPart> ring{
      box({1.0F, 0.45F, 1.0F}, {0.0F, 0.55F, 0.0F}), box({1.0F, 0.45F, 1.0F}, {0.0F, -0.55F, 0.0F}),
      box({0.45F, 1.0F, 1.0F}, {0.55F, 0.0F, 0.0F}), box({0.45F, 1.0F, 1.0F}, {-0.55F, 0.0F, 0.0F})};
  const auto gap = gapOf({box(Vec3(0.9F))}, ring);
  ASSERT_TRUE(gap.has_value());
  EXPECT_NEAR(gap->distance, 0.1F, 1e-3F);
  EXPECT_NEAR(gap->point.x, 0.0F, 1e-3F);
  EXPECT_NEAR(gap->point.y, 0.0F, 1e-3F);
  std::vector<ConvexPart> plugged = ring;
  plugged.push_back(box({0.1F, 0.1F, 1.0F}));
  EXPECT_TRUE(isNested({box(Vec3(0.9F))}, plugged));
}

TEST(Containment, HullsWithTheSameMarginNestLikeTheirCores) {
  EXPECT_TRUE(isNested({boxHull(Vec3(1.0F))}, {boxHull(Vec3(1.0F))}, 0.05F));
  const auto gap = gapOf({boxHull({1.0F, 1.0F, 1.0F})}, {boxHull({0.97F, 1.0F, 1.0F})}, 0.05F);
  ASSERT_TRUE(gap.has_value());
  EXPECT_NEAR(gap->distance, 0.03F, 1e-3F);
}

TEST(Containment, MarginSticksOutOfABox) {
  EXPECT_TRUE(isNested({boxHull(Vec3(0.95F))}, {box(Vec3(1.0F))}, 0.05F));
  const auto gap = gapOf({boxHull({0.97F, 0.9F, 0.9F})}, {box(Vec3(1.0F))}, 0.05F);
  ASSERT_TRUE(gap.has_value());
  EXPECT_NEAR(gap->distance, 0.02F, 1e-3F);
}

TEST(Containment, MarginAcrossTouchingBoxes) {
  // Shrunk by the margin the two boxes no longer touch, but their union still holds the hull.
  const std::vector<ConvexPart> halves{box(Vec3(1.0F), {-1.0F, 0.0F, 0.0F}),
                                       box(Vec3(1.0F), {1.0F, 0.0F, 0.0F})};
  EXPECT_TRUE(isNested({boxHull({1.5F, 0.95F, 0.95F})}, halves, 0.05F));
  EXPECT_FALSE(isNested({boxHull({1.5F, 0.97F, 0.95F})}, halves, 0.05F));
}

TEST(Containment, MarginOfTheCoarserHullHoldsABox) {
  EXPECT_TRUE(isNested({box(Vec3(1.0F))}, {boxHull(Vec3(1.0F))}, 0.05F));
  // Over the faces, but away from their edges, the margin is all there.
  EXPECT_TRUE(isNested({box({1.04F, 0.9F, 0.9F})}, {boxHull(Vec3(1.0F))}, 0.05F));
  EXPECT_FALSE(isNested({box({1.06F, 0.9F, 0.9F})}, {boxHull(Vec3(1.0F))}, 0.05F));
}

TEST(Containment, MarginOfTheCoarserHullIsRound) {
  // The corner of the box is 0.04 √3 = 0.069 from the hull's, more than its margin.
  EXPECT_FALSE(isNested({box(Vec3(1.04F))}, {boxHull(Vec3(1.0F))}, 0.05F));
}

TEST(Containment, PartsThinnerThanTheMarginHoldNoHull) {
  const auto gap = gapOf({boxHull(Vec3(0.01F))}, {box({1.0F, 0.04F, 1.0F})}, 0.05F);
  ASSERT_TRUE(gap.has_value());
  // The hull reaches 0.06, the box 0.04.
  EXPECT_NEAR(gap->distance, 0.02F, 1e-3F);
}

TEST(Containment, RoundShapesTouchTheirBounds) {
  const Quat turn = glm::angleAxis(0.7F, glm::normalize(Vec3(1.0F, 2.0F, 3.0F)));
  const auto turned = [&turn](ConvexPart part) {
    part.pose.rotation = turn;
    return part;
  };
  EXPECT_TRUE(isNested({sphere(1.0F)}, {turned(box(Vec3(1.0F)))}));
  EXPECT_TRUE(isNested({turned(capsule(0.5F, 1.0F))}, {turned(box({0.5F, 1.5F, 0.5F}))}));
  EXPECT_TRUE(isNested({turned(cylinder(0.5F, 1.0F))}, {turned(box({0.5F, 1.0F, 0.5F}))}));
  EXPECT_TRUE(isNested({turned(cylinder(0.5F, 1.0F))}, {turned(boxHull({0.5F, 1.0F, 0.5F}))}));
  EXPECT_FALSE(isNested({turned(cylinder(0.5F, 1.0F))}, {turned(box({0.5F, 0.999F, 0.5F}))}));
  EXPECT_FALSE(isNested({sphere(1.01F)}, {turned(box(Vec3(1.0F)))}));
}

TEST(Containment, RoundInRound) {
  EXPECT_TRUE(isNested({sphere(0.5F, {0.5F, 0.0F, 0.0F})}, {sphere(1.0F)}));
  EXPECT_FALSE(isNested({sphere(0.5F, {0.52F, 0.0F, 0.0F})}, {sphere(1.0F)}));
  EXPECT_TRUE(isNested({sphere(0.5F, {0.0F, 2.0F, 0.0F})}, {capsule(0.5F, 2.0F)}));
  EXPECT_TRUE(isNested({capsule(0.5F, 1.0F)}, {cylinder(0.5F, 1.5F)}));
  EXPECT_FALSE(isNested({capsule(0.5F, 1.1F)}, {cylinder(0.5F, 1.5F)}));
  EXPECT_TRUE(isNested({box(Vec3(0.57F))}, {sphere(1.0F)}));
  EXPECT_FALSE(isNested({box(Vec3(0.58F))}, {sphere(1.0F)}));
}

TEST(Containment, CylinderInCylinder) {
  EXPECT_TRUE(isNested({cylinder(0.5F, 1.0F, {0.5F, 0.5F, 0.0F})}, {cylinder(1.0F, 1.5F)}));
  EXPECT_FALSE(isNested({cylinder(0.5F, 1.0F, {0.51F, 0.0F, 0.0F})}, {cylinder(1.0F, 1.5F)}));
  EXPECT_FALSE(isNested({cylinder(0.5F, 1.0F, {0.0F, 0.51F, 0.0F})}, {cylinder(1.0F, 1.5F)}));
}

// What is held must be held to the last point of its rims, whichever way both are turned.
TEST(Containment, ACylinderThatHoldsAnotherHoldsItsRims) {
  Random random(5);
  int held = 0;
  for (int round = 0; round < test::trials(300); ++round) {
    ConvexPart coarse = cylinder(random.uniform(0.8F, 1.5F), random.uniform(0.8F, 1.5F));
    coarse.pose.rotation = random.rotation();
    ConvexPart fine =
        cylinder(random.uniform(0.1F, 1.0F), random.uniform(0.1F, 1.0F), random.inBox(Vec3(0.4F)));
    fine.pose.rotation = random.rotation();
    if (!isNested({fine}, {coarse})) continue;
    ++held;
    const auto& [radius, halfHeight] = std::get<Cylinder>(fine.shape);
    const auto& outer = std::get<Cylinder>(coarse.shape);
    for (int i = 0; i < 100; ++i) {
      const Vec3 circle = onCircle(turn(static_cast<std::uint32_t>(i), 100), static_cast<double>(radius));
      const Vec3 rim(circle.x, i % 2 == 0 ? halfHeight : -halfHeight, circle.y);
      const Vec3 local = coarse.pose.inverse()(fine.pose(rim));
      EXPECT_LE(std::hypot(local.x, local.z), outer.radius + 2.0F * kTolerance) << "round " << round;
      EXPECT_LE(std::abs(local.y), outer.halfHeight + 2.0F * kTolerance) << "round " << round;
    }
  }
  EXPECT_GT(held, test::trials(30));
}

TEST(Containment, HullMarginInRoundShapes) {
  // Corner at √3 · 0.5 = 0.866.
  EXPECT_TRUE(isNested({boxHull(Vec3(0.5F))}, {sphere(0.917F)}, 0.05F));
  EXPECT_FALSE(isNested({boxHull(Vec3(0.5F))}, {sphere(0.915F)}, 0.05F));
}

TEST(Containment, RoundAcrossTouchingBoxes) {
  const std::vector<ConvexPart> halves{box(Vec3(1.0F), {-1.0F, 0.0F, 0.0F}),
                                       box(Vec3(1.0F), {1.0F, 0.0F, 0.0F})};
  EXPECT_TRUE(isNested({sphere(1.0F)}, halves));
  const auto gap = gapOf({sphere(1.0F, {1.5F, 0.0F, 0.0F})}, halves);
  ASSERT_TRUE(gap.has_value());
  EXPECT_NEAR(gap->distance, 0.5F, 0.02F);
}

TEST(Containment, SharpTipsGetNoMoreThanTheTolerance) {
  // A blade of 1.1°: moving its two faces out by the tolerance alone would move its edge by 100 times that.
  const auto blade = [](float length) {
    return hull({{0.0F, 0.01F, -1.0F},
                 {0.0F, -0.01F, -1.0F},
                 {length, 0.0F, -1.0F},
                 {0.0F, 0.01F, 1.0F},
                 {0.0F, -0.01F, 1.0F},
                 {length, 0.0F, 1.0F}});
  };
  EXPECT_TRUE(isNested({blade(1.0F)}, {blade(1.0F)}));
  const auto gap = gapOf({blade(1.005F)}, {blade(1.0F)});
  ASSERT_TRUE(gap.has_value());
  EXPECT_NEAR(gap->distance, 0.005F, 1e-4F);
}

TEST(Containment, ManyPartsInManyParts) {
  // 64 boxes that span the seams of 8.
  std::vector<ConvexPart> finer;
  std::vector<ConvexPart> coarser;
  for (int i = 0; i < 64; ++i) {
    const Vec3 cell{static_cast<float>(i % 4), static_cast<float>((i >> 2) % 4), static_cast<float>(i >> 4)};
    finer.push_back(box(Vec3(0.6F), glm::clamp(cell - Vec3(1.5F), -1.4F, 1.4F)));
  }
  for (int i = 0; i < 8; ++i) {
    const Vec3 cell{static_cast<float>(i % 2), static_cast<float>((i >> 1) % 2), static_cast<float>(i >> 2)};
    coarser.push_back(box(Vec3(1.0F), 2.0F * cell - Vec3(1.0F)));
  }
  EXPECT_TRUE(isNested(finer, coarser));
  coarser[5] = box(Vec3(0.99F), coarser[5].pose.position);
  const auto gap = gapOf(finer, coarser);
  ASSERT_TRUE(gap.has_value());
  EXPECT_GT(gap->distance, 0.005F);
}

TEST(Containment, ErrorsNameTheLevelAndPart) {
  const auto errorOf = [](const Level& finer, const Level& coarser, float margin, float tolerance) {
    const auto gap = findContainmentGap(finer, coarser, margin, tolerance);
    return gap ? "no error" : gap.error().message;
  };
  const Level good{{box(Vec3(1.0F))}};
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(errorOf({}, good, 0.0F, 1e-4F), "the finer level has no parts");
  EXPECT_EQ(errorOf(good, {}, 0.0F, 1e-4F), "the coarser level has no parts");
  EXPECT_EQ(errorOf(good, {{sphere(0.0F)}}, 0.0F, 1e-4F),
            "the coarser level, part 1: sphere: radius 0 must be positive and finite");
  EXPECT_EQ(errorOf({{good.parts[0], hull({Vec3(0.0F)})}}, good, 0.0F, 1e-4F),
            "the finer level, part 2: convex hull: its 1 vertices are fewer than 4");
  EXPECT_EQ(errorOf(good, good, nan, 1e-4F), "hull margin nan must be finite and not negative");
  EXPECT_EQ(errorOf(good, good, 0.0F, -1.0F), "tolerance -1 must be finite and not negative");
}

}  // namespace
}  // namespace scatter
