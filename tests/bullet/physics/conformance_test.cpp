#include <scatter/bullet/bullet_physics.h>

#include "world/conformance/physics_conformance.h"

namespace scatter::test {

namespace {

std::vector<PhysicsFactory> factories() {
  return {{"Standard", WorldKind::kStandard, makeBulletPhysics},
          {"Hybrid", WorldKind::kHybrid, makeBulletPhysics}};
}

}  // namespace

INSTANTIATE_TEST_SUITE_P(Bullet, PhysicsConformance, testing::ValuesIn(factories()),
                         [](const auto& factory) { return factory.param.name; });

}  // namespace scatter::test
