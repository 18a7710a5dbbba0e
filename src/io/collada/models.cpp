#include "io/collada/models.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "io/collada/check.h"
#include "io/collada/levels.h"
#include "io/collada/scaling.h"

namespace scatter::io {
namespace {

/// Whether an `<instance_rigid_body>` says more of its body than how it starts.
bool overridesModel(const pugi::xml_node& instance) {
  const pugi::xml_node common = instance.child("technique_common");
  for (const char* name :
       {"mass_frame", "inertia", "instance_physics_material", "physics_material", "shape"}) {
    if (common.child(name)) {
      return true;
    }
  }
  return false;
}

std::string keyOf(const pugi::xml_node& body, const BodyLook& look) {
  std::string key = std::to_string(body.hash_value());
  if (overridesModel(look.instance)) {
    key += '/' + std::to_string(look.instance.hash_value());
  }
  for (int axis = 0; axis < 3; ++axis) {
    key += ' ' + std::to_string(look.scale[axis]);
  }
  return key + ':' + visualKey(look.visuals);
}

}  // namespace

Result<ColladaModels> ColladaModels::read(const ColladaFrame& frame, ColladaMaterials& materials,
                                          ColladaVisuals& visuals) {
  ColladaModels result(frame, materials, visuals);
  for (const pugi::xml_node& library : frame.xml().root().children("library_physics_models")) {
    for (const pugi::xml_node& model : library.children("physics_model")) {
      for (const pugi::xml_node& body : model.children("rigid_body")) {
        auto read = readBody(frame, materials, body);
        if (!read) {
          return tl::unexpected(read.error());
        }
        if (*read) {
          if (const auto shown = result.readOwnMesh(body, **read); !shown) {
            return tl::unexpected(shown.error());
          }
          result.originals_[body.hash_value()] = {result.models_.size(), false};
          result.models_.push_back(std::move(**read));
          result.bodies_.push_back(body);
        }
      }
    }
  }
  return result;
}

Result<std::optional<std::size_t>> ColladaModels::find(const pugi::xml_node& body, const BodyLook& look) {
  const auto original = originals_.find(body.hash_value());
  if (original == originals_.end()) {
    return std::nullopt;
  }
  const std::string key = keyOf(body, look);
  if (const auto known = looks_.find(key); known != looks_.end()) {
    return known->second;
  }
  std::size_t index = original->second.index;
  if (std::exchange(original->second.used, true)) {
    auto again = readBody(*frame_, *materials_, body);
    if (!again) {
      return tl::unexpected(again.error());
    }
    index = models_.size();
    models_.push_back(std::move(**again));
  }
  looks_.emplace(key, index);
  DocumentModel& model = models_[index];
  const auto changed =
      override(look.instance, model).and_then([&] { return dress(look, model); }).and_then([&] {
        return scale(body, look.scale, model);
      });
  if (!changed) {
    return tl::unexpected(changed.error());
  }
  return index;
}

Result<void> ColladaModels::override(const pugi::xml_node& instance, DocumentModel& model) {
  if (!overridesModel(instance)) {
    return {};
  }
  const auto properties = readProperties(*frame_, *materials_, instance);
  auto shapes = readBodyShapes(*frame_, *materials_, instance.child("technique_common"));
  if (!properties || !shapes) {
    return tl::unexpected(properties ? shapes.error() : properties.error());
  }
  if (properties->massFrame) {
    model.massFrame = properties->massFrame;
  }
  if (properties->material) {
    model.material = properties->material;
  }
  if (!shapes->empty()) {
    model.shapes = std::move(*shapes);
    if (std::exchange(model.levels, nullptr)) {
      frame_->note(instance, "has shapes of its own; the levels of its <rigid_body> are left out");
    }
  }
  return {};
}

Result<void> ColladaModels::readOwnMesh(const pugi::xml_node& body, DocumentModel& model) {
  const pugi::xml_node link = scatterChild(body, "shown_mesh");
  if (!link) {
    return {};
  }
  const auto geometry = frame_->follow(link, "url", "geometry");
  if (!geometry) {
    return tl::unexpected(geometry.error());
  }
  return visuals_->read({{*geometry, {}}}).map([&](VisualMesh mesh) { model.mesh = std::move(mesh); });
}

Result<void> ColladaModels::dress(const BodyLook& look, DocumentModel& model) {
  if (look.visuals.empty()) {
    return {};
  }
  return visuals_->read(look.visuals).map([&](VisualMesh mesh) { model.mesh = std::move(mesh); });
}

Result<void> ColladaModels::scale(const pugi::xml_node& body, const Vec3& scale, DocumentModel& model) const {
  if (scale == Vec3(1.0F)) {
    return {};
  }
  if (!scaleShapes(model.shapes, scale)) {
    frame_->note(body, "its node scales it unequally; a convex hull is taken for its round shapes");
  }
  if (std::any_of(model.shapes.begin(), model.shapes.end(), [](const DocumentShape& shape) {
        return findShapeDefect(shape, kColladaBounds).has_value();
      })) {
    return frame_->xml().failAt(body, "its node scales it so that a shape gets too big or too small");
  }
  if (model.massFrame) {
    model.massFrame->pose.position *= scale;
    if (!(glm::length(model.massFrame->pose.position) <= static_cast<float>(ColladaFrame::kMaxLength))) {
      return frame_->xml().failAt(body, "its node scales it so that its mass gets too far away");
    }
    frame_->note(body, "its node scales it; the inertia is taken as it stands");
  }
  if (!model.levels) {
    return {};
  }
  const auto levels = scaleLevels(*model.levels, scale);
  model.levels = levels.value_or(nullptr);
  if (!levels) {
    frame_->note(body, "its node scales it; the levels are left out: " + levels.error().message);
  }
  return {};
}

}  // namespace scatter::io
