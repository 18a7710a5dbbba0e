#pragma once

#include <btBulletDynamicsCommon.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "../../trials.h"

namespace scatter::test {

/// The seeds of programs that do at random what a program may: so many as usual, or as SCATTER_RANDOM_USES
/// says, from SCATTER_RANDOM_USE on.
inline std::vector<std::uint64_t> programs(int usual) {
  return seedsOr("SCATTER_RANDOM_USES", "SCATTER_RANDOM_USE", usual);
}

/// Bodies of such a program are drawn together, so that they meet.
inline void drawTogether(const std::vector<std::unique_ptr<btRigidBody>>& bodies) {
  for (const auto& body : bodies)
    body->applyCentralForce(-8 * body->getWorldTransform().getOrigin() / (body->getInvMass() + 0.1F));
}

}  // namespace scatter::test
