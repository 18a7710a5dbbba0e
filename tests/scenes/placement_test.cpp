#include "scenes/placement.h"

#include <gtest/gtest.h>

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

TEST(ShellPlacementTest, BallsLieInTheShellAndNeverOverlap) {
  Random random(5);
  const Vec3 center(1.0F, 2.0F, 3.0F);
  ShellPlacement shell(random, center, 10.0F, 20.0F);
  std::vector<Vec3> placed;
  for (int i = 0; i < 200; ++i) {
    placed.push_back(shell.place(1.0F));
    EXPECT_GE(glm::length(placed.back() - center), 9.999F);
    EXPECT_LE(glm::length(placed.back() - center), 20.001F);
  }
  for (std::size_t i = 0; i < placed.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) EXPECT_GT(glm::length(placed[i] - placed[k]), 1.999F);
  }
}

TEST(ShellPlacementTest, WidensWhenItIsFull) {
  Random random(5);
  ShellPlacement shell(random, Vec3(0.0F), 1.0F, 1.5F);
  float furthest = 0.0F;
  for (int i = 0; i < 50; ++i) furthest = std::max(furthest, glm::length(shell.place(1.0F)));
  EXPECT_GT(furthest, 1.5F);
}

}  // namespace
}  // namespace scatter
