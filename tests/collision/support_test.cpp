#include "collision/support.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

#include "collision/geometry.h"

namespace scatter {
namespace {

using testing::anyInt;
using testing::OwnedPolytope;
using testing::Random;

std::uint32_t bits(float value) {
  return std::bit_cast<std::uint32_t>(value);
}

/// One vertex after the other, in the order of operations that the kernels promise.
Support bruteForce(const PolytopeView& polytope, const Vec3& direction) {
  Support best;
  for (int i = 0; i < polytope.count; ++i) {
    const Vec3 p = polytope.vertex(i);
    const float reach = p.x * direction.x + p.y * direction.y + p.z * direction.z;
    if (i == 0 || reach > best.reach) best = {i, reach};
  }
  return best;
}

void expectAllAlike(const OwnedPolytope& owned, const Vec3& direction) {
  const PolytopeView polytope = owned.view();
  const Support expected = bruteForce(polytope, direction);
  const Support many = support<simd::Lanes>(polytope, direction);
  const Support one = support<simd::OneLane>(polytope, direction);
  EXPECT_EQ(many.vertex, expected.vertex) << "of " << polytope.count;
  EXPECT_EQ(one.vertex, expected.vertex) << "of " << polytope.count;
  EXPECT_EQ(bits(many.reach), bits(expected.reach));
  EXPECT_EQ(bits(one.reach), bits(expected.reach));
  EXPECT_EQ(bits(reach<simd::Lanes>(polytope, direction)), bits(expected.reach));
  EXPECT_EQ(bits(reach<simd::OneLane>(polytope, direction)), bits(expected.reach));
}

TEST(Support, IsThatOfALoopForAnyCountAndAnyLanes) {
  Random random(21);
  for (int count = 1; count <= 70; ++count) {
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) points.push_back(random.inBox(Vec3(3.0F)));
    const OwnedPolytope polytope(points);
    for (int i = 0; i < 30; ++i) expectAllAlike(polytope, random.direction());
  }
}

TEST(Support, TheFirstOfEqualVerticesWins) {
  Random random(22);
  for (int round = 0; round < 500; ++round) {
    std::vector<Vec3> points;
    const int count = anyInt(random, 2, 70);
    for (int i = 0; i < count; ++i) {
      const bool again = i > 0 && random.uniform(0.0F, 1.0F) < 0.6F;
      points.push_back(again ? points[static_cast<std::size_t>(anyInt(random, 0, i - 1))]
                             : random.inBox(Vec3(1.0F)));
    }
    expectAllAlike(OwnedPolytope(points), random.direction());
  }
}

TEST(Support, TheFirstOfTheCornersOfAFaceWins) {
  Random random(23);
  for (int round = 0; round < 200; ++round) {
    // Whole numbers, so that many vertices reach equally far along an axis.
    std::vector<Vec3> points;
    const int count = anyInt(random, 1, 70);
    for (int i = 0; i < count; ++i) {
      points.emplace_back(anyInt(random, 1, 3), anyInt(random, 1, 3), anyInt(random, 1, 3));
    }
    const OwnedPolytope polytope(points);
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(1, 1, 0), Vec3(-1, 0, -1)}) {
      expectAllAlike(polytope, axis);
    }
  }
}

TEST(Support, OfOnePointIsThatPoint) {
  const OwnedPolytope point({Vec3(1.0F, -2.0F, 3.0F)});
  const Support found = support(point.view(), Vec3(0.0F, 1.0F, 0.0F));
  EXPECT_EQ(found.vertex, 0);
  EXPECT_EQ(found.reach, -2.0F);
}

}  // namespace
}  // namespace scatter
