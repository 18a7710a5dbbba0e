#pragma once

#include <gtest/gtest.h>
#include <scatter/bullet/bullet_physics.h>
#include <scatter/io/scene_file.h>

#include <glm/geometric.hpp>
#include <memory>
#include <string>

#include "scenes/file_scene.h"

namespace scatter::test {

[[nodiscard]] inline float distance(const Vec3& a, const Vec3& b) {
  return glm::length(a - b);
}

/// A scene file's text in a world of its own.
class FileWorld {
 public:
  explicit FileWorld(const std::string& toml, std::uint64_t seed = 1)
      : file(std::make_shared<const SceneFile>(parse(toml))),
        scene_(file),
        world(makeBulletPhysics(define())) {
    auto built = scene_.build(world, SceneOptions{seed});
    EXPECT_TRUE(built) << built.error().message;
  }

  void step(int steps = 1) {
    for (int i = 0; i < steps; ++i) {
      scene_.update(world);
      world.step(1.0F / 60.0F);
    }
  }

  /// Takes a body out as somebody else than the scene does.
  void remove(const char* name) {
    WorldObject& object = (*this)[name];
    scene_.forget(object);
    world.remove(object);
  }

  /// A body that exists.
  [[nodiscard]] WorldObject& operator[](const char* name) const {
    WorldObject* object = world.find(name);
    EXPECT_NE(object, nullptr) << name;
    return *object;
  }
  [[nodiscard]] bool has(const char* name) const { return world.find(name) != nullptr; }
  [[nodiscard]] BodyState state(const char* name) const { return (*this)[name].state(); }

  /// The error of building the text in a world, or "".
  [[nodiscard]] static std::string errorOf(const std::string& toml) {
    FileScene scene(std::make_shared<const SceneFile>(parse(toml)));
    World world(makeBulletPhysics({}));
    const auto built = scene.build(world, {});
    return built ? "" : built.error().message;
  }

  std::shared_ptr<const SceneFile> file;

 private:
  static SceneFile parse(const std::string& toml) { return parseSceneFile(toml, "test.toml").value(); }
  [[nodiscard]] PhysicsDef define() const {
    PhysicsDef def;
    scene_.configure(def);
    return def;
  }

  FileScene scene_;

 public:
  World world;
};

}  // namespace scatter::test
