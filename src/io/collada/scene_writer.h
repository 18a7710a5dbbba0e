#pragma once

#include <scatter/io/physics_document.h>

#include <pugixml.hpp>

namespace scatter::io {

void writeFields(pugi::xml_node& root, const PhysicsDocument& document);

/// The visual scene with a node for each body, the physics scene and `<scene>`.
void writeScenes(pugi::xml_node& root, const PhysicsDocument& document);

}  // namespace scatter::io
