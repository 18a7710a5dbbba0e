#pragma once

#include <scatter/levels/surface_mesh.h>
#include <scatter/math.h>
#include <scatter/world/body.h>

#include <string_view>

namespace scatter::recording {

/// What is drawn of a body: its mesh, or its finest shape, round ones as polytopes around them; of a plane a
/// large square. Empty if there is nothing to be seen.
[[nodiscard]] SurfaceMesh surfaceOf(const BodyDef& def);

/// What a body collides with; of one with levels, at that level, 1 the coarsest.
[[nodiscard]] SurfaceMesh collisionSurfaceOf(const BodyDef& def, int level);

/// What bodies with the same surface share; null of those that share none.
[[nodiscard]] const void* modelOf(const BodyDef& def);

/// The same for bodies whose names differ in their numbers alone; grey for what cannot move.
[[nodiscard]] Vec3 colorOf(const BodyDef& def);

}  // namespace scatter::recording
