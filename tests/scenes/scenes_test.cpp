#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "scenes/scene_world.h"

namespace scatter::test {
namespace {

TEST(Scenes, AllOfThemAreRegisteredWithASummary) {
  std::set<std::string> names;
  for (const auto& info : SceneRegistry::instance().all()) {
    names.insert(info->name);
    EXPECT_FALSE(info->summary.empty()) << info->name;
    EXPECT_GT(info->frames, 0) << info->name;
  }
  EXPECT_THAT(names, testing::IsSupersetOf({"armada", "breakables", "convergence", "duel", "fleet",
                                            "fleet_boxes", "mugs", "pile", "quiet_apart", "quiet_hybrids",
                                            "quiet_stacks", "telekinesis", "tower"}));
}

struct SceneCase {
  const char* name;
  std::size_t objects;
  std::uint32_t hybrids;
  bool seeded;
};

class EveryScene : public testing::TestWithParam<SceneCase> {};

TEST_P(EveryScene, HasItsObjectsAndStartsFreeOfDeepContact) {
  SceneWorld scene(GetParam().name);
  EXPECT_EQ(scene.world.objects().size(), GetParam().objects);
  scene.step();
  EXPECT_EQ(scene.counters().objects, GetParam().objects);
  EXPECT_EQ(scene.counters().hybrids, GetParam().hybrids);
  EXPECT_LT(scene.world.physics().maxPenetration(), 0.01);
}

TEST_P(EveryScene, IsTheSameForTheSameSeedInBothWorlds) {
  for (const WorldKind kind : {WorldKind::kStandard, WorldKind::kHybrid}) {
    SceneWorld first(GetParam().name, kind);
    SceneWorld second(GetParam().name, kind);
    SceneWorld other(GetParam().name, kind, 2);
    for (int i = 0; i < 5; ++i) {
      first.step();
      second.step();
      other.step();
      ASSERT_EQ(first.world.physics().stateHash(), second.world.physics().stateHash()) << "frame " << i;
    }
    EXPECT_EQ(first.world.physics().stateHash() != other.world.physics().stateHash(), GetParam().seeded);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, EveryScene,
    testing::Values(SceneCase{"duel", 2, 2, false}, SceneCase{"tower", 37, 0, false},
                    SceneCase{"convergence", 31, 20, true}, SceneCase{"fleet", 300, 200, true},
                    SceneCase{"fleet_boxes", 300, 200, true}, SceneCase{"armada", 1500, 1000, true},
                    SceneCase{"pile", 1005, 1000, true}, SceneCase{"quiet_apart", 300, 300, true},
                    SceneCase{"quiet_stacks", 505, 4, true}, SceneCase{"quiet_hybrids", 301, 300, true},
                    SceneCase{"telekinesis", 163, 156, true}, SceneCase{"breakables", 37, 32, true},
                    SceneCase{"mugs", 9, 4, true}),
    [](const auto& instance) { return std::string(instance.param.name); });

struct SwarmOutcome {
  std::uint32_t peakManifolds = 0;
  std::uint32_t coarser = 0;
  std::vector<std::uint64_t> hashes;
};

SwarmOutcome runConvergence(WorldKind kind, int frames) {
  SceneWorld scene("convergence", kind);
  SwarmOutcome outcome;
  for (int i = 0; i < frames; ++i) {
    scene.step();
    outcome.peakManifolds = std::max(outcome.peakManifolds, scene.counters().manifolds);
    outcome.coarser += scene.counters().switchesCoarser;
    outcome.hashes.push_back(scene.world.physics().stateHash());
    EXPECT_FALSE(scene.world.physics().findInvalidState());
  }
  return outcome;
}

TEST(Convergence, OverloadsTheStandardWorldAndTheHybridWorldTakesMostOfItAway) {
  const SwarmOutcome standard = runConvergence(WorldKind::kStandard, 700);
  const SwarmOutcome hybrid = runConvergence(WorldKind::kHybrid, 700);
  EXPECT_EQ(standard.coarser, 0U);
  EXPECT_GE(hybrid.coarser, 20U);
  EXPECT_GT(standard.peakManifolds, 150U);
  EXPECT_LT(hybrid.peakManifolds, standard.peakManifolds / 2);
}

TEST(Convergence, GivesTheSameHashInEveryFrameOfEveryRun) {
  for (const WorldKind kind : {WorldKind::kStandard, WorldKind::kHybrid}) {
    EXPECT_EQ(runConvergence(kind, 500).hashes, runConvergence(kind, 500).hashes);
  }
}

TEST(Convergence, TheSunReachesTheCentreAtTheEnd) {
  SceneWorld scene("convergence");
  WorldObject* sun = scene.world.find("sun");
  ASSERT_NE(sun, nullptr);
  const float start = glm::length(sun->state().pose.position);
  for (int i = 0; i < 400; ++i) scene.step();
  EXPECT_NEAR(glm::length(sun->state().pose.position), start * 0.75F, start * 0.01F);
}

}  // namespace
}  // namespace scatter::test
