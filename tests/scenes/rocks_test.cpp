#include "scenes/rocks.h"

#include <gtest/gtest.h>
#include <scatter/bullet/bullet_physics.h>

#include <algorithm>
#include <cmath>

#include "trials.h"

namespace scatter::test {
namespace {

TEST(Rocks, HaveEightHullsInOneBoxAndStayWithinTheirRadius) {
  Random random(3);
  const auto rocks = makeRocks(20, random);
  ASSERT_TRUE(rocks) << rocks.error().message;
  for (const auto& rock : *rocks) {
    EXPECT_EQ(rock->count(), 2);
    EXPECT_EQ(rock->coarsest().parts.size(), 1U);
    ASSERT_EQ(rock->finest().parts.size(), 8U);
    for (const ConvexPart& part : rock->finest().parts) {
      const auto& hull = std::get<ConvexHull>(part.shape);
      EXPECT_EQ(hull.vertices.size(), 8U);
      for (const Vec3& vertex : hull.vertices) {
        EXPECT_LE(glm::length(vertex) + rock->hullMargin(), kRockRadius);
      }
    }
  }
  EXPECT_NE((*rocks)[0]->mass().volume, (*rocks)[1]->mass().volume);
}

TEST(Heap, StaysBetweenItsWallsAndComesToRestWithoutSleep) {
  if (kSanitized) GTEST_SKIP() << "heaps are stepped in other tests";
  World world(makeBulletPhysics(PhysicsDef{}));
  Random random(1);
  const auto added = addHeap(world, {.rocks = 60, .columns = 4}, random);
  ASSERT_TRUE(added) << added.error().message;
  constexpr int kSecond = 60;
  for (int i = 0; i < 9 * kSecond; ++i) world.step(1.0F / kSecond);
  double energy = 0.0;
  for (int i = 0; i < kSecond; ++i) {
    world.step(1.0F / kSecond);
    energy += world.physics().kineticEnergy() / kSecond;
  }
  double mass = 0.0;
  for (const auto& object : world.objects()) {
    if (object->def().motion != Motion::kDynamic) continue;
    const BodyState state = object->state();
    const Vec3 at = state.pose.position;
    EXPECT_LT(std::max(std::abs(at.x), std::abs(at.z)), 2.2F) << object->name();
    EXPECT_GT(at.y, 0.2F) << object->name();
    // Sixty rocks that each take up a cubic metre at most, in a pit 4.4 m wide.
    EXPECT_LT(at.y, 4.0F) << object->name();
    EXPECT_FALSE(state.asleep) << object->name();
    mass += static_cast<double>(object->def().mass);
  }
  // Awake rocks tremble: a third of what gravity adds in one step, 9.81 / 60 / 3 m/s.
  EXPECT_LT(std::sqrt(2.0 * energy / mass), 0.055);
}

}  // namespace
}  // namespace scatter::test
