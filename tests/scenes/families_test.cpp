#include "scenes/families.h"

#include <gmock/gmock.h>
#include <scatter/io/collada.h>
#include <scatter/io/file.h>
#include <scatter/io/scene_file.h>
#include <scatter/levels/level_check.h>

#include <map>
#include <set>

#include "io/temporary_folder.h"
#include "scenes/scene_world.h"
#include "scenes/worlds.h"
#include "trials.h"

namespace scatter::test {
namespace {

namespace fs = std::filesystem;

constexpr double kSmall = 0.02;

/// Every file below a folder.
std::map<std::string, std::string> contentsOf(const fs::path& folder) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    auto text = readFile(entry.path());
    EXPECT_TRUE(text) << text.error().message;
    contents.emplace(fs::relative(entry.path(), folder).string(), std::move(*text));
  }
  return contents;
}

/// What a family writes into a folder that is empty before.
std::map<std::string, std::string> written(const std::string& family, const FamilyOptions& options) {
  const TemporaryFolder folder;
  const auto scene = writeFamily(family, options, folder.path());
  EXPECT_TRUE(scene) << scene.error().message;
  return contentsOf(folder.path());
}

std::vector<std::string> familyNames() {
  std::vector<std::string> names;
  for (const FamilyInfo& family : sceneFamilies()) names.push_back(family.name);
  return names;
}

/// Those of every scene, and worlds whose pairs switch: all coarse, and within a budget.
std::vector<WorldCase> switchingWorlds() {
  std::vector<WorldCase> worlds = everyWorld();
  PhysicsDef def;
  def.world = WorldKind::kHybrid;
  def.switching.switching = Switching::kPair;
  def.switching.policy = Policy::kCoarsest;
  worlds.push_back({"coarsest pairs", def});
  def.switching.policy = Policy::kNone;
  def.switching.budget.units = 500.0;
  worlds.push_back({"a budget", def});
  return worlds;
}

TEST(Families, AreSeveralWithASummaryEach) {
  std::set<std::string> names;
  for (const FamilyInfo& family : sceneFamilies()) {
    EXPECT_TRUE(names.insert(family.name).second) << family.name;
    EXPECT_FALSE(family.summary.empty()) << family.name;
  }
  EXPECT_GE(names.size(), 12U);
}

class EveryFamily : public testing::TestWithParam<std::string> {};

TEST_P(EveryFamily, HasTheSameBytesForTheSameSeedAlone) {
  const auto first = written(GetParam(), {.seed = 3, .scale = kSmall});
  EXPECT_EQ(first, written(GetParam(), {.seed = 3, .scale = kSmall}));
  auto other = written(GetParam(), {.seed = 4, .scale = kSmall});
  ASSERT_FALSE(other.empty());
  EXPECT_NE(first.begin()->second, other.begin()->second);
}

TEST_P(EveryFamily, HasModelsOfThreeLevelsThatAreNested) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeFamily(GetParam(), {.seed = 5, .scale = kSmall}, folder.path()));
  int models = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder.path())) {
    if (entry.path().extension() != ".dae") continue;
    const auto model = readCollada(entry.path());
    ASSERT_TRUE(model) << model.error().message;
    const LevelSet& levels = *model->levels;
    ASSERT_EQ(levels.count(), 3);
    const auto check =
        checkLevels({levels.level(1), levels.level(2), levels.level(3)}, levels.hullMargin(), nullptr);
    ASSERT_TRUE(check);
    EXPECT_TRUE(check->passed()) << entry.path();
    ++models;
  }
  EXPECT_GT(models, 0);
}

TEST_P(EveryFamily, StepsInEveryWorld) {
  const TemporaryFolder folder;
  for (const std::uint64_t seed : seeds(1, 2)) {
    const auto file = writeFamily(GetParam(), {.seed = seed, .scale = kSmall}, folder.path());
    ASSERT_TRUE(file) << file.error().message;
    for (const WorldCase& world : switchingWorlds()) {
      SceneWorld scene(file->string(), world.def, seed);
      EXPECT_GT(scene.world.objects().size(), 1U);
      scene.step();
      EXPECT_GT(scene.counters().hybrids, 0U);
      EXPECT_LT(scene.world.physics().maxPenetration(), 0.05) << "at the start in the world " << world.name;
      for (int i = 0; i < 20; ++i) scene.step();
      EXPECT_FALSE(scene.world.physics().findInvalidState());
    }
  }
}

TEST_P(EveryFamily, HasMoreBodiesAtALargerScale) {
  if (test::kSanitized) GTEST_SKIP() << "does the same at a smaller scale in other tests";
  const TemporaryFolder folder;
  const auto countOf = [&](double scale) {
    const auto file = writeFamily(GetParam(), {.seed = 1, .scale = scale}, folder.path());
    EXPECT_TRUE(file);
    return readSceneFile(*file).value().bodies.size();
  };
  EXPECT_GT(countOf(10.0 * kSmall), countOf(kSmall));
}

INSTANTIATE_TEST_SUITE_P(Families, EveryFamily, testing::ValuesIn(familyNames()),
                         [](const auto& instance) { return instance.param; });

TEST(Families, RefuseWhatTheyCannotMake) {
  const TemporaryFolder folder;
  EXPECT_THAT(writeFamily("shipz", {}, folder.path()).error().message, testing::HasSubstr("\"shipz\""));
  EXPECT_FALSE(writeFamily("quiet", {.scale = 0.0}, folder.path()));
  EXPECT_FALSE(writeFamily("quiet", {.scale = 11.0}, folder.path()));
  EXPECT_FALSE(writeFamily("quiet", {.seed = 9'000'000'000'000'001}, folder.path()));
  EXPECT_THAT(contentsOf(folder.path()), testing::IsEmpty());
  EXPECT_FALSE(writeFamily("quiet", {.scale = kSmall}, folder.path() / "nowhere"));
}

}  // namespace
}  // namespace scatter::test
