#pragma once

#include <scatter/world/physics.h>

#include <memory>

namespace scatter {

/// Physics on Bullet: btDiscreteDynamicsWorld for a standard world, btHybridDynamicsWorld for a hybrid
/// one. During step() it takes Bullet's global contact-added callback and, with profiling on, its profile
/// hooks, and puts back what was there: only one such world may step at a time in a process.
///
/// Boxes, spheres, capsules, cylinders and planes have their exact size. Convex hulls get a margin around
/// them: their LevelSet's, else 2 cm.
[[nodiscard]] std::unique_ptr<Physics> makeBulletPhysics(const PhysicsDef& def);

}  // namespace scatter
