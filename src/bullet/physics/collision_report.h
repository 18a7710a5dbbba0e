#pragma once

#include <BulletHybrid/btHybridCollision.h>
#include <scatter/world/collision.h>

namespace scatter {

/// What the pair algorithm of BulletHybrid reports, in the words of Physics. All bodies are BulletBodies.
[[nodiscard]] ContactReport fromBullet(const btHybridContactReport& report);
[[nodiscard]] CollisionMemory fromBullet(const btHybridCollisionMemory& memory);

}  // namespace scatter
