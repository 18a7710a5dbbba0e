#pragma once

#include <scatter/world/fidelity.h>

class btCollisionWorld;

namespace scatter {

/// Of a world whose objects are all BulletBodies; those made from a LevelSet count in any kind of world.
[[nodiscard]] FidelitySample measureBulletFidelity(const btCollisionWorld& world);

}  // namespace scatter
