#include "scenes/ground.h"

#include <utility>

namespace scatter {

Result<void> addGround(World& world) {
  world.physics().setGravity(Vec3(0.0F, -9.81F, 0.0F));
  BodyDef ground;
  ground.name = "ground";
  ground.shape = Plane{};
  ground.motion = Motion::kStatic;
  if (auto added = world.add(std::move(ground)); !added) return fail(added.error().message);
  return {};
}

Result<void> addWall(World& world, std::string name, const Vec3& center, const Vec3& halfExtents) {
  BodyDef wall;
  wall.name = std::move(name);
  wall.shape = Box{halfExtents};
  wall.motion = Motion::kStatic;
  wall.pose.position = center;
  if (auto added = world.add(std::move(wall)); !added) return fail(added.error().message);
  return {};
}

}  // namespace scatter
