#pragma once

#include <scatter/io/physics_document.h>
#include <scatter/world/joint.h>

#include <cstddef>
#include <optional>
#include <vector>

#include "scenes/document_bodies.h"

namespace scatter {

/// A joint as a world takes it.
struct DocumentJointDef {
  JointKind kind{};
  std::optional<std::size_t> bodyA{};  ///< In PhysicsDocument::bodies; the world if absent.
  std::optional<std::size_t> bodyB{};
  Transform frame{};  ///< In the world.
  bool bodiesCollide = false;
};

/// Leaves out, with a warning, what is disabled and what ties no dynamic body.
[[nodiscard]] std::vector<DocumentJointDef> makeDocumentJoints(const PhysicsDocument& document,
                                                               DocumentWarnings& warnings);

}  // namespace scatter
