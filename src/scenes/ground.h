#pragma once

#include <scatter/result.h>
#include <scatter/world/world.h>

#include <string>

namespace scatter {

/// Earth's gravity and a static plane at height zero.
[[nodiscard]] Result<void> addGround(World& world);

/// A static box.
[[nodiscard]] Result<void> addWall(World& world, std::string name, const Vec3& center,
                                   const Vec3& halfExtents);

}  // namespace scatter
