#include "scenes/detailed_bodies.h"

#include <gmock/gmock.h>
#include <scatter/levels/level_check.h>

namespace scatter {
namespace {

std::size_t hullsOf(const HullGroups& groups) {
  std::size_t count = 0;
  for (const auto& group : groups) count += group.size();
  return count;
}

/// The levels as anybody may check them, and that they have so many parts.
void expectNested(const HullGroups& groups, std::size_t parts) {
  EXPECT_EQ(hullsOf(groups), parts);
  const auto model = nestedModel("body", groups, 5.0F);
  ASSERT_TRUE(model) << model.error().message;
  const LevelSet& levels = *model->levels;
  ASSERT_EQ(levels.count(), 3);
  EXPECT_EQ(levels.coarsest().parts.size(), 1U);
  EXPECT_EQ(levels.level(2).parts.size(), groups.size());
  EXPECT_EQ(levels.finest().parts.size(), parts);
  const auto check =
      checkLevels({levels.level(1), levels.level(2), levels.level(3)}, levels.hullMargin(), nullptr);
  ASSERT_TRUE(check) << check.error().message;
  EXPECT_TRUE(check->passed());
}

TEST(DetailedBodies, AClusterIsNestedAndKeepsItsSize) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    const ClusterDef def{.halfExtents = {0.6F, 0.4F, 1.8F}, .groups = 8, .hulls = 61};
    const HullGroups groups = makeCluster(def, random);
    expectNested(groups, 61);
    for (const auto& group : groups) {
      for (const ConvexHull& hull : group) {
        for (const Vec3& vertex : hull.vertices) {
          for (int axis = 0; axis < 3; ++axis) {
            EXPECT_LE(std::abs(vertex[axis]), def.halfExtents[axis] + 1e-3F);
          }
        }
      }
    }
  }
}

TEST(DetailedBodies, AClusterMayBeOneGroup) {
  Random random(3);
  expectNested(makeCluster({.halfExtents = Vec3(0.2F), .groups = 1, .hulls = 4}, random), 4);
}

TEST(DetailedBodies, AWheelIsNested) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    expectNested(makeWheel({.segments = 29, .spokes = 7, .wedges = 4}, random), 40);
  }
}

TEST(DetailedBodies, ATableIsNested) {
  expectNested(makeTable({2.0F, 0.8F, 1.2F}), 5);
}

TEST(DetailedBodies, AHullWithoutVolumeIsRefused) {
  const HullGroups flat{{ConvexHull{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}}};
  EXPECT_FALSE(nestedModel("flat", flat, 1.0F));
}

}  // namespace
}  // namespace scatter
