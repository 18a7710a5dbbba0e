#pragma once

#include <scatter/result.h>
#include <scatter/world/world.h>

namespace scatter {

/// A room of static boxes, thick enough that nothing passes through. Its floor is at height zero, its middle
/// at the origin.
struct RoomDef {
  float halfWidth = 10.0F;  ///< Inside, along x and z, metres.
  float height = 5.0F;
  bool ceiling = false;
};

/// Adds floor, walls and perhaps a ceiling, and sets Earth's gravity.
[[nodiscard]] Result<void> addRoom(World& world, const RoomDef& def);

}  // namespace scatter
