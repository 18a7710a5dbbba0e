#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "scenes/scene_world.h"

namespace scatter::test {
namespace {

constexpr int kQuietFrames = 300;

TEST(QuietApart, NothingEverTouches) {
  SceneWorld scene("quiet_apart");
  for (int i = 0; i < kQuietFrames; ++i) {
    scene.step();
    ASSERT_EQ(scene.counters().contacts, 0U) << "frame " << i;
  }
}

class QuietStacks : public testing::TestWithParam<const char*> {};

TEST_P(QuietStacks, StandStillAndAwake) {
  SceneWorld scene(GetParam());
  std::vector<Vec3> start;
  for (const auto& object : scene.world.objects()) start.push_back(object->state().pose.position);
  for (int i = 0; i < kQuietFrames; ++i) scene.step();
  float furthest = 0.0F;
  for (std::size_t i = 0; i < start.size(); ++i) {
    const WorldObject& object = *scene.world.objects()[i];
    if (object.name().rfind("block", 0) != 0) continue;
    furthest = std::max(furthest, glm::length(object.state().pose.position - start[i]));
    EXPECT_FALSE(object.state().asleep) << object.name();
  }
  // Stacks lean a little; a twentieth of a block is far from falling.
  EXPECT_LT(furthest, 0.05F);
}

INSTANTIATE_TEST_SUITE_P(Scenes, QuietStacks, testing::Values("quiet_stacks", "quiet_hybrids"),
                         [](const auto& instance) { return std::string(instance.param); });

TEST(QuietStacksTest, TheHybridsTouchNothingButTheGround) {
  SceneWorld scene("quiet_stacks", WorldKind::kHybrid);
  for (int i = 0; i < kQuietFrames; ++i) {
    scene.step();
    ASSERT_EQ(scene.counters().pairsWithHybrid, 4U) << "frame " << i;
  }
}

}  // namespace
}  // namespace scatter::test
