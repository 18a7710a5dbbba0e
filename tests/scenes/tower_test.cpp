#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "scenes/scene_world.h"

namespace scatter::test {
namespace {

constexpr int kKnockFrame = 240;

TEST(Tower, StandsStillUntilOneBlockIsKnockedOutOfIt) {
  SceneWorld scene("tower");
  std::vector<Vec3> start;
  for (const auto& object : scene.world.objects()) start.push_back(object->state().pose.position);
  auto furthestMove = [&] {
    float furthest = 0.0F;
    for (std::size_t i = 0; i < start.size(); ++i) {
      furthest = std::max(furthest, glm::length(scene.world.objects()[i]->state().pose.position - start[i]));
    }
    return furthest;
  };
  for (int i = 0; i < kKnockFrame; ++i) scene.step();
  EXPECT_LT(furthestMove(), 0.03F) << "the joints between 12 layers settle by about 2 mm each, no more";
  for (int i = 0; i < 120; ++i) scene.step();
  EXPECT_GT(furthestMove(), 3.0F);
}

TEST(Tower, HasNoHybridsAndIsTheSameInBothWorlds) {
  SceneWorld standard("tower", WorldKind::kStandard);
  SceneWorld hybrid("tower", WorldKind::kHybrid);
  for (int i = 0; i < 600; ++i) {
    standard.step();
    hybrid.step();
    ASSERT_EQ(standard.world.physics().stateHash(), hybrid.world.physics().stateHash()) << "frame " << i;
  }
}

}  // namespace
}  // namespace scatter::test
