#include "io/gltf/notes.h"

#include <algorithm>
#include <array>
#include <utility>

namespace scatter::io {
namespace {

constexpr std::array<const char*, 3> kMotions{"static", "kinematic", "dynamic"};

constexpr double kMaxVector = 1e6;

float toFloat(double value) {
  return static_cast<float>(value);
}

std::optional<float> readMass(const JsonPlace& parent, const char* key) {
  const auto place = parent.find(key);
  return place ? std::optional(toFloat(place->number(kMinGltfMass, kMaxGltfMass))) : std::nullopt;
}

std::optional<std::size_t> readMaterial(const GltfFile& file, const JsonPlace& parent) {
  const auto place = parent.find("material");
  if (!place) {
    return std::nullopt;
  }
  const auto materials = file.root().find({"extensions", "KHR_physics_rigid_bodies", "physicsMaterials"});
  return place->index(materials ? materials->size() : 0, "material");
}

DocumentMotion readMotion(const JsonPlace& place) {
  const std::string name = place.text();
  for (std::size_t i = 0; i < kMotions.size(); ++i) {
    if (name == kMotions[i]) {
      return static_cast<DocumentMotion>(i);
    }
  }
  place.fail(R"(should be "static", "kinematic" or "dynamic")");
}

DocumentMassFrame readMassFrame(const JsonPlace& place) {
  DocumentMassFrame frame;
  frame.pose = readTransform(place);
  if (const auto inertia = place.find("inertia")) {
    const glm::dvec3 moments = inertia->vector(kMaxGltfInertia);
    if (std::min({moments.x, moments.y, moments.z}) < kMinGltfInertia) {
      inertia->fail("should be three positive numbers");
    }
    frame.inertia = Vec3(moments);
  }
  return frame;
}

std::vector<ShapeNotes> readShapes(const GltfFile& file, const JsonPlace& model) {
  std::vector<ShapeNotes> shapes;
  const auto list = model.find("shapes");
  for (std::size_t i = 0; list && i < list->size(); ++i) {
    const JsonPlace place = (*list)[i];
    shapes.push_back({readMaterial(file, place), readMass(place, "density"), readMass(place, "mass")});
  }
  return shapes;
}

ModelNotes readModel(const GltfFile& file, const GltfNodes& nodes, const JsonPlace& place) {
  ModelNotes model;
  model.name = place.at("name").text();
  model.motion = readMotion(place.at("motion"));
  model.mass = readMass(place, "mass");
  model.material = readMaterial(file, place);
  if (const auto frame = place.find("massFrame")) {
    model.massFrame = readMassFrame(*frame);
  }
  model.shapes = readShapes(file, place);
  if (const auto node = place.find("node")) {
    model.node = node->index(nodes.count(), "node");
  }
  return model;
}

DocumentField readField(const JsonPlace& place) {
  DocumentField field;
  field.name = place.at("name").text();
  field.center = Vec3(place.at("center").vector());
  field.acceleration = toFloat(place.at("acceleration").number(-kMaxVector, kMaxVector));
  field.radius = toFloat(place.at("radius").size(0.0));
  return field;
}

std::optional<Vec3> readVelocity(const JsonPlace& parent, const char* key) {
  const auto place = parent.find(key);
  return place ? std::optional(Vec3(place->vector(kMaxVector))) : std::nullopt;
}

std::optional<JsonPlace> findNotes(const JsonPlace& owner, const char* key) {
  // Extras may be anything; ours are objects.
  const auto extras = owner.find("extras");
  return extras && extras->isObject() ? extras->find(key) : std::nullopt;
}

}  // namespace

const char* nameOf(DocumentMotion motion) {
  return kMotions[static_cast<std::size_t>(motion)];
}

std::optional<SceneNotes> readSceneNotes(const GltfFile& file, const GltfNodes& nodes) {
  const auto place = nodes.scene() ? findNotes(*nodes.scene(), "scatter_scene") : std::nullopt;
  if (!place) {
    return std::nullopt;
  }
  SceneNotes notes;
  notes.gravity = Vec3(place->at("gravity").vector(kMaxVector));
  if (const auto step = place->find("timeStep")) {
    notes.timeStep = toFloat(step->number(1e-6, 1e3));
  }
  const auto fields = place->find("fields");
  for (std::size_t i = 0; fields && i < fields->size(); ++i) {
    notes.fields.push_back(readField((*fields)[i]));
  }
  const auto models = place->find("models");
  for (std::size_t i = 0; models && i < models->size(); ++i) {
    notes.models.push_back(readModel(file, nodes, (*models)[i]));
  }
  return notes;
}

std::optional<BodyNotes> readBodyNotes(const JsonPlace& node, std::size_t modelCount) {
  const auto place = findNotes(node, "scatter_body");
  if (!place) {
    return std::nullopt;
  }
  BodyNotes notes;
  // Without the scene's notes the body is of a model of its own.
  const auto model = place->find("model");
  notes.model = model && modelCount > 0 ? model->index(modelCount, "model") : 0;
  if (const auto motion = place->find("motion")) {
    notes.motion = readMotion(*motion);
  }
  notes.mass = readMass(*place, "mass");
  notes.linearVelocity = readVelocity(*place, "linearVelocity");
  notes.angularVelocity = readVelocity(*place, "angularVelocity");
  return notes;
}

std::optional<PlaneNotes> readPlaneNotes(const JsonPlace& node) {
  const auto place = findNotes(node, "scatter_plane");
  if (!place) {
    return std::nullopt;
  }
  PlaneNotes notes;
  notes.plane.normal = Vec3(place->at("normal").vector());
  notes.plane.offset = toFloat(place->at("offset").length());
  notes.pose = readTransform(*place);
  return notes;
}

}  // namespace scatter::io
