#pragma once

#include "io/collada/frame.h"

#include <scatter/io/physics_document.h>

#include <optional>
#include <set>

namespace scatter::io {

/// The field that an `<instance_force_field>` names, from its `<technique profile="SCATTER">`:
/// `<point><center>0 1 0</center><acceleration>9</acceleration><radius>50</radius></point>`. COLLADA itself
/// says nothing of what is in a field: of another profile, there is a note and no field. The hash value of
/// the
/// `<force_field>` is added to `used`.
[[nodiscard]] Result<std::optional<DocumentField>> readField(const ColladaFrame& frame,
                                                             const pugi::xml_node& instance,
                                                             std::set<std::size_t>& used);

}  // namespace scatter::io
