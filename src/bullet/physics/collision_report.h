#pragma once

#include <BulletHybrid/btHybridCollision.h>
#include <scatter/world/collision.h>
#include <scatter/world/step_report.h>

namespace scatter {

/// What the pair algorithm of BulletHybrid reports, in the words of Physics. All bodies are BulletBodies.
void addCollisionCounts(const btHybridCollisionCounts& counts, StepCounters& counters);
[[nodiscard]] ContactReport fromBullet(const btHybridContactReport& report);
[[nodiscard]] CollisionMemory fromBullet(const btHybridCollisionMemory& memory);

}  // namespace scatter
