#pragma once

#include "io/collada/frame.h"

#include <scatter/io/physics_document.h>

#include <functional>
#include <optional>

namespace scatter::io {

/// What an attachment of a constraint is fixed to.
struct Anchor {
  std::optional<std::size_t> body{};
  Transform pose{};  ///< In the world, if it is no body.
};

/// Finds the anchor of a `<ref_attachment>` or `<attachment>`; none, and a note, if it is not to be found.
using FindAnchor = std::function<Result<std::optional<Anchor>>(const pugi::xml_node& attachment)>;

/// A `<rigid_constraint>`. Nothing, and a note, if it joins nothing that moves.
[[nodiscard]] Result<std::optional<DocumentJoint>> readJoint(const ColladaFrame& frame,
                                                             const pugi::xml_node& constraint,
                                                             const FindAnchor& findAnchor);

}  // namespace scatter::io
