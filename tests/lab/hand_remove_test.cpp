// Scenes play on without what is deleted by hand.

#include "lab/play_scene.h"
#include "trials.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace scatter {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Frames before whose step objects are deleted: those in which a scene acts on what it has made.
std::set<std::uint64_t> removalFrames(const std::string& scene) {
  static const std::map<std::string, std::set<std::uint64_t>> kActs{
      {"breakables", {20, 30, 40}},     // urns and boxes hit one another, and the ground
      {"collapse", {180, 240}},         // a throw, and a break
      {"mugs", {36}},                   // the second batch
      {"telekinesis", {30, 150, 195}},  // everything is lifted, thrown, and pulled again
      {"tower", {240}},                 // a block is knocked out
  };
  std::set<std::uint64_t> frames{3};
  if (const auto acts = kActs.find(scene); acts != kActs.end()) {
    frames.insert(acts->second.begin(), acts->second.end());
  }
  return frames;
}

/// Leaves the first, which often is the ground. Returns the names of the deleted ones.
std::vector<std::string> removeEveryThird(Experiment& experiment) {
  std::vector<std::string> names;
  std::vector<BodyId> bodies;
  const auto objects = experiment.world().objects();
  for (std::size_t i = 1; i < objects.size(); i += 3) {
    bodies.push_back(objects[i]->body());
    names.push_back(objects[i]->name());
  }
  for (const BodyId body : bodies) {
    EXPECT_TRUE(experiment.hands().remove(body));
  }
  return names;
}

std::vector<std::string> sceneNames() {
  std::vector<std::string> names;
  for (const auto& info : SceneRegistry::instance().all()) {
    names.push_back(info->name);
  }
  return names;
}

class EveryScenePlayedByHand : public testing::TestWithParam<std::string> {};

TEST_P(EveryScenePlayedByHand, PlaysOnWithoutEveryThirdObject) {
  RunOptions options = test::playRun(WorldKind::kHybrid, false);
  options.scene = GetParam();
  options.makeScene = nullptr;
  options.physics.switching.budget.units = 400.0;
  const auto experiment = test::makeExperiment({.run = options});
  const std::set<std::uint64_t> removals = removalFrames(GetParam());
  std::vector<std::string> removed;
  // Under sanitizers for a second after the last of them: what is deleted is missed at once.
  const int mostFrames = test::kSanitized ? static_cast<int>(*removals.rbegin()) + 60 : 400;
  const int frames = std::min(experiment->options().frames, mostFrames);
  for (int i = 0; i < frames; ++i) {
    if (removals.contains(experiment->world().frame())) {
      const auto names = removeEveryThird(*experiment);
      removed.insert(removed.end(), names.begin(), names.end());
    }
    const auto stepped = experiment->step();
    ASSERT_TRUE(stepped) << stepped.error().message;
  }
  ASSERT_FALSE(removed.empty());
  for (const std::string& name : removed) {
    EXPECT_EQ(experiment->world().find(name), nullptr) << name;
    EXPECT_EQ(experiment->world().find(name + "-gib-1"), nullptr) << name << " broke though it was gone";
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScenePlayedByHand, testing::ValuesIn(sceneNames()),
                         [](const auto& test) { return test.param; });

/// Says what it is told to forget, and removes "left" itself in its second update.
class ForgetfulScene final : public Scene {
 public:
  explicit ForgetfulScene(std::vector<std::string>& forgotten) : forgotten_(forgotten) {}

  Result<void> build(World& world, const SceneOptions& /*options*/) override {
    world_ = &world;
    for (const char* name : {"left", "middle", "right"}) {
      BodyDef def;
      def.name = name;
      def.pose.position = Vec3(3.0F * static_cast<float>(world.objects().size()), 0.0F, 0.0F);
      if (auto added = world.add(std::move(def)); !added) return fail(added.error().message);
    }
    return {};
  }

  void update(World& world) override {
    if (world.frame() == 1) world.remove(*world.find("left"));
  }

  void forget(const WorldObject& object) override {
    EXPECT_EQ(world_->find(object.body()), &object) << "it is still there, in this scene's world";
    forgotten_.push_back(object.name());
  }

 private:
  std::vector<std::string>& forgotten_;
  World* world_ = nullptr;
};

TEST(Experiment, TellsItsSceneWhatTheHandsDeleteAndNothingElse) {
  std::vector<std::string> forgotten;
  std::vector<std::string> gone;
  ExperimentDef def{.run = test::playRun(WorldKind::kStandard, false)};
  def.run.makeScene = [&forgotten] { return std::make_unique<ForgetfulScene>(forgotten); };
  def.hands.onRemove = [&gone](WorldObject& item) { gone.push_back(item.name()); };
  const auto experiment = test::makeExperiment(def);
  test::run(*experiment, 2);
  EXPECT_EQ(experiment->world().find("left"), nullptr);
  EXPECT_THAT(forgotten, IsEmpty());
  ASSERT_TRUE(experiment->hands().remove(test::object(*experiment, "right").body()));
  EXPECT_THAT(forgotten, ElementsAre("right"));
  const HandScript script = experiment->hands().script();
  ASSERT_TRUE(experiment->restart());
  ASSERT_TRUE(experiment->hands().remove(test::object(*experiment, "middle").body()));
  EXPECT_THAT(forgotten, ElementsAre("right", "middle")) << "the scene of the new world";
  ASSERT_TRUE(experiment->restart(script));
  test::run(*experiment, 3);
  EXPECT_THAT(forgotten, ElementsAre("right", "middle", "right")) << "also from a script";
  EXPECT_EQ(gone, forgotten);
}

}  // namespace
}  // namespace scatter
