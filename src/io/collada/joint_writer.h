#pragma once

#include <scatter/io/physics_document.h>

#include <pugixml.hpp>

namespace scatter::io {

/// The id of the `<physics_model>` that holds all constraints.
inline constexpr const char* kJointsId = "joints";

/// Adds that `<physics_model>` to the library, if there are joints.
void writeConstraints(pugi::xml_node& library, const PhysicsDocument& document);

}  // namespace scatter::io
