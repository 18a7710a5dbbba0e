#include <gtest/gtest.h>
#include <scatter/levels/containment.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <limits>

#include "levels/part_builders.h"
#include "trials.h"

namespace scatter {
namespace {

using namespace testing;  // the part builders

constexpr float kTolerance = 1e-4F;

std::optional<ContainmentGap> gapOf(const Level& finer, const Level& coarser, float margin) {
  const auto gap = findContainmentGap(finer, coarser, margin, kTolerance);
  EXPECT_TRUE(gap.has_value()) << (gap ? "" : gap.error().message);
  return gap.value_or(std::nullopt);
}

std::vector<Vec3> placed(const ConvexPart& part) {
  std::vector<Vec3> points;
  for (const Vec3& vertex : std::get<ConvexHull>(part.shape).vertices) points.push_back(part.pose(vertex));
  return points;
}

Level randomHulls(Random& random, int count) {
  Level level;
  for (int i = 0; i < count; ++i) {
    const Vec3 radii{random.uniform(0.2F, 1.0F), random.uniform(0.2F, 1.0F), random.uniform(0.2F, 1.0F)};
    level.parts.push_back(random.ellipsoidHull(8 + 4 * i, radii, random.inBox(Vec3(2.0F))));
  }
  return level;
}

/// Pairs of parts merged into one hull each.
Level merged(const Level& level) {
  Level coarser;
  for (std::size_t i = 0; i + 1 < level.parts.size(); i += 2) {
    std::vector<Vec3> points = placed(level.parts[i]);
    const std::vector<Vec3> others = placed(level.parts[i + 1]);
    points.insert(points.end(), others.begin(), others.end());
    coarser.parts.push_back(hull(std::move(points)));
  }
  return coarser;
}

TEST(ContainmentProperty, MergedHullsHoldTheirParts) {
  Random random(1);
  for (int round = 0; round < 25; ++round) {
    const Level finer = randomHulls(random, 8);
    for (const float margin : {0.0F, 0.02F, 0.3F}) {
      const auto gap = gapOf(finer, merged(finer), margin);
      EXPECT_FALSE(gap.has_value()) << "round " << round << ", by " << gap->distance;
    }
  }
}

TEST(ContainmentProperty, CutPartsAreHeldByTheirPieces) {
  // A box cut at random places into boxes that only touch: their union is the box again.
  Random random(2);
  for (int round = 0; round < 25; ++round) {
    const Quat turn = random.rotation();
    const Vec3 at = random.inBox(Vec3(1.0F));
    const float x = random.uniform(-0.9F, 0.9F);
    const float y = random.uniform(-0.9F, 0.9F);
    const float z = random.uniform(-0.9F, 0.9F);
    Level pieces;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 end{(corner & 1) != 0 ? 1.0F : -1.0F, (corner & 2) != 0 ? 1.0F : -1.0F,
                     (corner & 4) != 0 ? 1.0F : -1.0F};
      const Vec3 cut{x, y, z};
      pieces.parts.push_back(box(glm::abs(0.5F * (end - cut)), at + turn * (0.5F * (end + cut)), turn));
    }
    const Level whole{{box(Vec3(1.0F), at, turn)}};
    EXPECT_FALSE(gapOf(whole, pieces, 0.0F).has_value()) << "round " << round;

    // Without one of the pieces, the middle of that piece's outer corner is furthest from the rest.
    const auto removed = static_cast<std::size_t>(round % 8);
    const Vec3 size = 2.0F * std::get<Box>(pieces.parts[removed].shape).halfExtents;
    pieces.parts.erase(pieces.parts.begin() + static_cast<std::ptrdiff_t>(removed));
    const auto gap = gapOf(whole, pieces, 0.0F);
    ASSERT_TRUE(gap.has_value()) << "round " << round;
    EXPECT_NEAR(gap->distance, std::min({size.x, size.y, size.z}), 2e-3F) << "round " << round;
  }
}

TEST(ContainmentProperty, AShrunkenCornerIsFound) {
  Random random(3);
  for (int round = 0; round < 25; ++round) {
    const ConvexPart part = random.ellipsoidHull(24, Vec3(1.0F), random.inBox(Vec3(2.0F)));
    ConvexPart coarser = part;
    std::vector<Vec3>& vertices = std::get<ConvexHull>(coarser.shape).vertices;
    // The vertex lies on the unit sphere; what is left near it lies below by at most this.
    const Vec3 corner = vertices.back();
    vertices.back() *= 0.7F;
    const auto gap = gapOf({{part}}, {{coarser}}, 0.02F);
    ASSERT_TRUE(gap.has_value()) << "round " << round;
    EXPECT_GT(gap->distance, 0.01F);
    EXPECT_LE(gap->distance, 0.3F + 1e-4F);
    // At the corner, or on the margin around it.
    EXPECT_LT(glm::distance(gap->point, part.pose(corner)), 0.025F) << "round " << round;
  }
}

TEST(ContainmentProperty, AFaceMovedInIsMeasured) {
  Random random(4);
  for (int round = 0; round < 25; ++round) {
    const float depth = random.uniform(0.001F, 0.3F);
    const Transform pose{random.inBox(Vec3(2.0F)), random.rotation()};
    const Level finer{{{ConvexHull{boxCorners(Vec3(1.0F))}, pose}}};
    std::vector<Vec3> corners = boxCorners(Vec3(1.0F));
    for (Vec3& corner : corners) corner.x = std::min(corner.x, 1.0F - depth);
    const auto gap = gapOf(finer, {{{ConvexHull{corners}, pose}}}, 0.02F);
    ASSERT_TRUE(gap.has_value()) << "round " << round;
    EXPECT_NEAR(gap->distance, depth, 1e-3F * depth + 1e-5F);
  }
}

float distanceToBox(const ConvexPart& part, const Vec3& point) {
  const Vec3 local = part.pose.inverse()(point);
  return glm::length(glm::max(glm::abs(local) - std::get<Box>(part.shape).halfExtents, Vec3(0.0F)));
}

float distanceToSphere(const ConvexPart& part, const Vec3& point) {
  return std::max(0.0F, glm::distance(point, part.pose.position) - std::get<Sphere>(part.shape).radius);
}

float distanceToUnion(const Level& level, const Vec3& point) {
  float nearest = std::numeric_limits<float>::infinity();
  for (const ConvexPart& part : level.parts) {
    const bool isBox = std::holds_alternative<Box>(part.shape);
    nearest = std::min(nearest, isBox ? distanceToBox(part, point) : distanceToSphere(part, point));
  }
  return nearest;
}

/// How far from the coarser level random points of a box are, at most.
float largestSampledDistance(Random& random, const ConvexPart& part, const Level& coarser) {
  const Vec3 half = std::get<Box>(part.shape).halfExtents;
  float largest = 0.0F;
  for (int i = 0; i < 4000; ++i) {
    // Three of four samples lie on the surface, where most of what sticks out is.
    Vec3 local = random.inBox(half);
    if (i % 4 != 0) local[i % 3] = random.uniform(-1.0F, 1.0F) < 0.0F ? -half[i % 3] : half[i % 3];
    largest = std::max(largest, distanceToUnion(coarser, part.pose(local)));
  }
  return largest;
}

TEST(ContainmentProperty, SamplingAgrees) {
  Random random(6);
  int nested = 0;
  int open = 0;
  for (int round = 0; round < test::trials(300); ++round) {
    Level coarser;
    for (int i = 0; i < 6; ++i) {
      const Vec3 half{random.uniform(0.5F, 1.3F), random.uniform(0.5F, 1.3F), random.uniform(0.5F, 1.3F)};
      const Vec3 position = random.inBox(Vec3(0.8F));
      coarser.parts.push_back(box(half, position, random.rotation()));
    }
    if (round % 3 == 0) coarser.parts.push_back(sphere(random.uniform(0.5F, 1.5F), random.inBox(Vec3(0.8F))));
    const Vec3 half{random.uniform(0.1F, 0.8F), random.uniform(0.1F, 0.8F), random.uniform(0.1F, 0.8F)};
    const Vec3 position = random.inBox(Vec3(0.8F));
    const ConvexPart part = box(half, position, random.rotation());
    const auto gap = gapOf({{part}}, coarser, 0.0F);
    const float sampled = largestSampledDistance(random, part, coarser);
    if (!gap) {
      ++nested;
      EXPECT_LE(sampled, 2.0F * kTolerance) << "round " << round;
      continue;
    }
    ++open;
    // The point is in the part, and as far from the union as it says. Spheres may be 1 % smaller.
    EXPECT_LE(distanceToBox(part, gap->point), 1e-5F) << "round " << round;
    const float slack = round % 3 == 0 ? 0.016F : 1e-4F;
    EXPECT_NEAR(distanceToUnion(coarser, gap->point), gap->distance, slack) << "round " << round;
    // Planes measure at least half of what distance measures.
    EXPECT_LE(sampled, 2.0F * gap->distance + kTolerance) << "round " << round;
  }
  // Both answers must have been put to the test.
  EXPECT_GT(nested, test::trials(30));
  EXPECT_GT(open, test::trials(30));
}

}  // namespace
}  // namespace scatter
