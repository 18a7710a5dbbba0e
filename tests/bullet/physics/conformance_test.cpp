#include <scatter/bullet/bullet_physics.h>

#include "world/conformance/physics_conformance.h"

namespace scatter::test {

namespace {

std::unique_ptr<Physics> makeWithBodySwitching(PhysicsDef def) {
  def.switching.switching = Switching::kBody;
  def.switching.policy = Policy::kProximity;
  return makeBulletPhysics(def);
}

std::vector<PhysicsFactory> factories() {
  return {{"Standard", WorldKind::kStandard, makeBulletPhysics},
          {"Hybrid", WorldKind::kHybrid, makeBulletPhysics},
          {"HybridByBodies", WorldKind::kHybrid, makeWithBodySwitching}};
}

}  // namespace

INSTANTIATE_TEST_SUITE_P(Bullet, PhysicsConformance, testing::ValuesIn(factories()),
                         [](const auto& factory) { return factory.param.name; });

}  // namespace scatter::test
