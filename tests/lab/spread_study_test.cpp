#include <scatter/lab/spread_study.h>

#include "lab/fake_physics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace scatter {
namespace {

using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::size_t indexOf(const std::string& name) {
  const auto& quantities = spreadQuantities();
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    if (quantities[i].name == name) {
      return i;
    }
  }
  ADD_FAILURE() << "no quantity " << name;
  return 0;
}

/// A world whose penetration is `base` in its first run and 0.1 deeper in every further one.
RunOptions deeperEveryTime(std::string label, double base) {
  RunOptions options = test::fakeRun(WorldKind::kStandard, 6);
  options.label = std::move(label);
  auto made = std::make_shared<int>(0);
  options.engine = [made, base](const PhysicsDef& def) -> Result<std::unique_ptr<Physics>> {
    const double penetration = base + 0.1 * (*made)++;
    return std::make_unique<test::FakePhysics>(def, test::FakeBehaviour{.penetration = penetration});
  };
  return options;
}

/// Four hybrids on the corners of a square whose half diagonal is the seed, and a body that does not count.
class Square final : public Scene {
 public:
  Result<void> build(World& world, const SceneOptions& options) override {
    const auto levels = LevelSet::create({.name = "cube",
                                          .levels = {Level{{{.shape = Box{Vec3(0.5F)}, .pose = {}}}},
                                                     Level{{{.shape = Box{Vec3(0.4F)}, .pose = {}}}}},
                                          .hullMargin = 0.02F,
                                          .mass = {}});
    EXPECT_TRUE(levels);
    const auto reach = static_cast<float>(options.seed);
    for (const Vec3 corner : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
      add(world, *levels, Vec3(100.0F, 0.0F, 0.0F) + reach * corner);
    }
    add(world, Box{}, Vec3(0.0F, 5000.0F, 0.0F));
    return {};
  }

 private:
  static void add(World& world, Shape shape, const Vec3& position) {
    BodyDef def;
    def.shape = std::move(shape);
    def.pose.position = position;
    EXPECT_TRUE(world.add(std::move(def)));
  }
};

TEST(StudySpread, GivesMedianAndExtremesOverTheSeeds) {
  const auto study = studySpread({.worlds = {deeperEveryTime("standard", 0.5),
                                             deeperEveryTime("finest", 0.55), deeperEveryTime("deep", 0.65)},
                                  .seeds = {1, 2, 3}});
  ASSERT_TRUE(study) << study.error().message;
  const std::size_t deepest = indexOf("deepest_penetration");
  const Spread& first = study->worlds[0].spreads[deepest];
  EXPECT_DOUBLE_EQ(first.min, 0.5);
  EXPECT_DOUBLE_EQ(first.median, 0.6);
  EXPECT_DOUBLE_EQ(first.max, 0.7);
  // 0.5 to 0.7 holds the median 0.65, but not 0.75.
  EXPECT_TRUE(study->isWithin(0, deepest));
  EXPECT_TRUE(study->isWithin(1, deepest));
  EXPECT_FALSE(study->isWithin(2, deepest));
  // The fake's energy is a third of the step: 6 / 3 at the end, which is the peak.
  EXPECT_DOUBLE_EQ(study->worlds[0].spreads[indexOf("kinetic_energy_end")].median, 7.0 / 6.0);
  EXPECT_DOUBLE_EQ(study->worlds[0].spreads[indexOf("kinetic_energy_peak")].median, 2.0);
}

TEST(StudySpread, MeasuresThePileOfTheHybridsAlone) {
  RunOptions options = test::fakeRun(WorldKind::kStandard, 2);
  options.makeScene = [] { return std::make_unique<Square>(); };
  const auto study = studySpread({.worlds = {options}, .seeds = {2, 8, 4}});
  ASSERT_TRUE(study) << study.error().message;
  const Spread& radius = study->worlds[0].spreads[indexOf("pile_radius")];
  EXPECT_NEAR(radius.min, 2.0, 1e-5);
  EXPECT_NEAR(radius.median, 4.0, 1e-5);
  EXPECT_NEAR(radius.max, 8.0, 1e-5);
  EXPECT_NEAR(study->worlds[0].spreads[indexOf("pile_median_distance")].median, 4.0, 1e-5);
}

TEST(StudySpread, CountsSeedsAboveAndBelow) {
  const auto study = studySpread(
      {.worlds = {deeperEveryTime("standard", 0.5), deeperEveryTime("deep", 0.65)}, .seeds = {1, 2, 3}});
  ASSERT_TRUE(study);
  EXPECT_EQ(study->aboveAndBelow(1, indexOf("penetration_end")), std::pair(3, 0));
  EXPECT_EQ(study->aboveAndBelow(1, indexOf("kinetic_energy_end")), std::pair(0, 0));
  EXPECT_EQ(study->aboveAndBelow(0, indexOf("deepest_penetration")), std::pair(0, 0));
}

TEST(StudySpread, TellsHowHighTheBodiesAreAndWhenTheySleep) {
  RunOptions options = test::fakeRun(WorldKind::kStandard, 4);
  options.makeScene = [] { return std::make_unique<Square>(); };
  const auto study = studySpread({.worlds = {options}, .seeds = {2}});
  ASSERT_TRUE(study) << study.error().message;
  // Four on the ground and one at 5000 m; none falls asleep.
  EXPECT_NEAR(study->worlds[0].spreads[indexOf("mean_height")].median, 1000.0, 1e-2);
  EXPECT_EQ(study->worlds[0].spreads[indexOf("asleep_from")].median, 5.0);
}

TEST(StudySpread, TakesTheSceneOfASeed) {
  std::vector<std::string> scenes;
  RunOptions options = test::fakeRun(WorldKind::kStandard, 1);
  const auto study = studySpread({.worlds = {options}, .seeds = {3, 5}, .sceneOf = [&](std::uint64_t seed) {
                                    scenes.push_back("no-such-scene-" + std::to_string(seed));
                                    return scenes.back();
                                  }});
  ASSERT_FALSE(study);
  EXPECT_THAT(study.error().message, HasSubstr("no-such-scene-3"));
  EXPECT_THAT(scenes, ElementsAre("no-such-scene-3"));
}

TEST(StudySpread, RunsTheWorldsOfASeedAfterOneAnother) {
  std::vector<std::string> order;
  int lastRun = -1;
  const auto study =
      studySpread({.worlds = {deeperEveryTime("a", 0.1), deeperEveryTime("b", 0.1)}, .seeds = {1, 2}},
                  [&](const CompareProgress& progress) {
                    EXPECT_EQ(progress.runs, 4);
                    if (progress.run != lastRun) {
                      order.push_back(progress.label);
                      lastRun = progress.run;
                    }
                  });
  ASSERT_TRUE(study);
  EXPECT_THAT(order, ElementsAre("a", "b", "a", "b"));
}

TEST(StudySpread, RefusesNoWorldsNoSeedsAndWhatARunRefuses) {
  EXPECT_FALSE(studySpread({.worlds = {}, .seeds = {1}}));
  EXPECT_FALSE(studySpread({.worlds = {deeperEveryTime("a", 0.1)}, .seeds = {}}));
  EXPECT_THAT(
      studySpread({.worlds = {test::fakeRun(WorldKind::kStandard, 5, {.invalidStep = 2})}, .seeds = {1}})
          .error()
          .message,
      HasSubstr("frame 2"));
}

TEST(FormatSpread, SaysThatNoSeedChangesAnything) {
  const auto textOf = [](const RunOptions& world, std::vector<std::uint64_t> seeds) {
    const auto study = studySpread({.worlds = {world}, .seeds = std::move(seeds)});
    return study ? formatSpread(*study) : study.error().message;
  };
  const RunOptions same = test::fakeRun(WorldKind::kStandard, 5);
  EXPECT_THAT(textOf(same, {3, 4}), HasSubstr("No seed"));
  EXPECT_THAT(textOf(same, {3}), Not(HasSubstr("No seed")));
  EXPECT_THAT(textOf(deeperEveryTime("deeper", 0.5), {3, 4}), Not(HasSubstr("No seed")));
}

TEST(FormatSpread, SaysWhatLiesWithinTheFirstWorldsExtremes) {
  const auto study = studySpread(
      {.worlds = {deeperEveryTime("standard", 0.5), deeperEveryTime("deep", 0.65)}, .seeds = {1, 2, 3}});
  ASSERT_TRUE(study);
  const std::string table = formatSpread(*study);
  EXPECT_THAT(table, HasSubstr("over 3 seeds"));
  EXPECT_THAT(table,
              ContainsRegex("deepest penetration, m +0.600 \\(0.500-0.700\\) +0.750 \\(0.650-0.850\\)"));
  EXPECT_THAT(table, ContainsRegex("deepest penetration, m +no, \\+3 -0"));
  EXPECT_THAT(table, ContainsRegex("kinetic energy, last 100, J +yes, \\+0 -0"));
  const std::string csv = spreadCsv(*study);
  EXPECT_THAT(csv, testing::StartsWith("world,seed,deepest_penetration,"));
  EXPECT_THAT(csv, ContainsRegex("\nstandard,1,0.5,0.5,"));
  EXPECT_THAT(csv, ContainsRegex("\ndeep,1,0.65,0.65,"));
}

}  // namespace
}  // namespace scatter
