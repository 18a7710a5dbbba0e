#include "io/gltf/models.h"

#include <scatter/levels/mass_properties.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <type_traits>
#include <utility>

namespace scatter::io {
namespace {

/// Water's; the draft leaves the mass of a body without "mass" to the program.
constexpr float kStandardDensity = 1000.0F;

template <class Value>
void append(std::string& key, const Value& value) {
  static_assert(std::is_arithmetic_v<Value>);
  key.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void append(std::string& key, const GltfPlacement& placement) {
  for (int i = 0; i < 3; ++i) {
    append(key, placement.position[i]);
    append(key, placement.rotation[i]);
    for (int j = 0; j < 3; ++j) {
      append(key, placement.stretch[i][j]);
    }
  }
  append(key, placement.rotation[3]);
}

/// What a body is made of, as a text that is equal for bodies that are made of the same.
std::string geometryKey(const GltfBody& body) {
  std::string key;
  append(key, body.colliders.size());
  for (const GltfCollider& collider : body.colliders) {
    append(key, collider.implicit);
    append(key, collider.source);
    append(key, collider.hull);
    append(key, collider.material.value_or(static_cast<std::size_t>(-1)));
    append(key, collider.placement);
  }
  for (const GltfVisual& visual : body.visuals) {
    append(key, visual.mesh);
    append(key, visual.placement);
  }
  return key;
}

std::string motionKey(const GltfBody& body) {
  std::string key;
  append(key, static_cast<int>(body.motion));
  append(key, body.mass.value_or(0.0F));
  if (body.massFrame) {
    const Transform& pose = body.massFrame->pose;
    for (int i = 0; i < 3; ++i) {
      append(key, pose.position[i]);
      append(key, pose.rotation[i]);
      append(key, body.massFrame->inertia.value_or(Vec3(0.0F))[i]);
    }
    append(key, pose.rotation[3]);
    append(key, body.hasCenter);
  }
  return key;
}

bool isSame(const std::optional<DocumentMassFrame>& a, const std::optional<DocumentMassFrame>& b) {
  return a.has_value() == b.has_value() &&
         (!a || (a->pose.position == b->pose.position && a->pose.rotation == b->pose.rotation &&
                 a->inertia == b->inertia));
}

std::vector<ConvexPart> convexParts(const DocumentModel& model) {
  std::vector<ConvexPart> parts;
  for (const DocumentShape& shape : model.shapes) {
    if (const auto* convex = std::get_if<ConvexShape>(&shape.geometry)) {
      parts.push_back({*convex, shape.pose});
    }
  }
  return parts;
}

std::optional<JsonPlace> findLevels(const JsonPlace& node) {
  const auto extras = node.find("extras");
  return extras && extras->isObject() ? extras->find("scatter_levels") : std::nullopt;
}

}  // namespace

double documentMass(const DocumentModel& model) {
  if (model.mass) {
    return static_cast<double>(*model.mass);
  }
  double sum = 0.0;
  for (const DocumentShape& shape : model.shapes) {
    const auto* convex = std::get_if<ConvexShape>(&shape.geometry);
    if (shape.mass) {
      sum += static_cast<double>(*shape.mass);
    } else if (shape.density && convex != nullptr) {
      const auto solid = massProperties({{*convex, shape.pose}});
      sum += solid ? static_cast<double>(solid->volume) * static_cast<double>(*shape.density) : 0.0;
    }
  }
  return sum > 0.0 ? sum : 1.0;
}

GltfModels::GltfModels(GltfFile& file, const GltfNodes& nodes, GltfMeshes& meshes,
                       const std::optional<SceneNotes>& notes)
    : file_(&file),
      nodes_(&nodes),
      meshes_(&meshes),
      notes_(&notes),
      colliders_(file, nodes, meshes),
      models_(notes ? notes->models.size() : 0) {}

bool GltfModels::fits(const GltfBody& body, const ModelNotes& notes) const {
  if (!notes.shapes.empty() && notes.shapes.size() != body.colliders.size()) {
    return false;
  }
  for (std::size_t i = 0; i < body.colliders.size(); ++i) {
    const auto own = notes.shapes.empty() ? std::nullopt : notes.shapes[i].material;
    if (body.colliders[i].material != (own ? own : notes.material)) {
      return false;
    }
  }
  return body.motion == DocumentMotion::kStatic || isSame(body.massFrame, notes.massFrame);
}

const BodyNotes* GltfModels::notesOf(const GltfBody& body) const {
  const bool known = body.notes && *notes_ && body.notes->model < (*notes_)->models.size() &&
                     fits(body, (*notes_)->models[body.notes->model]);
  return known ? &*body.notes : nullptr;
}

std::optional<std::size_t> GltfModels::modelOf(const GltfBody& body) {
  const JsonPlace node = nodes_->json(body.node);
  std::string key = geometryKey(body);
  if (const BodyNotes* noted = notesOf(body)) {
    std::optional<DocumentModel>& slot = models_[noted->model];
    append(key, noted->model);
    if (const auto same = known_.find(key); same != known_.end()) {
      return models_[same->second] ? std::optional(same->second) : std::nullopt;
    }
    if (!slot) {
      slot = build(body, &(**notes_).models[noted->model]);
      known_.emplace(std::move(key), noted->model);
      return slot ? std::optional(noted->model) : std::nullopt;
    }
  }
  if (body.notes && *notes_) {
    file_->warn(node, "is no longer like its model in \"scatter_scene\" and becomes a model of its own");
  }
  key = geometryKey(body) + motionKey(body) + (findLevels(node) ? std::to_string(body.node) : "");
  const auto [same, isNew] = known_.emplace(std::move(key), models_.size());
  if (isNew) {
    models_.push_back(build(body, nullptr));
  }
  return models_[same->second] ? std::optional(same->second) : std::nullopt;
}

std::optional<DocumentModel> GltfModels::build(const GltfBody& body, const ModelNotes* notes) {
  const JsonPlace node = nodes_->json(body.node);
  DocumentModel model;
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < body.colliders.size(); ++i) {
    if (auto shape = colliders_.shapeOf(body.colliders[i])) {
      model.shapes.push_back(std::move(*shape));
      used.push_back(i);
    }
  }
  if (model.shapes.empty()) {
    file_->warn(node, "has no collider that can be used; the body is left out");
    return std::nullopt;
  }
  for (const GltfVisual& visual : body.visuals) {
    meshes_->append(nodes_->json(visual.node).at("mesh"), visual.placement, model.mesh);
  }
  const auto name = node.find("name");
  model.name = notes != nullptr ? notes->name : name ? name->text() : "body " + std::to_string(body.node);
  if (notes != nullptr) {
    takeNotes(*notes, used, model);
  } else {
    takeValues(body, used, model);
  }
  addLevels(body, model);
  return model;
}

void GltfModels::takeNotes(const ModelNotes& notes, const std::vector<std::size_t>& used,
                           DocumentModel& model) const {
  model.motion = notes.motion;
  model.mass = notes.mass;
  model.massFrame = notes.massFrame;
  model.material = notes.material;
  for (std::size_t i = 0; i < used.size() && !notes.shapes.empty(); ++i) {
    const ShapeNotes& own = notes.shapes[used[i]];
    model.shapes[i].material = own.material;
    model.shapes[i].density = own.density;
    model.shapes[i].mass = own.mass;
  }
}

void GltfModels::takeValues(const GltfBody& body, const std::vector<std::size_t>& used,
                            DocumentModel& model) const {
  model.motion = body.motion;
  model.mass = body.mass;
  model.massFrame = body.massFrame;
  const auto& first = body.colliders[used.front()].material;
  const bool uniform = std::all_of(used.begin(), used.end(),
                                   [&](std::size_t i) { return body.colliders[i].material == first; });
  if (uniform) {
    model.material = first;
  }
  for (std::size_t i = 0; i < used.size(); ++i) {
    DocumentShape& shape = model.shapes[i];
    if (!uniform) {
      shape.material = body.colliders[used[i]].material;
    }
    if (body.motion == DocumentMotion::kDynamic && !body.mass &&
        std::holds_alternative<ConvexShape>(shape.geometry)) {
      shape.density = kStandardDensity;
    }
  }
  if (model.massFrame && !body.hasCenter) {
    const auto solid = massProperties(convexParts(model));
    model.massFrame->pose.position = solid ? solid->centerOfMass : Vec3(0.0F);
  }
}

void GltfModels::addLevels(const GltfBody& body, DocumentModel& model) {
  const auto levels = findLevels(nodes_->json(body.node));
  if (!levels) {
    return;
  }
  const std::vector<ConvexPart> finest = convexParts(model);
  if (finest.size() != model.shapes.size() || finest.size() != body.colliders.size()) {
    file_->warn(*levels, "not all colliders of the body are convex shapes; the levels are left out");
    return;
  }
  model.levels = readLevels(*file_, *levels, model.name, finest, (*nodes_)[body.node].world.stretch);
}

}  // namespace scatter::io
