#include <gtest/gtest.h>
#include <scatter/world/scene.h>

namespace scatter {

namespace {

class EmptyScene final : public Scene {
 public:
  Result<void> build(World&, const SceneOptions&) override { return {}; }
};

SceneInfo named(const char* name) {
  SceneInfo info;
  info.name = name;
  info.make = [] { return std::make_unique<EmptyScene>(); };
  return info;
}

std::string errorOf(const SceneRegistry& registry, const char* name) {
  const auto found = registry.find(name);
  return found ? "no error" : found.error().message;
}

const SceneRegistration kRegistered{named("registered before main")};

}  // namespace

TEST(SceneRegistry, ListsScenesByName) {
  SceneRegistry registry;
  for (const char* name : {"fleet", "armada", "tower"}) registry.add(named(name));
  ASSERT_EQ(registry.all().size(), 3U);
  EXPECT_EQ(registry.all()[0]->name, "armada");
  EXPECT_EQ(registry.all()[1]->name, "fleet");
  EXPECT_EQ(registry.all()[2]->name, "tower");
}

TEST(SceneRegistry, FindsAScene) {
  SceneRegistry registry;
  registry.add(named("fleet"));
  const auto found = registry.find("fleet");
  ASSERT_TRUE(found);
  EXPECT_EQ((*found)->name, "fleet");
  EXPECT_NE((*found)->make(), nullptr);
}

TEST(SceneRegistry, UnknownNameGetsTheNearestAndTheList) {
  SceneRegistry registry;
  for (const char* name : {"fleet", "armada", "tower", "duel"}) registry.add(named(name));
  const std::string list = "Known scenes: armada, duel, fleet, tower";
  EXPECT_EQ(errorOf(registry, "flete"), "unknown scene \"flete\"; did you mean \"fleet\"? " + list);
  EXPECT_EQ(errorOf(registry, "powers"), "unknown scene \"powers\"; did you mean \"tower\"? " + list);
  EXPECT_EQ(errorOf(registry, "dual"), "unknown scene \"dual\"; did you mean \"duel\"? " + list);
  EXPECT_EQ(errorOf(registry, ""), "unknown scene \"\"; known scenes: armada, duel, fleet, tower");
}

TEST(SceneRegistry, EmptyOneSaysSo) {
  EXPECT_EQ(errorOf(SceneRegistry{}, "fleet"), "unknown scene \"fleet\": this program has no scenes");
}

TEST(SceneRegistry, RegistrationAddsToTheProgramsScenes) {
  EXPECT_TRUE(SceneRegistry::instance().find("registered before main"));
}

}  // namespace scatter
