#include "io/collada/materials.h"

#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace scatter::io {

Result<ColladaMaterials> ColladaMaterials::read(const ColladaFrame& frame) {
  ColladaMaterials result(frame);
  for (const pugi::xml_node& library : frame.xml().root().children("library_physics_materials")) {
    for (const pugi::xml_node& material : library.children("physics_material")) {
      if (const auto added = result.add(material); !added) {
        return tl::unexpected(added.error());
      }
    }
  }
  return result;
}

Result<std::size_t> ColladaMaterials::add(const pugi::xml_node& material) {
  const auto known = index_.find(material.hash_value());
  if (known != index_.end()) {
    return known->second;
  }
  const pugi::xml_node common = material.child("technique_common");
  frame_->noteUnknown(material, {"technique_common"});
  frame_->noteUnknown(common, {"dynamic_friction", "static_friction", "restitution"});
  const auto dynamic = frame_->scalar(common.child("dynamic_friction"), 0.0, 1e3);
  const auto fixed = frame_->scalar(common.child("static_friction"), 0.0, 1e3);
  const auto restitution = frame_->scalar(common.child("restitution"), 0.0, 1.0);
  if (!dynamic || !fixed) {
    return tl::unexpected(dynamic ? fixed.error() : dynamic.error());
  }
  if (!restitution) {
    return tl::unexpected(restitution.error());
  }
  DocumentMaterial result;
  const std::string_view name = material.attribute("name").value();
  result.name = name.empty() ? material.attribute("id").value() : name;
  result.dynamicFriction = dynamic->value_or(fixed->value_or(result.dynamicFriction));
  result.staticFriction = fixed->value_or(result.dynamicFriction);
  result.restitution = restitution->value_or(result.restitution);
  materials_.push_back(std::move(result));
  index_.emplace(material.hash_value(), materials_.size() - 1);
  return materials_.size() - 1;
}

Result<std::optional<std::size_t>> ColladaMaterials::find(const pugi::xml_node& parent) {
  pugi::xml_node material = parent.child("physics_material");
  if (const pugi::xml_node instance = parent.child("instance_physics_material")) {
    const auto found =
        frame_->followOrMend(instance, "url", "physics_material", "the default material is taken");
    if (!found) {
      return tl::unexpected(found.error());
    }
    material = *found;
  }
  if (!material) {
    return std::nullopt;
  }
  return add(material).map([](std::size_t index) { return std::optional(index); });
}

}  // namespace scatter::io
