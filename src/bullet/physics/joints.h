#pragma once

#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>
#include <scatter/world/joint.h>

#include <memory>

#include "bullet/physics/body.h"

namespace scatter {

/// Bullet's constraint for a valid `def`. The bodies must outlive it.
[[nodiscard]] std::unique_ptr<btTypedConstraint> makeConstraint(const JointDef& def, BulletBody& a,
                                                                BulletBody& b);

}  // namespace scatter
