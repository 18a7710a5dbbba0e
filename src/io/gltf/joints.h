#pragma once

#include <scatter/io/physics_document.h>

#include <optional>
#include <vector>

#include "io/gltf/bodies.h"

namespace scatter::io {

/// The joints of a file, in the order of their nodes. `bodyOfNode` has the document's body for the node of
/// each rigid body. Throws GltfFailure.
[[nodiscard]] std::vector<DocumentJoint> readJoints(
    GltfFile& file, const GltfNodes& nodes, const GltfBodies& bodies,
    const std::vector<std::optional<std::size_t>>& bodyOfNode);

}  // namespace scatter::io
