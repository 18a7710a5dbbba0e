#include <scatter/io/file.h>
#include <scatter/io/scene_file.h>
#include <scatter/io/scene_library.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "io/temporary_folder.h"

namespace scatter {
namespace {

TEST(SceneLibrary, EverySceneFileIsSound) {
  const auto names = sceneFileNames();
  EXPECT_THAT(names,
              testing::IsSupersetOf({"armada", "convergence", "duel", "fleet", "fleet_boxes", "tower"}));
  for (const std::string& name : names) {
    const auto scene = findSceneFile(name).and_then(readSceneFile);
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_NE(scene->summary, "") << name;
  }
}

TEST(SceneLibrary, SuggestsTheNearestForAnUnknownName) {
  const auto file = findSceneFile("dual");
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().message, "unknown scene file \"dual\"; did you mean \"duel\"?");
  EXPECT_FALSE(findSceneFile("../scenes/duel"));
}

TEST(SceneLibrary, PrefersTheFoldersOfTheEnvironment) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeFile(folder / "duel.toml", "x"));
  ASSERT_TRUE(writeFile(folder / "mine.toml", "x"));
  ::setenv("SCATTER_SCENE_PATH", folder.path().c_str(), 1);
  EXPECT_EQ(findSceneFile("duel").value(), folder / "duel.toml");
  EXPECT_EQ(findSceneFile("mine").value(), folder / "mine.toml");
  ::unsetenv("SCATTER_SCENE_PATH");
  EXPECT_EQ(findSceneFile("duel").value().filename(), "duel.toml");
  EXPECT_FALSE(findSceneFile("mine"));
}

}  // namespace
}  // namespace scatter
