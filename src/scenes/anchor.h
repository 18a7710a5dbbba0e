#pragma once

#include <scatter/result.h>
#include <scatter/world/world.h>

namespace scatter {

/// A static body that collides with nothing, to which joints tie what they hold to the world.
[[nodiscard]] Result<WorldObject*> addAnchor(World& world);

}  // namespace scatter
