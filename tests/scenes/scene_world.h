#pragma once

#include <gtest/gtest.h>
#include <scatter/bullet/bullet_physics.h>
#include <scatter/world/scene.h>

#include <memory>
#include <string>

namespace scatter::test {

/// A registered scene in a world of its own.
class SceneWorld {
 public:
  explicit SceneWorld(const std::string& name, WorldKind kind = WorldKind::kStandard, std::uint64_t seed = 1)
      : SceneWorld(name, definition(kind), seed) {}

  SceneWorld(const std::string& name, const PhysicsDef& def, std::uint64_t seed = 1)
      : world(makeBulletPhysics(def)) {
    auto info = SceneRegistry::instance().find(name);
    EXPECT_TRUE(info) << info.error().message;
    scene_ = (*info)->make();
    auto built = scene_->build(world, SceneOptions{seed});
    EXPECT_TRUE(built) << built.error().message;
  }

  /// What the scene does before a step.
  void update() { scene_->update(world); }

  void step() {
    update();
    world.step(1.0F / 60.0F);
  }

  /// Takes an object out as somebody else than the scene does.
  void remove(WorldObject& object) {
    scene_->forget(object);
    world.remove(object);
  }

  [[nodiscard]] const StepCounters& counters() const { return world.physics().counters(); }

  World world;

 private:
  static PhysicsDef definition(WorldKind kind) {
    PhysicsDef def;
    def.world = kind;
    def.switching.switching = Switching::kBody;
    def.switching.policy = Policy::kProximity;
    return def;
  }

  std::unique_ptr<Scene> scene_;
};

}  // namespace scatter::test
