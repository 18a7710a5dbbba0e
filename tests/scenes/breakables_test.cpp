#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scenes/scene_world.h"
#include "scenes/worlds.h"
#include "trials.h"

namespace scatter::test {
namespace {

constexpr float kYard = 7.0F;
constexpr float kHeight = 10.0F;
/// Until all have fallen; under sanitizers until many have broken, as the gibs take most of the time.
constexpr int kBreakingFrames = kSanitized ? 80 : 240;

struct Census {
  std::size_t whole = 0;
  std::size_t gibs = 0;
  std::size_t primitives = 0;  ///< Parts of all hybrids at their finest level.
  double mass = 0.0;
};

Census count(const World& world) {
  Census census;
  for (const auto& object : world.objects()) {
    const auto* levels = std::get_if<std::shared_ptr<const LevelSet>>(&object->def().shape);
    if (levels == nullptr) continue;
    ++(object->name().find("-gib-") != std::string::npos ? census.gibs : census.whole);
    census.primitives += (*levels)->finest().parts.size();
    census.mass += static_cast<double>(object->def().mass);
  }
  return census;
}

class Breakables : public testing::TestWithParam<WorldCase> {};

TEST_P(Breakables, BreakIntoGibsThatWeighAsMuchAndStayInTheYard) {
  SceneWorld scene("breakables", GetParam().def);
  const Census start = count(scene.world);
  EXPECT_EQ(start.whole, 32U);
  EXPECT_EQ(start.primitives, 16U * 25U + 16U * 12U);
  for (int i = 0; i < kBreakingFrames; ++i) {
    scene.step();
    ASSERT_FALSE(scene.world.physics().findInvalidState()) << "frame " << i;
    ASSERT_EQ(objectsOutside(scene.world, kYard, kHeight, 0.6F), std::vector<std::string>{}) << "frame " << i;
  }
  if (!kSanitized) {
    EXPECT_EQ(objectsOutside(scene.world, kYard, kHeight), std::vector<std::string>{});
  }
  const Census end = count(scene.world);
  EXPECT_LT(end.whole, kSanitized ? 24U : 12U);
  EXPECT_GT(end.gibs, kSanitized ? 200U : 600U);
  EXPECT_GT(end.primitives, (kSanitized ? 1 : 2) * start.primitives);
  EXPECT_NEAR(end.mass, start.mass, 1e-4 * start.mass);
  EXPECT_EQ(scene.counters().hybrids, end.whole + end.gibs);
}

INSTANTIATE_TEST_SUITE_P(Worlds, Breakables, testing::ValuesIn(everyWorld()),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(BreakablesTest, NothingBreaksBeforeItHitsSomething) {
  SceneWorld scene("breakables");
  for (int i = 0; i < 15; ++i) {
    scene.step();
    EXPECT_EQ(count(scene.world).whole, 32U) << "frame " << i;
  }
}

TEST(BreakablesTest, BreakInTheSameWayInEveryRun) {
  SceneWorld first("breakables", everyWorld()[1].def);
  SceneWorld second("breakables", everyWorld()[1].def);
  for (int i = 0; i < (kSanitized ? 50 : 100); ++i) {
    first.step();
    second.step();
    ASSERT_EQ(first.world.physics().stateHash(), second.world.physics().stateHash()) << "frame " << i;
  }
  EXPECT_GT(count(first.world).gibs, kSanitized ? 100U : 300U);
}

}  // namespace
}  // namespace scatter::test
