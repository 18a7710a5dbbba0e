#pragma once

#include <scatter/world/physics.h>

#include <memory>

namespace scatter {

/// Physics on Bullet: btDiscreteDynamicsWorld for a standard world, btHybridDynamicsWorld for a hybrid
/// one. With profiling on, Bullet's global profile hooks are taken during step(): only one such world may
/// step at a time in a process.
[[nodiscard]] std::unique_ptr<Physics> makeBulletPhysics(const PhysicsDef& def);

}  // namespace scatter
