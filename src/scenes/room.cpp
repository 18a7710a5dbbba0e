#include "scenes/room.h"

#include <string>

#include "scenes/ground.h"

namespace scatter {

Result<void> addRoom(World& world, const RoomDef& def) {
  constexpr float kHalf = 1.0F;  // of a wall's thickness
  world.physics().setGravity(Vec3(0.0F, -9.81F, 0.0F));
  const float out = def.halfWidth + kHalf;
  const float outermost = out + kHalf;
  // The walls reach down into the floor, or what is pressed into the floor slides out below them.
  const float middle = 0.5F * def.height - kHalf;
  const float halfHeight = 0.5F * def.height + kHalf;
  const Vec3 slab(outermost, kHalf, outermost);
  if (auto added = addWall(world, "floor", {0.0F, -kHalf, 0.0F}, slab); !added) return added;
  for (const float side : {-1.0F, 1.0F}) {
    const std::string end = side < 0.0F ? "-1" : "-2";
    const Vec3 alongX(outermost, halfHeight, kHalf);
    const Vec3 alongZ(kHalf, halfHeight, def.halfWidth);
    if (auto added = addWall(world, "wall-z" + end, {0.0F, middle, side * out}, alongX); !added) return added;
    if (auto added = addWall(world, "wall-x" + end, {side * out, middle, 0.0F}, alongZ); !added) return added;
  }
  if (!def.ceiling) return {};
  return addWall(world, "ceiling", {0.0F, def.height + kHalf, 0.0F}, slab);
}

}  // namespace scatter
