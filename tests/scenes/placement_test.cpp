#include "scenes/placement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "scenes/region_placement.h"

namespace scatter {
namespace {

TEST(RandomTest, TheSameSeedGivesTheSameNumbersAndAnotherSeedOthers) {
  Random a(7);
  Random b(7);
  Random c(8);
  int equal = 0;
  for (int i = 0; i < 100; ++i) {
    const float x = a.uniform(-2.0F, 3.0F);
    EXPECT_EQ(x, b.uniform(-2.0F, 3.0F));
    EXPECT_GE(x, -2.0F);
    EXPECT_LT(x, 3.0F);
    equal += x == c.uniform(-2.0F, 3.0F);
  }
  EXPECT_LT(equal, 3);
}

TEST(RandomTest, DirectionsAndOrientationsAreUnitAndFavourNoSide) {
  Random random(3);
  Vec3 sum(0.0F);
  for (int i = 0; i < 3000; ++i) {
    const Vec3 direction = random.direction();
    EXPECT_NEAR(glm::length(direction), 1.0F, 1e-5F);
    EXPECT_NEAR(glm::length(random.orientation()), 1.0F, 1e-5F);
    sum += direction;
  }
  // The mean of 3000 unit vectors has a standard deviation of 1/sqrt(3000) = 0.018 in length.
  EXPECT_LT(glm::length(sum) / 3000.0F, 0.08F);
}

TEST(RegionPlacement, BallsLieInTheShellAndNeverOverlap) {
  Random random(5);
  SceneFileRegion region;
  region.kind = SceneFileRegion::Kind::kShell;
  region.center = Vec3(1.0F, 2.0F, 3.0F);
  region.inner = 10.0F;
  region.outer = 20.0F;
  RegionPlacement shell(random, region);
  std::vector<Vec3> placed;
  for (int i = 0; i < 200; ++i) {
    placed.push_back(shell.place(1.0F));
    EXPECT_GE(glm::length(placed.back() - region.center), 9.999F);
    EXPECT_LE(glm::length(placed.back() - region.center), 20.001F);
  }
  for (std::size_t i = 0; i < placed.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) EXPECT_GT(glm::length(placed[i] - placed[k]), 1.999F);
  }
}

TEST(RegionPlacement, GrowsWhenItIsFull) {
  for (const auto kind :
       {SceneFileRegion::Kind::kShell, SceneFileRegion::Kind::kBall, SceneFileRegion::Kind::kBox}) {
    Random random(5);
    SceneFileRegion region;
    region.kind = kind;
    region.inner = 1.0F;
    region.outer = 1.5F;
    region.size = Vec3(1.5F);
    RegionPlacement placement(random, region);
    float furthest = 0.0F;
    for (int i = 0; i < 50; ++i) furthest = std::max(furthest, glm::length(placement.place(1.0F)));
    EXPECT_GT(furthest, 1.5F);
  }
}

}  // namespace
}  // namespace scatter
