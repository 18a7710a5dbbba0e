#pragma once

#include <gtest/gtest.h>
#include <scatter/bullet/bullet_physics.h>
#include <scatter/lab/experiment.h>

#include <memory>
#include <string>
#include <utility>

namespace scatter::test {

/// A box of 1 m as level 1 around two smaller ones.
inline std::shared_ptr<const LevelSet> twoLevels() {
  const ConvexPart lower{Box{{0.45F, 0.2F, 0.45F}}, {Vec3(0.0F, -0.25F, 0.0F), kNoRotation}};
  const ConvexPart upper{Box{{0.45F, 0.2F, 0.45F}}, {Vec3(0.0F, 0.25F, 0.0F), kNoRotation}};
  const ConvexPart whole{Box{{0.5F, 0.5F, 0.5F}}, {}};
  auto levels = LevelSet::create({.name = "pair", .levels = {{{whole}}, {{lower, upper}}}, .mass = {}});
  EXPECT_TRUE(levels) << levels.error().message;
  return *levels;
}

/// Five hybrids "crate-1" to "crate-5" and a "plank", 3 m apart on the x axis; with gravity at rest on a
/// floor, else in empty space.
class PlayScene final : public Scene {
 public:
  explicit PlayScene(bool gravity) : gravity_(gravity) {}

  Result<void> build(World& world, const SceneOptions& /*options*/) override {
    if (gravity_) {
      world.physics().setGravity(Vec3(0.0F, -9.81F, 0.0F));
      BodyDef floor;
      floor.name = "floor";
      floor.shape = Plane{};
      floor.motion = Motion::kStatic;
      if (auto added = world.add(std::move(floor)); !added) return fail(added.error().message);
    }
    const auto levels = twoLevels();
    for (int i = 0; i < 5; ++i) {
      BodyDef crate;
      crate.name = "crate-" + std::to_string(i + 1);
      crate.shape = levels;
      crate.mass = 20.0F;
      crate.pose.position = Vec3(3.0F * static_cast<float>(i), 0.5F, 0.0F);
      if (auto added = world.add(std::move(crate)); !added) return fail(added.error().message);
    }
    BodyDef plank;
    plank.name = "plank";
    plank.shape = Box{{1.0F, 0.1F, 0.1F}};
    plank.mass = 4.0F;
    plank.pose.position = Vec3(-4.0F, 0.1F, 0.0F);
    if (auto added = world.add(std::move(plank)); !added) return fail(added.error().message);
    return {};
  }

 private:
  bool gravity_;
};

inline RunOptions playRun(WorldKind kind, bool gravity) {
  RunOptions options;
  options.scene = "play";
  options.makeScene = [gravity] { return std::make_unique<PlayScene>(gravity); };
  options.engine = [](const PhysicsDef& def) -> Result<std::unique_ptr<Physics>> {
    return makeBulletPhysics(def);
  };
  options.physics.world = kind;
  return options;
}

inline std::unique_ptr<Experiment> makeExperiment(const ExperimentDef& def) {
  auto experiment = Experiment::create(def);
  EXPECT_TRUE(experiment) << experiment.error().message;
  return std::move(*experiment);
}

inline std::unique_ptr<Experiment> play(WorldKind kind, bool gravity) {
  return makeExperiment({.run = playRun(kind, gravity)});
}

inline void run(Experiment& experiment, int frames) {
  for (int i = 0; i < frames; ++i) {
    const auto stepped = experiment.step();
    ASSERT_TRUE(stepped) << stepped.error().message;
  }
}

inline WorldObject& object(Experiment& experiment, const char* name) {
  WorldObject* found = experiment.world().find(name);
  EXPECT_NE(found, nullptr) << name;
  return *found;
}

}  // namespace scatter::test
