#pragma once

#include "io/collada/frame.h"

#include <scatter/levels/level_set.h>

namespace scatter::io {

/// The `<levels>` element in the `<extra><technique profile="SCATTER">` of a rigid body; none if it has none.
[[nodiscard]] pugi::xml_node findLevels(const pugi::xml_node& body);

/// The levels of a rigid body: the coarser ones in `levels`, which may be none, and the shapes in its
/// `<technique_common>` as the finest. The error about levels that are not nested names the body.
[[nodiscard]] Result<std::shared_ptr<const LevelSet>> readLevels(const ColladaFrame& frame,
                                                                 const pugi::xml_node& body,
                                                                 const std::string& name);

/// The child of that name in the `<extra><technique profile="SCATTER">` of an element.
[[nodiscard]] pugi::xml_node scatterChild(const pugi::xml_node& parent, const char* name);

}  // namespace scatter::io
