#pragma once

#include <scatter/io/physics_document.h>

#include <nlohmann/json_fwd.hpp>

namespace scatter::io {

/// Parts of a glTF file that is written; gltf_notes.h reads them.

/// "scatter_scene".
[[nodiscard]] nlohmann::json sceneNotes(const PhysicsDocument& document);

/// The extras of a body's node: "scatter_body".
[[nodiscard]] nlohmann::json bodyNotes(const PhysicsDocument& document, const DocumentBody& body);

/// "scatter_levels" of a model that has levels.
[[nodiscard]] nlohmann::json levelNotes(const DocumentModel& model);

/// The motion object of a body that is not static. `modelMass` in kilograms.
[[nodiscard]] nlohmann::json motionOf(const PhysicsDocument& document, const DocumentBody& body,
                                      double modelMass);

/// The joint description object: the limits of each axis.
[[nodiscard]] nlohmann::json limitsOf(const DocumentJoint& joint);

}  // namespace scatter::io
