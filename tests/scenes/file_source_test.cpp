// Scenes that are files, found by the registry.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <scatter/bullet/bullet_physics.h>
#include <scatter/io/file.h>
#include <scatter/world/scene.h>

#include <algorithm>
#include <cstdlib>

#include "io/temporary_folder.h"

namespace scatter::test {
namespace {

constexpr const char* kBall =
    "scene = { summary = \"a ball\", frames = 77, seed = 5 }\nobject = [{ name = \"ball\", sphere = 1 }]\n";

TEST(FileSource, FindsASceneOfTheLibraryByName) {
  const auto info = SceneRegistry::instance().find("tower");
  ASSERT_TRUE(info) << info.error().message;
  EXPECT_EQ((*info)->name, "tower");
  EXPECT_EQ((*info)->frames, 900);
}

TEST(FileSource, FindsAnySceneFileByItsPath) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeFile(folder / "ball.toml", kBall));
  const auto info = SceneRegistry::instance().find((folder / "ball.toml").string());
  ASSERT_TRUE(info) << info.error().message;
  EXPECT_EQ((*info)->name, "ball");
  EXPECT_EQ((*info)->summary, "a ball");
  EXPECT_EQ((*info)->frames, 77);
  EXPECT_EQ((*info)->seed, 5U);
  World world(makeBulletPhysics({}));
  EXPECT_TRUE((*info)->make()->build(world, {}));
  EXPECT_NE(world.find("ball"), nullptr);
}

TEST(FileSource, ReadsAFileAnewEachTime) {
  const TemporaryFolder folder;
  const std::string path = (folder / "ball.toml").string();
  ASSERT_TRUE(writeFile(path, kBall));
  const auto before = SceneRegistry::instance().find(path);
  ASSERT_TRUE(writeFile(path, std::string(kBall) + "material = []\n" + "field = []\n"));
  ASSERT_TRUE(SceneRegistry::instance().find(path));
  ASSERT_TRUE(writeFile(path, "x"));
  EXPECT_FALSE(SceneRegistry::instance().find(path));
  EXPECT_EQ((*before)->frames, 77);
}

TEST(FileSource, SaysWhatIsWrongWithAPath) {
  const auto error = [](const char* name) {
    const auto info = SceneRegistry::instance().find(name);
    return info ? "" : info.error().message;
  };
  EXPECT_EQ(error("nowhere.toml"), "cannot read nowhere.toml: No such file or directory");
  EXPECT_THAT(error("nowhere.glb"), testing::HasSubstr("nowhere.glb"));
  EXPECT_THAT(error("nowhere.DAE"), testing::HasSubstr("nowhere.DAE"));
  EXPECT_THAT(error("some/thing"), testing::HasSubstr("no file that ends in .toml, .dae, .gltf or .glb"));
}

TEST(FileSource, ABrokenFileOfTheLibraryIsListedWithItsError) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeFile(folder / "broken.toml", "[scene]\nframes = 0\n"));
  ::setenv("SCATTER_SCENE_PATH", folder.path().c_str(), 1);
  const auto all = SceneRegistry::instance().all();
  const auto found =
      std::find_if(all.begin(), all.end(), [](const auto& info) { return info->name == "broken"; });
  const auto direct = SceneRegistry::instance().find("broken");
  ::unsetenv("SCATTER_SCENE_PATH");
  ASSERT_NE(found, all.end());
  EXPECT_THAT((*found)->summary, testing::HasSubstr("broken.toml:2: \"frames\" in [scene] must be from 1"));
  World world(makeBulletPhysics({}));
  EXPECT_FALSE((*found)->make()->build(world, {}));
  EXPECT_FALSE(direct);
}

/// The hash of all bodies' names and starts.
std::uint64_t hashOfStart(const char* name) {
  World world(makeBulletPhysics({}));
  EXPECT_TRUE((*SceneRegistry::instance().find(name))->make()->build(world, {.seed = 1}));
  std::uint64_t hash = 14695981039346656037U;
  const auto add = [&hash](const void* data, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) {
      hash = (hash ^ static_cast<const unsigned char*>(data)[i]) * 1099511628211U;
    }
  };
  for (const auto& object : world.objects()) {
    const BodyDef& def = object->def();
    add(def.name.data(), def.name.size());
    add(&def.mass, sizeof def.mass);
    add(&def.pose.position, sizeof def.pose.position);
    add(&def.pose.rotation, sizeof def.pose.rotation);
    add(&def.linearVelocity, sizeof def.linearVelocity);
    add(&def.angularVelocity, sizeof def.angularVelocity);
  }
  return hash;
}

TEST(FileScenes, StartBitForBitAsTheFiguresWereMeasured) {
  EXPECT_EQ(hashOfStart("duel"), 1056298394184931990U);
  EXPECT_EQ(hashOfStart("tower"), 3530858973732954216U);
  EXPECT_EQ(hashOfStart("convergence"), 1917413664344704060U);
  EXPECT_EQ(hashOfStart("fleet"), 14022834431475332183U);
  EXPECT_EQ(hashOfStart("fleet_boxes"), 486976846747204605U);
  EXPECT_EQ(hashOfStart("armada"), 18072105204942740540U);
  EXPECT_EQ(hashOfStart("quiet_apart"), 8393838779201964628U);
}

}  // namespace
}  // namespace scatter::test
