#pragma once

#include <scatter/io/physics_document.h>

#include <pugixml.hpp>

namespace scatter::io {

/// The `<library_geometries>` of a document: the meshes that are shown or are shapes, and the hulls.
void writeGeometries(pugi::xml_node& root, const PhysicsDocument& document);

void writeMaterials(pugi::xml_node& root, const PhysicsDocument& document);

/// The `<library_physics_models>`: one with one rigid body for each model, and one with all constraints.
void writePhysicsModels(pugi::xml_node& root, const PhysicsDocument& document);

}  // namespace scatter::io
