#pragma once

#include <scatter/bullet/bullet_physics.h>
#include <scatter/lab/run.h>

#include <memory>
#include <string>

namespace scatter::test {

/// A scene in a Bullet world that is called as its kind is.
inline RunOptions bulletWorld(const std::string& scene, WorldKind kind = WorldKind::kHybrid) {
  RunOptions options;
  options.scene = scene;
  options.engine = [](const PhysicsDef& def) -> Result<std::unique_ptr<Physics>> {
    return makeBulletPhysics(def);
  };
  options.physics.world = kind;
  options.label = kind == WorldKind::kHybrid ? "hybrid" : "standard";
  return options;
}

}  // namespace scatter::test
